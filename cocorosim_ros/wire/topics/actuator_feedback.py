"""What actuators may report of themselves on `actuator_feedback`: each quantity with its dimension and unit."""

from __future__ import annotations

from typing import NamedTuple

FEEDBACK = "actuator_feedback"
FRACTION = "fraction"
BETWEEN = "."


class Quantity(NamedTuple):
    """A quantity that actuators report, by its dimension and its SI unit."""

    dimension: str
    unit: str


QUANTITIES: dict[str, Quantity] = {
    FRACTION: Quantity("pure number", "1"),  # of the actuator's maximum, as commanded
    "rotation": Quantity("angular velocity", "rad/s"),
    "angle": Quantity("angle", "rad"),
    "current": Quantity("electric current", "A"),
    "voltage": Quantity("voltage", "V"),
}

OF_COMMAND = (FRACTION, "angle")
"""Quantities with the size and the sign of the command; others may tell its amount alone."""


class Reported(NamedTuple):
    """One number of a message: the actuator that reports, and the quantity, empty where the name has none known."""

    actuator: str
    quantity: str


def feedback_name(actuator: str, quantity: str) -> str:
    """The name of a number in the messages: ("left", "rotation") is left.rotation."""
    return f"{actuator}{BETWEEN}{quantity}"


def reported(name: str) -> Reported:
    """Actuator and quantity of a name in the messages; a name without a known quantity is an actuator's alone."""
    actuator, _, quantity = name.rpartition(BETWEEN)
    return Reported(actuator, quantity) if actuator and quantity in QUANTITIES else Reported(name, "")
