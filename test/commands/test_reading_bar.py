"""The bar of commands that read a long recording."""

from __future__ import annotations

import io
import re
from pathlib import Path

import pytest
from rich.console import Console

from cocorosim_ros.commands.reading_bar import SHOWN_AFTER, ReadingBar
from cocorosim_ros.wire.bags.bag_reader import read_bag

FIVE_LILYS = Path(__file__).parents[2] / "bags" / "five_lilys"


class Clock:
    """A clock that a test sets [s]."""

    def __init__(self) -> None:
        self.now = 100.0

    def __call__(self) -> float:
        """The time."""
        return self.now


@pytest.fixture
def clock() -> Clock:
    """The clock of the bar."""
    return Clock()


def shown(clock: Clock, steps: list[tuple[float, int, int]], *, terminal: bool = True) -> str:
    """What is printed of passes told at (seconds since the start, bytes read, all bytes)."""
    file = io.StringIO()
    with ReadingBar(Console(file=file, force_terminal=terminal, width=100), clock) as bar:
        for seconds, done, total in steps:
            clock.now = 100.0 + seconds
            bar.watch(done, total)
    return re.sub(r"\x1b\[[\d;?]*[A-Za-z]", "", file.getvalue()) if terminal else file.getvalue()


def test_a_long_reading_has_a_bar_with_the_time_left(clock: Clock) -> None:
    """Half of it after four seconds, a quarter each two: four seconds are left."""
    text = shown(clock, [(2.0, 250, 1000), (4.0, 500, 1000)])
    assert "reading" in text
    assert "50%" in text
    assert "left 00:04" in text


def test_what_is_read_at_once_has_no_bar(clock: Clock) -> None:
    """Nothing is printed in the first second."""
    assert shown(clock, [(0.5 * SHOWN_AFTER, 500, 1000), (0.9 * SHOWN_AFTER, 1000, 1000)]) == ""


def test_no_bar_goes_into_a_pipe(clock: Clock) -> None:
    """Where there is no terminal there is not a byte of it."""
    assert shown(clock, [(2.0, 250, 1000), (4.0, 500, 1000)], terminal=False) == ""


def test_the_second_pass_begins_the_bar_anew(clock: Clock) -> None:
    """It does not stay at the end of the first."""
    text = shown(clock, [(2.0, 900, 1000), (4.0, 100, 1000)])
    assert text.rindex("10%") > text.rindex("90%")


def test_opening_and_each_pass_tell_how_far_they_are() -> None:
    """In growing numbers of bytes, up to nearly all of the file; asked or not, the messages are the same."""
    told: list[tuple[int, int]] = []
    bag = read_bag(FIVE_LILYS, lambda done, total: told.append((done, total)))
    opening = list(told)
    assert opening == sorted(opening) and len(opening) > 1
    size = next(FIVE_LILYS.glob("bag/*.mcap")).stat().st_size
    assert {total for _, total in opening} == {size} and 0.5 * size < opening[-1][0] <= size
    assert list(bag.messages()) == list(read_bag(FIVE_LILYS).messages())
    again = told[len(opening) :]
    assert again == sorted(again) and set(again) <= set(opening) and len(again) > 1
