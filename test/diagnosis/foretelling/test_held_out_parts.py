"""What is held out, and how long free runs last."""

from __future__ import annotations

import itertools
import math
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.foretelling.held_out_parts import Span, split_tracks
from cocorosim_ros.diagnosis.foretelling.horizon import window_length
from cocorosim_ros.diagnosis.tracks.passes import Smoothed
from cocorosim_ros.world.state.state import YAW_RATE


def tracks(*points: int) -> list[Any]:
    """Recordings of one robot, each of so many points of 0.1 s."""
    grids = [SimpleNamespace(points=count, duration=0.1 * (count - 1)) for count in points]
    return [SimpleNamespace(name="lily_01", timeline=SimpleNamespace(grid=grid)) for grid in grids]


def test_blocks_lie_throughout_a_long_recording() -> None:
    """Ten minutes and runs of 20 s: four blocks of a minute, each behind a fitted minute and a half."""
    (split,) = split_tracks(tracks(6000), 20.0, [0])
    assert split.held == tuple(Span(1500 * number + 900, 600) for number in range(4))
    assert split.seen == tuple(Span(1500 * number, 900) for number in range(4))


def test_several_recordings_are_held_out_at_several_places() -> None:
    """Late, early, in the middle; what is held out is not fitted, and all the rest is."""
    splits = split_tracks(tracks(1000, 1000, 1000), 20.0, range(3))
    assert [split.held for split in splits] == [(Span(600, 400),), (Span(50, 400),), (Span(300, 400),)]
    for split in splits:
        parts = sorted((*split.held, *split.seen))
        assert parts[0].first == 0 and parts[-1].end == 1000
        assert all(one.end == other.first for one, other in itertools.pairwise(parts))


def test_of_many_short_recordings_whole_ones_are_held_out() -> None:
    """Three of eight, spread; nothing of these is fitted, and all of the others."""
    splits = split_tracks(tracks(*[100] * 8), 5.0, range(8))
    held = [number for number, split in enumerate(splits) if split.held]
    assert held == [2, 4, 7]
    assert all(not split.seen for split in splits if split.held)
    assert all(split.seen == (Span(0, 100),) for split in splits if not split.held)


def test_nothing_is_held_out_of_other_tracks() -> None:
    """Two of four are judged: they are split as if alone, and the others are fitted whole."""
    points = (700, 1000, 800, 1000)
    splits = split_tracks(tracks(*points), 20.0, (1, 3))
    assert splits[1::2] == split_tracks(tracks(1000, 1000), 20.0, range(2))
    for number in (0, 2):
        assert splits[number].held == ()
        assert splits[number].seen == (Span(0, points[number]),)


@pytest.mark.parametrize(
    ("coasting", "rate", "seconds"),
    [(3.3, 0.0, 20.0), (3.3, 1.48, 20.0), (3.3, -14.0, 2.0), (3.3, 99.0, 0.5), (60.0, 0.0, 500.0), (0.1, 0.0, 0.5),
     (math.inf, 0.0, 500.0), (0.62, 3.0, 5.0)],
)  # fmt: skip
def test_runs_last_as_long_as_a_vehicle_coasts(coasting: float, rate: float, seconds: float) -> None:
    """Six coasting times, to the next length; by no more than thirty radians of turning."""
    mean = np.zeros((50, 12))
    mean[:, YAW_RATE] = rate
    assert window_length(coasting, [Smoothed(0.1 * np.arange(50), mean, mean)]) == seconds
