"""Commands of forces and torques on the whole vehicle, made into the forces of its thrusters by a map's own numbers."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.scenario.parts.allocation import check_rank, smallest_forces
from cocorosim_ros.scenario.reading.entry import Entry, listed
from cocorosim_ros.scenario.reading.quantity import read_quantity
from cocorosim_ros.wire.conversion.conversion_map import ColumnValue, CommandValue, FixedValue, MixedValue
from cocorosim_ros.wire.conversion.value_entries import ValueReader, limited

AXES: Mapping[str, tuple[str, str]] = {
    **dict.fromkeys(("force_x", "force_y", "force_z"), ("force", "pure number")),
    **dict.fromkeys(("torque_x", "torque_y", "torque_z"), ("torque", "length")),
}
"""Dimensions by axis: of its command, and of what one newton of a thruster gives of it."""
_LIMITS = ("forward", "reverse")


def allocated(entry: Entry, reader: ValueReader) -> dict[str, CommandValue]:
    """The commands of all thrusters of an allocation, by their names.

    Raises CocorosimError if the thrusters cannot give every axis by itself.
    """
    section = entry.section(("wrench", "thrusters"))
    wrench = section["wrench"].section((), AXES)
    if not wrench:
        raise section["wrench"].problem(f"names no axis; add one of {listed(AXES)}.")
    axes = {axis: reader.value(part, AXES[axis][0]) for axis, part in wrench.items()}
    thrusters = section["thrusters"].mapping()
    parts = {name: part.section((*_LIMITS[:1],), (*axes, *_LIMITS[1:])) for name, part in thrusters.items()}
    matrix = np.array([[_effect(part, axis) for part in parts.values()] for axis in axes])
    check_rank(matrix, list(axes), section["thrusters"])
    inverse = smallest_forces(matrix)
    return {name: _command(axes, inverse[row], part, thrusters[name]) for row, (name, part) in enumerate(parts.items())}


def _effect(thruster: Mapping[str, Entry], axis: str) -> float:
    """The share of an axis that one newton of a thruster gives: 1, or m."""
    return read_quantity(thruster[axis], AXES[axis][1]) if axis in thruster else 0.0


def _command(
    axes: Mapping[str, ColumnValue | FixedValue], weights: Floats, limits: Mapping[str, Entry], place: Entry
) -> CommandValue:
    mixed = MixedValue(tuple((float(weight), axis) for weight, axis in zip(weights, axes.values(), strict=True)))
    given = {name: limits[name] for name in _LIMITS if name in limits}
    return limited(mixed, given, "force", place)
