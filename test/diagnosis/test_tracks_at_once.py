"""Tracks beside each other, as if one after the other."""

from __future__ import annotations

import threading
import time

import pytest

from cocorosim_ros.diagnosis.tracks import tracks_at_once
from cocorosim_ros.diagnosis.tracks.lately import Lately
from cocorosim_ros.diagnosis.tracks.tracks_at_once import of_each_number, of_each_track


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


@pytest.mark.parametrize(("processors", "tracks", "threads"), [(1, 1, 1), (2, 1, 2), (2, 3, 1), (8, 3, 3), (64, 1, 8)])
def test_numbers_of_a_track_share_the_processors_that_tracks_leave(
    monkeypatch: pytest.MonkeyPatch, processors: int, tracks: int, threads: int
) -> None:
    """As many calls are under way at once as there are processors for each track, and no more than eight."""
    monkeypatch.setattr(tracks_at_once, "processors", lambda: processors)
    together = threading.Barrier(threads)  # which breaks, unless so many calls are under way at once
    seen = set()

    def work(number: int) -> int:
        seen.add(threading.get_ident())
        together.wait(timeout=60.0)
        return number

    assert of_each_number(work, 2 * threads, tracks) == list(range(2 * threads))
    assert len(seen) <= threads


def test_a_cache_serves_threads_that_push_results_out_of_it() -> None:
    """Each caller gets what it asked for, though the cache keeps fewer than there are callers."""
    cache: Lately[int] = Lately(2)

    def work(number: int) -> int:
        return sum(cache.once(number % 5, lambda: number % 5) for _ in range(2000))

    assert of_each_track(work, 8) == [2000 * (number % 5) for number in range(8)]
