"""Reports of actuators: a series for each of their quantities, as it was recorded."""

from __future__ import annotations

from dataclasses import dataclass

from cocorosim_ros.foundation.arrays import Floats


@dataclass(frozen=True)
class Feedback:
    """One quantity that an actuator reports: stamps (n,) [s], ascending, and values (n,) in its SI unit.

    quantity: a name in QUANTITIES. time counts from the start of the recording, as that of commands.
    """

    actuator: str
    quantity: str
    time: Floats
    value: Floats
