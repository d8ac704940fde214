"""Response of an actuator to commands that hold until the next one: dead time, lag of first order, limit of its rate.

x' = (u(t - delay) - x) / time_constant, no faster than `rate`. Between changes of the command it is known in closed
form: a straight line while the limit holds, then an exponential.

Source: Fossen (2021), section 9.2, for the lag; Van Berlekom and Goddard (1972), as in most models of ships, for the
limited rate of a steering gear.
"""

from __future__ import annotations

import math

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel


@kernel
def relaxed_towards(begin: float, target: float, span: float, time_constant: float, rate: float) -> float:
    """Value after `span` [s] of one that goes from `begin` towards `target`; rate [1/s] may be infinite."""
    gap = target - begin
    straight = abs(gap) - rate * time_constant  # of the way, while the limit holds
    if straight > 0.0:
        slewing = straight / rate
        if span <= slewing:
            return begin + math.copysign(rate * span, gap)
        begin += math.copysign(straight, gap)
        span -= slewing
    value: float = target - (target - begin) * math.exp(-span / time_constant)
    return value


@kernel
def respond(moments: Floats, command_time: Floats, command: Floats, lateness: Floats, shown: Floats) -> None:
    """Write the response at moments (n,) [s], ascending, into `shown` (n,).

    command (m,) holds from command_time (m,) [s] on; before, it was what the first one is. lateness (3,): delay [s],
    time constant [s], positive, and largest rate [of the command, 1/s].
    """
    delay, time_constant, rate = lateness[0], lateness[1], lateness[2]
    value, now, held = command[0], command_time[0] + delay, 0
    for index in range(moments.shape[0]):
        while held + 1 < command.shape[0] and command_time[held + 1] + delay <= moments[index]:
            change = command_time[held + 1] + delay
            value = relaxed_towards(value, command[held], change - now, time_constant, rate)
            now = change
            held += 1
        span = max(moments[index] - now, 0.0)
        shown[index] = relaxed_towards(value, command[held], span, time_constant, rate)


def response(moments: Floats, command_time: Floats, command: Floats, lateness: Floats) -> Floats:
    """(n,) the response at moments, as `respond` writes it."""
    shown = np.empty(len(moments))
    respond(moments, command_time, command, lateness, shown)
    return shown
