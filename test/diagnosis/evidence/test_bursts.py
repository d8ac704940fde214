"""Stamps of readings that were delivered in bursts are put back to when the readings were taken."""

from __future__ import annotations

import numpy as np
import pytest

from cocorosim_ros.diagnosis.evidence.bursts import as_taken
from cocorosim_ros.diagnosis.evidence.topic_rows import COMMAND, TopicRows

PERIOD, POLL = 1.0 / 120.0, 0.010  # s, of a camera and of the loop that fetches its images


def rows(time: np.ndarray, topic: str = "pose") -> TopicRows:
    """Rows with these stamps [s]."""
    stamp_ns = np.rint(time * 1e9).astype(np.int64)
    return TopicRows("craft", topic, stamp_ns, stamp_ns, np.zeros((len(time), 4)))


def numbered(time: np.ndarray) -> TopicRows:
    """Rows with these stamps [s], the first value of each of which is its number."""
    made = rows(time)
    made.values[:, 0] = np.arange(len(time))
    return made


def fetched(taken: np.ndarray, stall: tuple[float, float]) -> np.ndarray:
    """When a loop that stalls once fetches images that were taken then [s]: 20 us after each other."""
    turn = np.ceil(taken / POLL) * POLL
    turn = np.where((turn > stall[0]) & (turn < stall[1]), stall[1], turn)
    first = np.append(True, np.diff(turn) > 0)
    place = np.arange(len(turn)) - np.maximum.accumulate(np.where(first, np.arange(len(turn)), 0))
    return turn + 20e-6 * place


def test_images_that_a_slower_loop_fetches() -> None:
    """All but a constant delay is undone to a third, also where the loop stalled and images were lost."""
    rng = np.random.default_rng(4)
    taken = PERIOD * np.flatnonzero(rng.random(3000) > 0.04)
    stamps = fetched(taken, (10.0, 10.2))
    found, said = as_taken(numbered(stamps))
    after, which = found.stamp_ns * 1e-9, found.values[:, 0].astype(int)
    assert "come at once with the one before" in said[0]
    assert (np.diff(found.stamp_ns) >= 0).all() and (after <= stamps[which] + 1e-9).all()
    assert np.std(after - taken[which]) < np.std(stamps - taken) / 3.0


@pytest.mark.parametrize("lost", [0.0, 0.6])
def test_of_a_burst_that_lacks_readings_the_last_stays(lost: float) -> None:
    """Without a loss all times of a stall's burst are known; with one, those that are kept err by few periods."""
    rng = np.random.default_rng(7)
    taken = PERIOD * np.arange(3000)
    within = (taken > 10.0) & (taken < 10.2)
    taken = taken[~(within & (rng.random(3000) < lost))]
    stamps = fetched(taken, (10.0, 10.2))
    found, said = as_taken(numbered(stamps))
    which = found.values[:, 0].astype(int)
    burst = (stamps > 10.1) & (stamps < 10.205)
    kept = np.isin(np.arange(len(taken)), which)
    assert kept[~burst].all()
    assert ("were left out" in said[0]) == (lost > 0.0)
    assert np.count_nonzero(burst) - np.count_nonzero(kept & burst) == (np.count_nonzero(burst) - 1 if lost else 0)
    assert np.ptp(found.stamp_ns * 1e-9 - taken[which]) < 2.0 * PERIOD


@pytest.mark.parametrize("jitter", [0.0, 0.1, 0.25])
def test_readings_taken_unevenly_stay_where_they_are(jitter: float) -> None:
    """Normal jitter of the taking itself, as a share of the period, is no burst."""
    time = 0.1 * (np.arange(2000) + jitter * np.random.default_rng(5).standard_normal(2000))
    found, said = as_taken(rows(np.sort(time)))
    assert said == () and np.array_equal(found.stamp_ns, rows(np.sort(time)).stamp_ns)


def test_commands_and_few_readings_are_left_alone() -> None:
    """A command counts from when it was given, whatever came with it."""
    time = np.repeat(np.arange(0.0, 10.0, 0.1), 2) + np.tile([0.0, 1e-5], 100)
    assert as_taken(rows(time, COMMAND))[1] == ()
    assert as_taken(rows(time[:10]))[1] == ()
    assert len(as_taken(rows(time))[1]) == 1
