"""A table of commands, row by row and over again: manoeuvres that show what a recording is to show.

Each row has a time and how strongly the robot is to go ahead, turn counter-clockwise and rise meanwhile, -1..1; rows
of no time are left out. What that means for the actuators is said for each actuator: its command is
ahead * its share + turn * its share + rise * its share, cut to -1..1. With `ramps` the commands go in a straight line
from each row's to the next one's.
"""

from __future__ import annotations

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.controllers.controller import Controller
from cocorosim_ros.world.controllers.functions import set_actuator
from cocorosim_ros.world.controllers.request import DIRECT_LIMIT
from cocorosim_ros.world.state.observation import Observation

ROWS = 16
MOTIONS = ("ahead", "turn", "rise")
FIRST_SHARE, WIDTH = 1, len(MOTIONS)
FIRST_ROW = FIRST_SHARE + DIRECT_LIMIT * WIDTH
ROW_WIDTH = 1 + WIDTH
SETTINGS = (
    "ramps",
    *(f"actuator_{number}_{motion}" for number in range(1, DIRECT_LIMIT + 1) for motion in MOTIONS),
    *(f"row_{number}_{part}" for number in range(1, ROWS + 1) for part in ("time", *MOTIONS)),
)
CLOCK_TOLERANCE = 1e-6  # s


@kernel
def following_row(settings: Floats, row: int) -> int:
    """The next row that lasts, the first one after the last; `row` itself if there is no other."""
    for step in range(1, ROWS):
        other = (row + step) % ROWS
        if settings[FIRST_ROW + other * ROW_WIDTH] > 0.0:
            return other
    return row


@kernel
def motion_at(settings: Floats, row: int, share: float, motion: int) -> float:
    """How strongly to go ahead (0), turn (1) or rise (2) when `share` (0..1) of the row's time is over."""
    here: float = settings[FIRST_ROW + row * ROW_WIDTH + 1 + motion]
    there: float = settings[FIRST_ROW + following_row(settings, row) * ROW_WIDTH + 1 + motion]
    ramp: float = settings[0] * share * (there - here)
    return here + ramp


@kernel
def decide(observation: Observation, sensor_axis: Floats, settings: Floats, request: Floats) -> None:
    """Ask for the actuators of the row that the time belongs to; all are off where no row lasts."""
    whole = 0.0
    for row in range(ROWS):
        whole += max(settings[FIRST_ROW + row * ROW_WIDTH], 0.0)
    for actuator in range(DIRECT_LIMIT):
        set_actuator(request, actuator, 0.0)
    if whole <= 0.0:
        return
    elapsed = (observation.time + CLOCK_TOLERANCE) % whole
    for row in range(ROWS):
        lasts = settings[FIRST_ROW + row * ROW_WIDTH]
        if 0.0 <= elapsed < lasts:
            for actuator in range(DIRECT_LIMIT):
                fraction = 0.0
                for motion in range(WIDTH):
                    weight = settings[FIRST_SHARE + actuator * WIDTH + motion]
                    fraction += weight * motion_at(settings, row, elapsed / lasts, motion)
                set_actuator(request, actuator, fraction)
        elapsed -= max(lasts, 0.0)


PROGRAMME = Controller(summary="a table of commands, over and over", settings=SETTINGS, decide=decide)
