"""Commands that act later than they are sent: F(t) = F_command(t - delay). Simulated in motion.late_commands.

Source: Fossen (2021), section 9.2; beside the lag of a motor, buses and controllers add a dead time. A computer whose
clock is slow, which logs the commands, looks the same.
"""

from __future__ import annotations

from cocorosim_ros.world.sensors.errors.sensor_latency import CLOCK_TICK
from cocorosim_ros.world.sensors.sensor_error import SensorError
from cocorosim_ros.world.terms.effect import Example, Number
from cocorosim_ros.world.terms.groups import LATE
from cocorosim_ros.world.terms.search import DELAYS, Search, Strength

COMMAND_DELAY = SensorError(
    summary="commands that act later than they are logged",
    equation="F(t) = F_command(t - delay)",
    parameters=(
        Number(
            "delay",
            "s",
            "from a command to what its actuator does",
            sign="not negative",
            gives="s",
            search=Strength(large=0.3, least=0.0, negligible=(-CLOCK_TICK, CLOCK_TICK), searched=DELAYS),
            example=Example(0.2, "light on command"),
        ),
    ),
    search=Search(channel="surge", group=LATE, manoeuvre="steps"),
    check="Clocks of the commands and of the readings; buses and buffers on the way to the motors.",
)
