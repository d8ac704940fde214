"""Newton and Euler for a vehicle that neither pitches nor rolls: M nu_dot + C(nu) nu = tau.

In body axes: m (u_dot - v r) = X, m (v_dot + u r) = Y, m w_dot = Z, I r_dot = N; the pose follows by
x_dot = u cos(psi) - v sin(psi), y_dot = u sin(psi) + v cos(psi), z_dot = w, psi_dot = r. Where the centre of mass is
not the origin, these are coupled (effects.offset_centre).
Source: Fossen, Handbook of Marine Craft Hydrodynamics and Motion Control (2021), chapters 2 and 3, with the
axes of REP 103.

Velocities of the state are over ground. Water that moves acts through the velocity relative to it, which the effects
get; so no term for turning or changing currents is needed here, as it is where the state is the relative velocity.
Assumes: the pressure gradient that accelerates curved or unsteady flow does not push the hull. Added mass is an effect
(effects.added_mass); without it none is there.
"""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.angles import sine_cosine
from cocorosim_ros.foundation.compiling.kernel import kernel, outlined_kernel
from cocorosim_ros.foundation.compiling.stack import stack_array, stack_like
from cocorosim_ros.foundation.compiling.tables import compile_lines
from cocorosim_ros.world.effects import BASIC_EFFECTS, CATALOGUE_EFFECTS, OF_ACTUATORS
from cocorosim_ros.world.state.state import HEAVE, STATE_SIZE, SURGE, SWAY, YAW, YAW_RATE, X, Y, Z
from cocorosim_ros.world.terms.moment import Moment, add_thrust, clearance, pump_force
from cocorosim_ros.world.vehicle_model.hooks import bits, calls, hooks
from cocorosim_ros.world.vehicle_model.vehicles import EFFECT_BIT, MASS, PARAMETER_COLUMNS, YAW_INERTIA, Body
from cocorosim_ros.world.water.flow import add_water_velocity

_BASIC = hooks("wrench", BASIC_EFFECTS)
_CATALOGUE = hooks("wrench", {**CATALOGUE_EFFECTS, **OF_ACTUATORS})
_CATALOGUE_BITS = sum(EFFECT_BIT[name] for name in _CATALOGUE)
_INERTIA_BITS = bits("inertia")
COUPLING_BITS = bits("centre")
"""Of effects under which a force along one axis accelerates others too."""
_WATER_BITS = bits("water")
_ADVANCE_LOSS = PARAMETER_COLUMNS["advance_loss.slope"]
_DRAG, _YAW_DRAG = PARAMETER_COLUMNS["drag"], PARAMETER_COLUMNS["yaw_drag"]

_add_basic_wrench = compile_lines(
    "add_basic_wrench",
    "row, relative, parameters, active, total",
    calls(_BASIC, "row, relative, {parameters}, total"),
    _BASIC,
)
_add_catalogue_wrench = compile_lines(
    "add_catalogue_wrench",
    "row, relative, moment, parameters, active, total",
    calls(_CATALOGUE, "row, relative, moment, {parameters}, total"),
    _CATALOGUE,
)
_add_inertia = compile_lines(
    "add_inertia",
    "parameters, active, inertia",
    calls(hooks("inertia"), "{parameters}, inertia"),
    hooks("inertia"),
)
_add_centre = compile_lines(
    "add_centre",
    "parameters, active, place",
    calls(hooks("centre"), "{parameters}, place"),
    hooks("centre"),
)
_add_catalogue_water = compile_lines(
    "add_catalogue_water",
    "place, time, parameters, active, total",
    calls(hooks("water"), "place, time, {parameters}, total"),
    hooks("water"),
    outlined_kernel,
)


@kernel
def relative_velocity(row: Floats, time: float, body: Body, relative: Floats) -> None:
    """Write (4,) u, v, w [m/s; body] relative to the water where the robot is, and its yaw rate [rad/s].

    Assumes: the water does not turn the robot.
    """
    for axis in range(4):
        relative[axis] = row[SURGE + axis]
    if body.flow.shape[0] == 0 and body.active & _WATER_BITS == 0:
        return
    water = stack_array(3)
    if body.flow.shape[0] > 0:
        add_water_velocity(row[X : Z + 1], time, body.flow, water)
    if body.active & _WATER_BITS != 0:
        _add_catalogue_water(row[X : Z + 1], time, body.parameters, body.active, water)
    sine, cosine = sine_cosine(row[YAW])
    relative[0] -= water[0] * cosine + water[1] * sine
    relative[1] -= water[1] * cosine - water[0] * sine
    relative[2] -= water[2]


@outlined_kernel
def _catalogue_wrench(row: Floats, relative: Floats, time: float, body: Body, total: Floats) -> None:
    """Write the wrench (4,) of all effects of the catalogue that are active."""
    actuators = body.actuator_wrench.shape[0]
    force, thrust = row[STATE_SIZE : STATE_SIZE + actuators], stack_array(4)
    add_thrust(force, body.actuator_wrench, body.is_pump, thrust)
    pump, pump_rate = pump_force(row, body.is_pump)
    moment = Moment(
        time,
        thrust,
        force,
        body.actuator_wrench,
        body.is_pump,
        pump,
        pump_rate,
        body.parameters[_DRAG],
        body.parameters[_YAW_DRAG],
        clearance(row, body.lower, body.upper),
        body.neighbours,
        body.own,
        body.parameters[_ADVANCE_LOSS],
        body.jets,
    )
    _add_catalogue_wrench(row, relative, moment, body.parameters, body.active, total)


