"""How long messages between robots are under way, and what of it a node graph cannot keep."""

from __future__ import annotations

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.parts.corruption import longest_delay
from cocorosim_ros.scenario.scenario import Scenario
from cocorosim_ros.world.links.acoustic_channel import acoustic_channel


def longest_under_way(scenario: Scenario) -> int:
    """How many ticks any message between robots can be under way beyond the one that it always takes."""
    acoustic = scenario.acoustic
    by_sound = 0 if acoustic is None else acoustic_channel(acoustic, scenario.tick_ns).window
    return max(longest_delay(scenario.corruption), by_sound)


def check_latency(scenario: Scenario) -> None:
    """Nothing, if messages between robots take a tick; raises CocorosimError otherwise."""
    if scenario.radio.latency == "none":
        raise CocorosimError(
            f"{scenario.origin}: 'radio.latency' has 'none', which nodes cannot keep: a command that depends on what "
            "others say at the same tick needs two rounds of messages; use --in-process, or write 'one_tick'."
        )
