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
    message: Floats  # (runs, robots, capacity, MESSAGE_SIZE), or SOUND_SIZE of what came by sound (state.sound)
    age: Integers  # (runs, robots, capacity) ticks since it was said


def empty_inbox(runs: int, robots: int, capacity: int, columns: int = MESSAGE_SIZE) -> Inbox:
    """An inbox of messages of so many columns in which nobody has heard anything."""
    return Inbox(
        heard=np.zeros((runs, robots), dtype=np.int64),
        sender=np.zeros((runs, robots, capacity), dtype=np.int64),
        message=np.zeros((runs, robots, capacity, columns)),
        age=np.ones((runs, robots, capacity), dtype=np.int64),
    )


def write_payload(row: Floats, payload: tuple[float, ...]) -> None:
    """Put a payload into a row (MESSAGE_SIZE,); what exceeds PAYLOAD_LIMIT numbers is cut off."""
    kept = payload[:PAYLOAD_LIMIT]
    row[MESSAGE_LENGTH] = len(kept)
    row[1 : 1 + len(kept)] = kept
    row[1 + len(kept) :] = 0.0


def read_payload(row: Floats) -> tuple[float, ...]:
    """The payload in a row."""
    return tuple(row[1 : 1 + int(row[MESSAGE_LENGTH])].tolist())