@outlined_kernel
def _share_of_hull(body: Body, share: Floats) -> None:
    """Write (4,) of the inertia against surge, sway, heave and yaw the share that is the robot's own."""
    _add_inertia(body.parameters, body.active, share)
    for axis in range(4):
        own = body.parameters[MASS if axis < 3 else YAW_INERTIA]
        share[axis] = own / (own + share[axis])


@outlined_kernel
def _couple(row: Floats, body: Body, total: Floats) -> None:
    """Turn the wrench (4,) on the origin into mass and own inertia times the accelerations that it gives the origin.

    With the added mass A of each axis and the centre of mass at (x, y), effects.offset_centre has
    (m + A_u) a - m y r_dot = X + m x r^2, (m + A_v) b + m x r_dot = Y + m y r^2 and
    (I + m (x^2 + y^2) + A_r) r_dot + m (x b - y a) = N for a = u_dot - v r and b = v_dot + u r.
    At x = y = 0 it does what `_share_of_hull` does, bit for bit.
    """
    mass, inertia, turn = body.parameters[MASS], body.parameters[YAW_INERTIA], row[YAW_RATE]
    share, place, added = stack_array(4), stack_array(2), stack_array(4)
    _add_centre(body.parameters, body.active, place)
    _add_inertia(body.parameters, body.active, added)
    for axis in range(3):
        share[axis] = mass / (mass + added[axis])
    ahead, left = place[0], place[1]
    surge, sway = total[0] + mass * ahead * turn * turn, total[1] + mass * left * turn * turn
    aside = mass * (ahead * ahead * (1.0 - share[1]) + left * left * (1.0 - share[0]))
    share[3] = inertia / (inertia + added[3] + aside)
    total[3] = (total[3] + left * share[0] * surge - ahead * share[1] * sway) * share[3]
    faster = total[3] / inertia
    total[0] = share[0] * (surge + mass * left * faster)
    total[1] = share[1] * (sway - mass * ahead * faster)
    total[2] *= share[2]


@kernel
def _add_actuators(row: Floats, actuator_wrench: Floats, total: Floats) -> None:
    for actuator in range(actuator_wrench.shape[0]):
        force = row[STATE_SIZE + actuator]
        for axis in range(4):
            total[axis] += actuator_wrench[actuator, axis] * force


@kernel
def _answer(row: Floats, total: Floats, parameters: Floats, rate: Floats) -> None:
    """Write the rate of a state under the wrench `total` (4,)."""
    sine, cosine = sine_cosine(row[YAW])
    rate[X] = row[SURGE] * cosine - row[SWAY] * sine
    rate[Y] = row[SURGE] * sine + row[SWAY] * cosine
    rate[Z] = row[HEAVE]
    rate[YAW] = row[YAW_RATE]
    rate[SURGE] = total[0] / parameters[MASS] + row[SWAY] * row[YAW_RATE]
    rate[SWAY] = total[1] / parameters[MASS] - row[SURGE] * row[YAW_RATE]
    rate[HEAVE] = total[2] / parameters[MASS]
    rate[YAW_RATE] = total[3] / parameters[YAW_INERTIA]


@kernel
def _through_inertia(row: Floats, body: Body, total: Floats) -> None:
    """Turn the wrench (4,) of a robot that has more inertia than its own into what `_answer` takes, out of line."""
    changed = stack_array(4)
    if body.active & COUPLING_BITS != 0:
        for axis in range(4):
            changed[axis] = total[axis]
        _couple(row, body, changed)
        for axis in range(4):
            total[axis] = changed[axis]
        return
    _share_of_hull(body, changed)
    for axis in range(4):
        total[axis] *= changed[axis]


@kernel
def state_rate(row: Floats, time: float, body: Body, rate: Floats) -> None:
    """Write the time derivative of one robot's state `row` (row_size(actuators),) at `time` [s] into `rate`.

    Actuator forces are the columns behind STATE_SIZE; they hold while a step lasts: `rate` (STATE_SIZE,) has none.
    """
    parameters = body.parameters
    total, relative = stack_array(4), stack_array(4)
    relative_velocity(row, time, body, relative)
    _add_basic_wrench(row, relative, parameters, body.active, total)
    if body.active & _CATALOGUE_BITS != 0:
        # Copies, so that only who has such effects pays for handing arrays out of line.
        more, felt = stack_array(4), stack_array(4)
        for axis in range(4):
            felt[axis] = relative[axis]
        _catalogue_wrench(row, felt, time, body, more)
        for axis in range(4):
            total[axis] += more[axis]
    _add_actuators(row, body.actuator_wrench, total)
    if body.active & (_INERTIA_BITS | COUPLING_BITS) != 0:
        _through_inertia(row, body, total)
    _answer(row, total, parameters, rate)


@kernel
def basic_rate(row: Floats, parameters: Floats, active: int, actuator_wrench: Floats, rate: Floats) -> None:
    """What `state_rate` writes for a robot with basic effects alone in still water; all arrays may be of fours."""
    total, relative = stack_like(row, 4), stack_like(row, 4)
    for axis in range(4):
        relative[axis] = row[SURGE + axis]
    _add_basic_wrench(row, relative, parameters, active, total)
    _add_actuators(row, actuator_wrench, total)
    _answer(row, total, parameters, rate)
