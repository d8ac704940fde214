"""What robots say and hear: fixed-size rows, so that compiled loops can carry them."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from cocorosim_ros.foundation.arrays import Floats, Integers

MESSAGE_LENGTH = 0  # column that holds how many numbers the message has; 0: the robot was silent
PAYLOAD_LIMIT = 8  # numbers a radio message can carry
MESSAGE_SIZE = 1 + PAYLOAD_LIMIT
HEARING_LIMIT = 64  # messages that a robot can hear in one tick


class Inbox(NamedTuple):
    """What every robot has heard at one tick; leading axes (runs, robots)."""

    heard: Integers  # (runs, robots) messages heard
    sender: Integers  # (runs, robots, capacity) index of the sender, ascending
    message: Floats  # (runs, robots, capacity, MESSAGE_SIZE)
    age: Integers  # (runs, robots, capacity) ticks since it was said


def empty_inbox(runs: int, robots: int, capacity: int) -> Inbox:
    """An inbox in which nobody has heard anything."""
    return Inbox(
        heard=np.zeros((runs, robots), dtype=np.int64),
        sender=np.zeros((runs, robots, capacity), dtype=np.int64),
        message=np.zeros((runs, robots, capacity, MESSAGE_SIZE)),
        age=np.ones((runs, robots, capacity), dtype=np.int64),
    )
