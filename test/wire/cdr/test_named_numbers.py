"""Commands decoded by the thousand, with the general decoder as referee."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from cocorosim_ros.wire.cdr.named_numbers import read_named_numbers
from cocorosim_ros.wire.cdr.type_store import build, type_store

TYPE = "cocorosim_msgs/msg/ThrusterCommand"


def command(names: list[str], numbers: list[float], frame: str = "", seconds: int = 1, *, little: bool = True) -> bytes:
    """The bytes of a command by `rosbags`."""
    header = {"stamp": {"sec": seconds, "nanosec": 5}, "frame_id": frame}
    message: Any = build(TYPE, {"header": header, "name": names, "command": numbers})
    return bytes(type_store().serialize_cdr(message, TYPE, little_endian=little))


@pytest.mark.parametrize("little", [True, False])
def test_numbers_by_name(little: bool) -> None:
    """Each number is found by its name, wherever it stands; NaN where a message does not name it."""
    messages = [
        command(["left", "right"], [0.1, 0.2], "a", 1, little=little),
        command(["right", "left"], [0.3, 0.4], "longer", 2, little=little),
        command(["pump"], [0.5], "", 3, little=little),
        command([], [], "b", 4, little=little),
    ]
    read = read_named_numbers(messages, ["left", "right"])
    assert np.array_equal(read.numbers, [[0.1, 0.2], [0.4, 0.3], [np.nan, np.nan], [np.nan, np.nan]], equal_nan=True)
    assert read.stamp_ns.tolist() == [k * 10**9 + 5 for k in (1, 2, 3, 4)]
    assert read.readable.all()
    assert read.names == ("left", "right", "right", "left", "pump")


def test_what_cannot_be_read() -> None:
    """Cut off, with a number too few, or with lengths beyond reason: unreadable, and its neighbours are not."""
    whole = command(["left", "right"], [0.1, 0.2], "a")
    wrong = [command(["left", "right"], [0.1]), whole[:20] + b"\xff\xff\xff\x7f" + whole[24:], b"", whole + bytes(8)]
    cut = [whole[:length] for length in range(len(whole))]
    read = read_named_numbers([whole, *cut, *wrong, whole], ["right"])
    assert np.flatnonzero(read.readable).tolist() == [0, len(read.readable) - 1]
    assert read.numbers[read.readable].tolist() == [[0.2], [0.2]]
