"""What of the latency of messages between robots a node graph cannot keep."""

from __future__ import annotations

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.scenario import Scenario


def check_latency(scenario: Scenario) -> None:
    """Nothing, if messages between robots take a tick; raises CocorosimError otherwise."""
    if scenario.radio.latency == "none":
        raise CocorosimError(
            f"{scenario.origin}: 'radio.latency' has 'none', which nodes cannot keep: a command that depends on what "
            "others say at the same tick needs two rounds of messages; use --in-process, or write 'one_tick'."
        )
