"""Where neither readings nor commands were recorded, a log has a hole, and its parts are courses of their own."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.evidence.holes import hole_sentences, holes_of, parts_of
from cocorosim_ros.diagnosis.evidence.streams.log import RobotLog, Stream

HOLE = (50.0, 63.0)


def stream(time: Any) -> Stream:
    """A stream of one column."""
    return Stream(time, np.zeros((len(time), 1)), np.ones(1))


def log(commands: Any, *times: Any) -> RobotLog:
    """A log with these stamps of commands and of streams."""
    names = ("pressure", "compass")
    return RobotLog(
        "lily_01", commands, np.zeros((len(commands), 3)), dict(zip(names, map(stream, times), strict=False))
    )


def without(time: Any, begin: float, end: float) -> Any:
    """Stamps without those between two moments."""
    return time[(time <= begin) | (time >= end)]


EVERY = np.arange(0.0, 120.0, 0.5)
FAST = np.arange(0.0, 120.0, 0.1)


def test_a_hole_of_everything_splits_a_log() -> None:
    """13 s without any message: two parts, from the first to the last stamp of each."""
    cut = log(without(EVERY, *HOLE), without(FAST, *HOLE), without(EVERY, *HOLE))
    assert holes_of(cut) == (HOLE,)
    assert parts_of(cut) == ((0.0, 50.0), (63.0, pytest.approx(119.9)))
    assert len(hole_sentences(cut)) == 1 and "50.0 to 63.0 s" in hole_sentences(cut)[0]


def test_a_hole_of_even_commands_is_one_though_readings_go_on() -> None:
    """What was commanded in between is unknown; the part behind it begins with the next command."""
    assert parts_of(log(without(EVERY, *HOLE), FAST)) == ((0.0, 50.0), (63.0, pytest.approx(119.9)))


def test_readings_that_pause_alone_are_no_hole() -> None:
    """The commands foretell what happens meanwhile."""
    assert holes_of(log(EVERY, without(FAST, *HOLE), without(FAST, *HOLE))) == ()


def test_commands_that_are_sent_when_they_change_are_no_hole() -> None:
    """Each holds until the next one, however long that takes."""
    rng = np.random.default_rng(0)
    changes = np.cumsum(rng.exponential(4.0, 30))
    assert holes_of(log(changes[changes < 50.0], FAST)) == ()


def test_short_parts_are_left_out() -> None:
    """A part of two seconds holds no whole manoeuvre."""
    cut = without(without(EVERY, *HOLE), 65.0, 80.0)
    assert parts_of(log(cut, cut)) == ((0.0, 50.0), (80.0, 119.5))


def test_a_log_without_readings_has_no_parts() -> None:
    """Nor one without anything."""
    assert parts_of(log(EVERY)) == ()
    assert holes_of(log(np.empty(0))) == ()
