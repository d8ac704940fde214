"""From commands to forces: limits, gains, and the effects that act on commands or delay the forces.

fraction -> effects on commands -> share of the limit, by the actuator's curve -> effects on thrust -> force -> effects
that respond late -> gains. A command holds for an
interval, of which the mean force is taken: so a delay shorter than a step is as right as one that is longer.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from cocorosim_ros.foundation.arrays import Flags, Floats
from cocorosim_ros.foundation.compiling.kernel import kernel, outlined_kernel
from cocorosim_ros.foundation.compiling.tables import compile_lines
from cocorosim_ros.world.state.interval import Interval
from cocorosim_ros.world.state.state import FOLLOWED, MEMORY_SIZE, RATE
from cocorosim_ros.world.terms.curve import is_thruster, thrust_share, turn_thrusts
from cocorosim_ros.world.terms.response import delayed, relaxed
from cocorosim_ros.world.vehicle_model.hooks import bits, calls, hooks
from cocorosim_ros.world.vehicle_model.vehicles import BUOYANCY_GAIN, LAW_BITS, THRUST_GAIN, YAW_TORQUE_GAIN, Body

PUMP_RATE_TIME = 0.5  # s, over which the rate of the pumps' force is taken; the time between commands of Lily
ACTUATION_BITS = bits("command") | bits("thrust") | bits("response") | LAW_BITS


class Fitting(NamedTuple):
    """The actuators of one robot as the effects see them."""

    is_pump: Flags  # (actuators,)
    curve: Floats  # (actuators, columns) see terms.curve
    lever: Floats  # (actuators,) yaw moment per newton [m]; positive for a right-hand thruster that pushes forwards
    limit: Floats  # (actuators, 2) force at command +1 and -1, both positive [N]


_change_commands = compile_lines(
    "change_commands",
    "fraction, fitting, time, parameters, active",
    calls(hooks("command"), "fraction, fitting, time, {parameters}"),
    hooks("command"),
)
_change_thrusts = compile_lines(
    "change_thrusts",
    "share, fitting, time, parameters, active",
    calls(hooks("thrust"), "share, fitting, time, {parameters}"),
    hooks("thrust"),
)
_respond = compile_lines(
    "respond",
    "force, memory, fitting, duration, parameters, active",
    calls(hooks("response"), "force, memory, fitting, duration, {parameters}"),
    hooks("response"),
)


@kernel
def admitted(fraction: float) -> float:
    """The command that an actuator follows: beyond -1..1 the limit, off for NaN."""
    if math.isnan(fraction):
        return 0.0
    return min(max(fraction, -1.0), 1.0)


@kernel
def _share(body: Body, actuator: int, fraction: float) -> float:
    """What an actuator delivers at a command, as a share of its limit."""
    return thrust_share(body.actuator_curve[actuator], fraction) if body.actuator_curve.shape[1] > 0 else fraction


@kernel
def _gain(body: Body, actuator: int) -> float:
    if body.is_pump[actuator]:
        of_pumps: float = body.parameters[BUOYANCY_GAIN]
        return of_pumps
    of_thrusters: float = body.parameters[THRUST_GAIN]
    return of_thrusters if is_thruster(body.is_pump, body.actuator_curve, actuator) else 1.0


@outlined_kernel
def _scale_turning(body: Body, force: Floats) -> None:
    """Give what turns the robot its own gain: of thrusters with levers b and forces F the part b (b F) / (b b)."""
    turning, levers = 0.0, 0.0
    for actuator in range(force.shape[0]):
        if not body.is_pump[actuator]:
            lever = body.actuator_wrench[actuator, 3]
            turning += lever * force[actuator]
            levers += lever * lever
    for actuator in range(force.shape[0] if levers > 0.0 else 0):
        if not body.is_pump[actuator]:
            more = (body.parameters[YAW_TORQUE_GAIN] / body.parameters[THRUST_GAIN] - 1.0) * turning / levers
            force[actuator] += more * body.actuator_wrench[actuator, 3]


@outlined_kernel
def _with_effects(command: Floats, memory: Floats, body: Body, interval: Interval, force: Floats) -> None:
    fitting = Fitting(body.is_pump, body.actuator_curve, body.actuator_wrench[:, 3], body.actuator_limit)
    middle = interval.begin + 0.5 * interval.length
    for actuator in range(force.shape[0]):
        force[actuator] = admitted(command[actuator])
    _change_commands(force, fitting, middle, body.parameters, body.active)
    for actuator in range(force.shape[0]):
        force[actuator] = _share(body, actuator, force[actuator])
    _change_thrusts(force, fitting, middle, body.parameters, body.active)
    for actuator in range(force.shape[0]):
        force[actuator] *= body.actuator_limit[actuator, 0 if force[actuator] >= 0.0 else 1]
    _respond(force, memory, fitting, interval.length, body.parameters, body.active)
    for actuator in range(force.shape[0]):
        force[actuator] *= _gain(body, actuator)


@outlined_kernel
def _follow(memory: Floats, duration: float, force: Floats) -> None:
    """Remember how fast the forces change: mean over the interval of (force - followed) / PUMP_RATE_TIME."""
    for actuator in range(force.shape[0]):
        at = MEMORY_SIZE * actuator
        lagging = force[actuator] - memory[at + FOLLOWED]
        memory[at + RATE] = delayed(0.0, lagging, duration, PUMP_RATE_TIME) / PUMP_RATE_TIME
        memory[at + FOLLOWED] = relaxed(force[actuator], memory[at + FOLLOWED], duration, PUMP_RATE_TIME)


@kernel
def actuate(command: Floats, memory: Floats, body: Body, interval: Interval, force: Floats) -> None:
    """Write the mean force (actuators,) [N] of each actuator over an interval; of a rudder it is the angle [rad].

    `command` (actuators,), fractions, holds for all of it; NaN is zero, what lies beyond -1..1 the limit. `memory`
    (MEMORY_SIZE * actuators,) is brought to the end of the interval. With length zero the force is that of the moment.
    """
    if body.active & ACTUATION_BITS == 0:
        for actuator in range(force.shape[0]):
            share = _share(body, actuator, admitted(command[actuator]))
            limit = body.actuator_limit[actuator, 0 if share >= 0.0 else 1]
            force[actuator] = share * limit * _gain(body, actuator)
    else:
        _with_effects(command, memory, body, interval, force)
    if body.actuator_curve.shape[1] > 0:
        turn_thrusts(body.actuator_curve, force)
    if body.parameters[YAW_TORQUE_GAIN] != body.parameters[THRUST_GAIN] and body.parameters[THRUST_GAIN] != 0.0:
        _scale_turning(body, force)
    if body.active & LAW_BITS != 0:
        _follow(memory, interval.length, force)
