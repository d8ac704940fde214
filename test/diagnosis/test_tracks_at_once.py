"""Tracks beside each other, as if one after the other."""

from __future__ import annotations

import threading
import time

import pytest

from cocorosim_ros.diagnosis.tracks.tracks_at_once import of_each_track


def test_answers_come_in_the_order_of_the_tracks() -> None:
    """Though the first one takes longest."""

    def work(number: int) -> int:
        time.sleep(0.02 * (3 - number))
        return number

    assert of_each_track(work, 4) == [0, 1, 2, 3]


def test_what_goes_wrong_is_raised() -> None:
    """In a thread as without one."""

    def work(number: int) -> float:
        return 1.0 / (number - 1)

    with pytest.raises(ZeroDivisionError):
        of_each_track(work, 3)


@pytest.mark.parametrize("count", [0, 1, 3])
def test_no_thread_outlives_the_call(count: int) -> None:
    """Lest a process that is forked later waits for one that it does not have."""
    before = threading.active_count()
    assert len(of_each_track(lambda number: number, count)) == count
    assert threading.active_count() == before
