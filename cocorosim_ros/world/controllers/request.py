"""What a behaviour asks of the robot's operating system: one row of numbers that persists between ticks."""

from __future__ import annotations

HEADING = 0  # rad, world; NaN: hold the heading of the first reading
SPEED = 1  # fraction of full thrust, -1..1
TURN_GAIN = 2  # of the heading controller
DIVE_MODE = 3  # DIVE_AT_SPEED or DIVE_TO_DEPTH
DIVE = 4  # m/s, up positive, or m of depth, down positive
DIRECT = 5  # 1: the actuators take the fractions that follow, no heading or depth control
FRACTIONS = 6  # DIRECT_LIMIT columns
DIRECT_LIMIT = 8  # actuators that can be commanded directly
NOTES = FRACTIONS + DIRECT_LIMIT  # NOTES_LIMIT columns that are the behaviour's own; all zero at first
NOTES_LIMIT = 4
REQUEST_SIZE = NOTES + NOTES_LIMIT

DIVE_AT_SPEED = 0.0
DIVE_TO_DEPTH = 1.0
