"""The curve of an error of a sensor: its reading less the truth, along what the error's own file names."""

from __future__ import annotations

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.sensors import KINDS
from cocorosim_ros.world.sensors.sensor_error import Change, SensorError
from cocorosim_ros.world.state.pressure import PASCAL_PER_METRE
from cocorosim_ros.world.state.state import HEAVE, STATE_SIZE, SURGE
from cocorosim_ros.world.terms.motors import Motors
from site_builder.axes import Axis, axis_of
from site_builder.circumstances import Circumstances, cruising
from site_builder.curves import Curve, examples, neutrals
from site_builder.lily import lily
from site_builder.plain_python import plain


def error_curve(error: SensorError) -> Curve | None:
    """The largest of the changes that an error makes to readings; None where it makes none."""
    axis = axis_of(error.against.strip("|"), error.numbers, amount=error.against.startswith("|"))
    curves = [_curve(error, change, axis) for change in error.changes]
    return max(curves, key=lambda curve: float(np.abs(curve.with_it).max()), default=None)


def wrong_by(error: SensorError, change: Change, numbers: Floats, now: Circumstances) -> float:
    """Reading less truth, in the unit of the reading, for the numbers (numbers,) of the error."""
    named = {number.name: value for number, value in zip(error.numbers, numbers, strict=True)}
    still = np.zeros(STATE_SIZE)
    kind = KINDS[change.kind]
    weight = (PASCAL_PER_METRE,) if kind.by_weight else ()
    truth = plain(kind.foresee)((now.t, 0.0, 0.0, 0.0), now.row, (still, still), now.relative, *weight)
    robot = lily()
    there = {
        "row": now.row,
        "heading": now.yaw,
        "water": now.relative,
        "ground": now.row[SURGE : HEAVE + 1],
        "motors": Motors(robot.is_pump, robot.curve, robot.limit),
    }
    taken = [there[name] for name in change.takes]
    own = [float(named[name]) for name in change.numbers]
    return float(plain(change.shown)(truth, truth, now.t, *taken, *own) - truth)


def _curve(error: SensorError, change: Change, axis: Axis) -> Curve:
    moments = [cruising(**{axis.name: float(value)}) for value in axis.values]
    with_it, without = (
        np.array([wrong_by(error, change, numbers, now) for now in moments])
        for numbers in (examples(error), neutrals(error))
    )
    kind = KINDS[change.kind]
    words = error.sensor if kind.column == error.sensor else f"{error.sensor} ({kind.column})"
    caption = f"Reading of {words} less the truth, over {axis.meaning}"
    return Curve(axis, "error", kind.unit, caption, with_it, without)
