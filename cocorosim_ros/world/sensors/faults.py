"""What is wrong with the instruments of a swarm, and the readings that follow from it."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.angles import wrap_angle
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.stack import stack_array
from cocorosim_ros.foundation.compiling.tables import compile_lines
from cocorosim_ros.world.sensors import KINDS
from cocorosim_ros.world.sensors.errors import changes_of
from cocorosim_ros.world.sensors.readings import Readings
from cocorosim_ros.world.sensors.sensor_error import TAKEN
from cocorosim_ros.world.state.state import YAW
from cocorosim_ros.world.terms.motors import Motors

_TAKEN = dict(zip(TAKEN, ("row", f"row[{YAW}]", "water", "ground", "motors"), strict=True))


class Faults(NamedTuple):
    """What is wrong with the instruments, with the leading axis (robots,)."""

    error: Floats  # (robots, ERROR_COLUMNS), SI units
    latency: Floats  # (robots, LATE_TOPICS) [s]


def _lines() -> tuple[list[str], dict[str, Callable[..., Any]]]:
    """The body of a function that changes all numbers of one robot, and the functions that it calls."""
    lines: list[str] = []
    functions: dict[str, Callable[..., Any]] = {"wrap_angle": wrap_angle}
    for code, (name, kind) in enumerate(KINDS.items()):
        changes = changes_of(name)
        if kind.place is None or not changes:
            continue
        field, column = kind.place
        place = f"readings.{field}[run, robot{'' if column is None else f', {column}'}]"
        lines.append(f"truth = {place}")
        for number, (change, columns) in enumerate(changes):
            functions[f"shown_{code}_{number}"] = change.shown
            numbers = ", ".join((*(_TAKEN[each] for each in change.takes), *(f"own[{each}]" for each in columns)))
            lines.append(f"{place} = shown_{code}_{number}({place}, truth, time, {numbers})")
        if kind.angle:
            lines.append(f"{place} = wrap_angle({place})")
    return lines, functions


_GIVEN = "readings, run, robot, time, own, row, water, ground, motors"
_add_errors_of = compile_lines("_add_errors_of", _GIVEN, *_lines())


@kernel
def add_errors(time: float, error: Floats, state: Floats, motors: Motors, readings: Readings) -> None:
    """Change the readings of all robots at `time` [s], in `state`, by their errors (robots, ERROR_COLUMNS).

    motors: of all robots, each array with the leading axes (runs, robots).
    """
    water, ground = stack_array(4), stack_array(3)
    for run in range(readings.compass.shape[0]):
        for robot in range(error.shape[0]):
            for axis in range(4):
                water[axis] = readings.velocity[run, robot, axis]
            for axis in range(3):
                ground[axis] = readings.ground_velocity[run, robot, axis]
            own = Motors(motors.is_pump[run, robot], motors.curve[run, robot], motors.limit[run, robot])
            _add_errors_of(readings, run, robot, time, error[robot], state[run, robot], water, ground, own)
