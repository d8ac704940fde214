"""Newton and Euler, or Kirchhoff's equations, for a vehicle that turns about all axes.

    M nu_r_dot + C(nu_r) nu_r + D(nu_r) nu_r + g(q) = tau,   nu_r = nu - (R(q)^T v_c, 0)

with nu = (u, v, w, p, q, r) over ground, v_c the velocity of the water, R(q) the rotation from body to world; the pose
follows by x_dot = R(q) (u, v, w) and q_dot = q (p, q, r, 0) / 2. Source: Fossen, Handbook of Marine Craft
Hydrodynamics and Motion Control (2011), eqs. 6.42 and 6.43, 8.3 to 8.5, with the axes of REP 103, in which the same
equations hold because no term names an axis.

Assumes: the hull is under water as a whole; the water's velocity changes little along the hull and within the time in
which the vehicle answers, so that no added mass is pushed by an acceleration of the water itself. A uniform current is
then exact: in the frame that drifts along, water is still.
"""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel, outlined_kernel
from cocorosim_ros.foundation.compiling.stack import stack_array
from cocorosim_ros.world.six_degrees.attitude import attitude_rate, to_body, to_world
from cocorosim_ros.world.six_degrees.bodies import FIN_LIFT, FIN_NORMAL, FIN_PLACE, FIN_TRIM, Body
from cocorosim_ros.world.six_degrees.state import ATTITUDE, ROLL_RATE, SURGE, X
from cocorosim_ros.world.terms.control_surface import fin_lift
from cocorosim_ros.world.water.flow import add_water_velocity


@kernel
def add_cross(first: Floats, second: Floats, total: Floats) -> None:
    """Add first x second to `total`; all (3,)."""
    total[0] += first[1] * second[2] - first[2] * second[1]
    total[1] += first[2] * second[0] - first[0] * second[2]
    total[2] += first[0] * second[1] - first[1] * second[0]


@kernel
def add_coriolis(momentum: Floats, velocity: Floats, total: Floats) -> None:
    """Add C(nu) nu (6,) [N, N m; body] for the momentum M nu (6,) and the velocity nu (6,).

    C(nu) = [0, -S(a); -S(a), -S(b)] for M nu = (a, b) (Fossen 2011, eq. 6.43), skew-symmetric: it never does work.
    """
    linear, angular = momentum[:3], momentum[3:]
    add_cross(velocity[3:], linear, total[:3])
    add_cross(velocity[:3], linear, total[3:])
    add_cross(velocity[3:], angular, total[3:])


@kernel
def add_hydrostatics(attitude: Floats, hydrostatic: Floats, total: Floats) -> None:
    """Add the wrench (6,) [N, N m; body] of weight and buoyancy; `hydrostatic` as in Bodies.

    Force (B - W) k and moment (B r_b - W r_g) x k, with k the world's vertical in body axes.
    """
    up, vertical = stack_array(3), stack_array(3)
    vertical[2] = 1.0
    to_body(attitude, vertical, up)
    for axis in range(3):
        total[axis] += hydrostatic[0] * up[axis]
    add_cross(hydrostatic[1:], up, total[3:])


@kernel
def add_damping(relative: Floats, body: Body, total: Floats) -> None:
    """Add linear, quadratic and lift forces (6,) [N, N m; body] at the velocity `relative` (6,) through the water."""
    ahead = abs(relative[0])
    for row in range(6):
        for column in range(6):
            speed = relative[column]
            factor = body.quadratic[row, column] * abs(speed) + body.lift[row, column] * ahead
            total[row] -= (body.linear[row, column] + factor) * speed


