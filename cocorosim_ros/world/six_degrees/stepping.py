"""Steps in time for vehicles in six degrees of freedom: classical fourth-order Runge-Kutta in whole steps."""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.stack import stack_array
from cocorosim_ros.world.motion.actuation import admitted
from cocorosim_ros.world.six_degrees.attitude import bring_to_unit_length
from cocorosim_ros.world.six_degrees.bodies import Body
from cocorosim_ros.world.six_degrees.dynamics import state_rate
from cocorosim_ros.world.six_degrees.state import ATTITUDE, STATE_SIZE, SURGE
from cocorosim_ros.world.terms.curve import thrust_share


@kernel
def set_effort(command: Floats, body: Body, effort: Floats) -> None:
    """Write the force [N], angle [rad] or way [m] of every actuator at `command` (actuators,), fractions.

    Beyond -1..1 the limit counts; NaN is zero.
    """
    for actuator in range(body.limit.shape[0]):
        share = admitted(command[actuator])
        if body.curve.shape[1] > 0:
            share = thrust_share(body.curve[actuator], share)
        effort[actuator] = share * body.limit[actuator, 0 if share >= 0.0 else 1]


@kernel
def take_step(row: Floats, time: float, step: float, effort: Floats, body: Body) -> None:
    """Advance the state `row` (STATE_SIZE,) from `time` by `step` [s]: classical fourth-order Runge-Kutta."""
    trial, total, rate = stack_array(STATE_SIZE), stack_array(STATE_SIZE), stack_array(STATE_SIZE)
    for column in range(STATE_SIZE):
        trial[column] = row[column]
    moment = time
    for stage in range(4):
        weight = 1.0 if stage == 0 or stage == 3 else 2.0  # noqa: PLR1714
        reach = step if stage == 2 else 0.5 * step
        state_rate(trial, moment, effort, body, rate)
        for column in range(STATE_SIZE):
            total[column] += weight * rate[column]
            trial[column] = row[column] + reach * rate[column]
        moment = time + reach
    for column in range(STATE_SIZE):
        row[column] += step / 6.0 * total[column]
    bring_to_unit_length(row[ATTITUDE:SURGE])
