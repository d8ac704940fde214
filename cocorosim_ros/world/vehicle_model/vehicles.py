"""The physical numbers of every robot, laid out for compiled loops."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from cocorosim_ros.foundation.arrays import Flags, Floats, Integers
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.effects import BASIC_EFFECTS, EFFECTS, LAWS
from cocorosim_ros.world.vehicle_model.columns import numbered

INERTIA_PARAMETERS = ("mass", "yaw_inertia")
GAINS = ("thrust_gain", "yaw_torque_gain", "buoyancy_gain")  # 1 where nobody has measured


class Vehicles(NamedTuple):
    """Physical numbers with leading axes (runs, robots)."""

    parameters: Floats  # (runs, robots, parameters) columns of PARAMETER_COLUMNS, SI units
    active: Integers  # (runs, robots) one bit per effect, in the order of EFFECTS
    actuator_wrench: Floats  # (runs, robots, actuators, 4) X, Y, Z, N per newton [1, 1, 1, m; body]
    actuator_limit: Floats  # (runs, robots, actuators, 2) force at command +1 and -1, both positive [N]
    is_pump: Flags  # (runs, robots, actuators) whether it changes the robot's volume
    actuator_curve: Floats  # (runs, robots, actuators, columns) see terms.curve; no columns where all are plain
    jets: Floats  # (runs, robots, pairs, JET_COLUMNS) see terms.jet; no pairs where no thruster has a diameter


class Surroundings(NamedTuple):
    """Where the robots swim."""

    flow: Floats  # velocity of the water, see water.flow; empty in still water
    lower: Floats  # (3,) lowest corner of the water [m; world]
    upper: Floats  # (3,) highest corner
    neighbours: Floats  # (runs, robots, NEIGHBOUR_SIZE) all robots, see terms.moment; (1, 0, ...) if nobody looks


class Body(NamedTuple):
    """One robot: its row of Vehicles, and what surrounds it."""

    parameters: Floats  # (parameters,)
    active: int
    actuator_wrench: Floats  # (actuators, 4)
    actuator_limit: Floats  # (actuators, 2)
    is_pump: Flags  # (actuators,)
    actuator_curve: Floats  # (actuators, columns) see terms.curve
    jets: Floats  # (pairs, JET_COLUMNS) see terms.jet
    flow: Floats  # velocity of the water, see water.flow; empty in still water
    lower: Floats  # (3,) [m; world]
    upper: Floats  # (3,) [m; world]
    neighbours: Floats  # (robots, NEIGHBOUR_SIZE) or (0, NEIGHBOUR_SIZE)
    own: int  # its own row among them


def parameter_names(effect: str) -> tuple[str, ...]:
    """The names of the columns of an effect of EFFECTS: its parameters, after the effect's name and a dot.

    Those of the basic effects stand for themselves.
    """
    prefix = "" if effect in BASIC_EFFECTS else f"{effect}."
    return tuple(f"{prefix}{parameter.name}" for parameter in EFFECTS[effect].parameters)


PARAMETER_COLUMNS: dict[str, int] = numbered(
    [*INERTIA_PARAMETERS, *GAINS, *(name for effect in EFFECTS for name in parameter_names(effect))]
)
"""Column of every parameter: inertia and gains first, then each effect's in the order of the table."""
MASS = PARAMETER_COLUMNS["mass"]  # kg
YAW_INERTIA = PARAMETER_COLUMNS["yaw_inertia"]  # kg m^2
THRUST_GAIN = PARAMETER_COLUMNS["thrust_gain"]  # of all thrusters where they push together
YAW_TORQUE_GAIN = PARAMETER_COLUMNS["yaw_torque_gain"]  # of all thrusters where they turn the robot instead
BUOYANCY_GAIN = PARAMETER_COLUMNS["buoyancy_gain"]  # of all pumps
PATCH_FORCE_COLUMNS = [
    PARAMETER_COLUMNS[name] for name in ("patch_force_x", "patch_force_y", "patch_force_z", "patch_moment")
]
EFFECT_BIT: dict[str, int] = {name: 1 << position for position, name in enumerate(EFFECTS)}
BASIC_COLUMNS = len(INERTIA_PARAMETERS) + len(GAINS) + sum(len(EFFECTS[name].parameters) for name in BASIC_EFFECTS)
"""So many columns, the first ones, are all that the basic effects know."""
BASIC_BITS: int = sum(EFFECT_BIT[name] for name in BASIC_EFFECTS)
LAW_BITS: int = sum(EFFECT_BIT[name] for name in LAWS)


def neutral_row() -> Floats:
    """(parameters,) the numbers of a robot without inertia and drag, whose actuators and effects are as nominal."""
    row = np.zeros(len(PARAMETER_COLUMNS))
    for name in GAINS:
        row[PARAMETER_COLUMNS[name]] = 1.0
    for name, effect in EFFECTS.items():
        for column, parameter in zip(parameter_names(name), effect.parameters, strict=True):
            row[PARAMETER_COLUMNS[column]] = parameter.neutral
    return row


@kernel
def body_of(vehicles: Vehicles, surroundings: Surroundings, run: int, robot: int) -> Body:
    """One robot of one run; the arrays are views."""
    looking = surroundings.neighbours.shape[1] > 0
    return Body(
        vehicles.parameters[run, robot],
        vehicles.active[run, robot],
        vehicles.actuator_wrench[run, robot],
        vehicles.actuator_limit[run, robot],
        vehicles.is_pump[run, robot],
        vehicles.actuator_curve[run, robot],
        vehicles.jets[run, robot],
        surroundings.flow,
        surroundings.lower,
        surroundings.upper,
        surroundings.neighbours[run if looking else 0],
        robot if looking else -1,
    )


@kernel
def as_runs(vehicles: Vehicles, runs: int, robots: int) -> Vehicles:
    """The same robots as so many runs of so many; the arrays, which have to be contiguous, are views."""
    actuators = vehicles.actuator_wrench.shape[2]
    return Vehicles(
        vehicles.parameters.reshape(runs, robots, vehicles.parameters.shape[2]),
        vehicles.active.reshape(runs, robots),
        vehicles.actuator_wrench.reshape(runs, robots, actuators, vehicles.actuator_wrench.shape[3]),
        vehicles.actuator_limit.reshape(runs, robots, actuators, vehicles.actuator_limit.shape[3]),
        vehicles.is_pump.reshape(runs, robots, actuators),
        vehicles.actuator_curve.reshape(runs, robots, actuators, vehicles.actuator_curve.shape[3]),
        vehicles.jets.reshape(runs, robots, vehicles.jets.shape[2], vehicles.jets.shape[3]),
    )