@kernel
def add_fins(relative: Floats, angle: Floats, body: Body, total: Floats) -> None:
    """Add the lift of fins (6,) [N, N m; body] at angles (actuators,) [rad]; of thrusters nothing is looked at.

    With V = v + omega x r at the fin; its law, assumptions and source: terms.control_surface.
    """
    for fin in range(body.fins.shape[0]):
        row = body.fins[fin]
        if row[FIN_LIFT] == 0.0:
            continue
        felt, force = stack_array(3), stack_array(3)
        place, normal = row[FIN_PLACE : FIN_PLACE + 3], row[FIN_NORMAL : FIN_NORMAL + 3]
        for axis in range(3):
            felt[axis] = relative[axis]
        add_cross(relative[3:], place, felt)
        across = felt[0] * normal[0] + felt[1] * normal[1] + felt[2] * normal[2]
        lift = fin_lift(row[FIN_LIFT], felt[0], across, angle[fin] + row[FIN_TRIM])
        for axis in range(3):
            force[axis] = lift * normal[axis]
            total[axis] += force[axis]
        add_cross(place, force, total[3:])


@kernel
def add_sliding(attitude: Floats, way: Floats, body: Body, total: Floats) -> None:
    """Add the moment (6,) [N m; body] of masses that have slid by ways (actuators,) [m]; of others nothing.

    Weight m g at a place that has moved by s along n: -m g s n x k, so for a mass that has slid ahead m g s cos(pitch)
    with the bow down. Assumes: the mass slides slowly, and is so little of the whole, or its way so short, that the
    mass matrix stays as it is with the mass in the middle.
    """
    for actuator in range(body.sliding.shape[0]):
        weight = body.sliding[actuator]
        if weight[0] == 0.0 and weight[1] == 0.0 and weight[2] == 0.0:
            continue
        up, arm = stack_array(3), stack_array(3)
        arm[2] = 1.0
        to_body(attitude, arm, up)
        for axis in range(3):
            arm[axis] = -weight[axis] * way[actuator]
        add_cross(arm, up, total[3:])


@outlined_kernel
def state_rate(row: Floats, time: float, effort: Floats, body: Body, rate: Floats) -> None:
    """Write the derivative (STATE_SIZE,) of the state `row` at `time` [s].

    effort: (actuators,) forces [N], angles [rad] and ways [m], which hold while a step lasts.
    """
    attitude, relative, momentum = row[ATTITUDE:SURGE], stack_array(6), stack_array(6)
    total, drift = stack_array(6), stack_array(3)
    relative_velocity(row, time, body.flow, drift, relative)
    for line in range(6):
        for column in range(6):
            momentum[line] += body.mass_matrix[line, column] * relative[column]
    add_coriolis(momentum, relative, total)
    for line in range(6):
        total[line] = -total[line]
    add_hydrostatics(attitude, body.hydrostatic, total)
    add_damping(relative, body, total)
    add_fins(relative, effort, body, total)
    add_sliding(attitude, effort, body, total)
    for actuator in range(body.wrench.shape[0]):
        for line in range(6):
            total[line] += body.wrench[actuator, line] * effort[actuator]
    for line in range(6):
        answer = 0.0
        for column in range(6):
            answer += body.inverse[line, column] * total[column]
        rate[SURGE + line] = answer
    # The water's velocity in body axes changes because these turn: d/dt R^T v_c = -omega x R^T v_c.
    add_cross(drift, row[ROLL_RATE:], rate[SURGE:ROLL_RATE])
    to_world(attitude, row[SURGE:ROLL_RATE], rate[X:ATTITUDE])
    attitude_rate(attitude, row[ROLL_RATE:], rate[ATTITUDE:SURGE])


@kernel
def relative_velocity(row: Floats, time: float, flow: Floats, drift: Floats, relative: Floats) -> None:
    """Write the water's velocity (3,) [m/s; body] where the vehicle is, and the vehicle's through the water (6,)."""
    if flow.shape[0] > 0:
        water = stack_array(3)
        add_water_velocity(row[X:ATTITUDE], time, flow, water)
        to_body(row[ATTITUDE:SURGE], water, drift)
    for axis in range(6):
        relative[axis] = row[SURGE + axis]
    for axis in range(3):
        relative[axis] -= drift[axis]
