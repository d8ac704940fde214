"""All instruments of all robots at one tick."""

from __future__ import annotations

from typing import Any, NamedTuple

from cocorosim_ros.foundation.arrays import Floats, Integers
from cocorosim_ros.foundation.compiling.kernel import allocating_kernel, kernel
from cocorosim_ros.foundation.compiling.stack import stack_array
from cocorosim_ros.foundation.compiling.stretch import Stretch, ends_of
from cocorosim_ros.foundation.compiling.tables import compile_lines
from cocorosim_ros.world.motion.dynamics import relative_velocity, state_rate
from cocorosim_ros.world.motion.surroundings import look_around
from cocorosim_ros.world.sensors import SENSORS
from cocorosim_ros.world.sensors.instruments import Instruments
from cocorosim_ros.world.sensors.readings import Readings
from cocorosim_ros.world.sensors.sight import Sight
from cocorosim_ros.world.state.state import STATE_SIZE
from cocorosim_ros.world.surroundings.lamps import Lamps
from cocorosim_ros.world.surroundings.neighbours import Neighbours
from cocorosim_ros.world.surroundings.tank import Tank
from cocorosim_ros.world.vehicle_model.vehicles import Surroundings, Vehicles, body_of


class Afloat(NamedTuple):
    """All that a measurement depends on beside the state and the numbers of the instruments."""

    vehicles: Vehicles
    tank: Tank
    flow: Floats  # velocity of the water, see water.flow
    neighbours: Neighbours
    cones: Floats  # of the blue-light sensors, see sensors.cones
    lamps: Lamps
    concentration: Floats  # (runs, robots) of the plume [kg/m^3]


class Around(NamedTuple):
    """What measurements depend on, and what of it the motion feels."""

    afloat: Afloat
    surroundings: Surroundings


class Shown(NamedTuple):
    """What is measured of all robots."""

    readings: Readings
    nearest: Integers  # (runs, robots, sensors) who is the nearest in each cone, -1 for nobody


def _measuring_lines() -> list[str]:
    """The body of a function by which all sensors measure one robot."""
    lines = []
    for number, (topic, sensor) in enumerate(SENSORS.items()):
        if sensor.measure is None:
            continue
        places = [f"readings.{field.name}[run, robot]" for field in sensor.fields]
        if sensor.fields[0].width is None:
            call = f"{places[0]} = measure_{topic}(sight)"
        else:
            call = f"measure_{topic}(sight, {', '.join(places)})"
        lines += [f"if sight.instruments.measured[robot, {number}]:", f"    {call}"]
    return lines


_MEASURING: dict[str, Any] = {f"measure_{topic}": sensor.measure for topic, sensor in SENSORS.items()}
_measure = compile_lines("_measure", "sight, readings, run, robot", _measuring_lines(), _MEASURING)


@allocating_kernel
def sense(
    state: Floats, time: float, afloat: Afloat, instruments: Instruments, shown: Shown, robots: Stretch | None
) -> None:
    """Measure `state` (runs, robots, columns) at `time` [s] with every instrument of some robots, into `shown`."""
    tank = afloat.tank
    surroundings = Surroundings(afloat.flow, tank.lower, tank.upper, look_around(state, afloat.vehicles))
    _sense_all(state, time, Around(afloat, surroundings), instruments, shown, robots)


@kernel
def _sense_all(
    state: Floats, time: float, around: Around, instruments: Instruments, shown: Shown, robots: Stretch | None
) -> None:
    afloat, surroundings = around
    readings, nearest = shown
    relative, rate, neighbours = stack_array(4), stack_array(STATE_SIZE), afloat.neighbours
    first, last = ends_of(robots, state.shape[1])
    for run in range(state.shape[0]):
        for robot in range(first, last):
            row = state[run, robot]
            body = body_of(afloat.vehicles, surroundings, run, robot)
            state_rate(row, time, body, rate)
            relative_velocity(row, time, body, relative)
            nearby = neighbours.who[run, robot, : neighbours.near[run, robot]]
            sight = Sight(
                state[run],
                robot,
                row,
                rate,
                relative,
                instruments,
                afloat.tank,
                afloat.lamps,
                afloat.cones,
                nearby,
                nearest[run, robot],
                afloat.concentration[run, robot],
            )
            _measure(sight, readings, run, robot)
