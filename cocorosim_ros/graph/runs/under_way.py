"""How long messages between robots are under way."""

from __future__ import annotations

from cocorosim_ros.scenario.parts.corruption import longest_delay
from cocorosim_ros.scenario.scenario import Scenario
from cocorosim_ros.world.links.acoustic_channel import acoustic_channel


def longest_under_way(scenario: Scenario) -> int:
    """How many ticks any message between robots can be under way beyond the one that it always takes."""
    acoustic = scenario.acoustic
    by_sound = 0 if acoustic is None else acoustic_channel(acoustic, scenario.tick_ns).window
    return max(longest_delay(scenario.corruption), by_sound)
