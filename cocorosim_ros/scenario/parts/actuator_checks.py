"""Whether the actuators of a platform fit together, beyond what each says alone."""

from __future__ import annotations

from collections.abc import Sequence

from cocorosim_ros.scenario.parts.thrust_curve import check_ends
from cocorosim_ros.scenario.parts.vehicle_parts import Actuator, Thruster
from cocorosim_ros.scenario.reading.entry import Entry


def check_actuators(section: Entry, actuators: Sequence[Actuator]) -> None:
    """Nothing, if all are in order; section: their list in the file. Raises CocorosimError otherwise."""
    for entry, actuator in zip(section.items(), actuators, strict=True):
        if isinstance(actuator, Thruster) and actuator.curve is not None:
            check_ends(entry, actuator.curve, actuator.maximum, actuator.reverse)
