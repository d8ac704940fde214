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
from cocorosim_ros.diagnosis.foretelling.regimes import DEPTH, QUANTITIES, unlikeness
from cocorosim_ros.diagnosis.tracks.passes import Smoothed
from cocorosim_ros.world.state.state import YAW_RATE


def split(among: Any, seconds: float, numbers: Any) -> Any:
    """Split tracks that are in one regime all the time."""
    nothing = [of_one_quantity(np.zeros(track.timeline.grid.points)) for track in among]
    return split_tracks(among, seconds, numbers, nothing)


def of_one_quantity(values: Any, place: int = 0) -> Any:
    """Regimes (points, quantities) that differ in one quantity alone, by its number."""
    found = np.zeros((len(values), len(QUANTITIES)))
    found[:, place] = values
    return found


def tracks(*points: int) -> list[Any]:
    """Recordings of one robot, each of so many points of 0.1 s."""
    grids = [SimpleNamespace(points=count, duration=0.1 * (count - 1)) for count in points]
    return [SimpleNamespace(name="lily_01", timeline=SimpleNamespace(grid=grid)) for grid in grids]


def test_blocks_lie_throughout_a_long_recording() -> None:
    """Ten minutes and runs of 20 s: four blocks of a minute, each behind a fitted minute and a half."""
    (found,) = split(tracks(6000), 20.0, [0])
    assert found.held == tuple(Span(1500 * number + 900, 600) for number in range(4))
    assert found.seen == tuple(Span(1500 * number, 900) for number in range(4))


def test_several_recordings_are_held_out_at_several_places() -> None:
    """Late, early, in the middle; what is held out is not fitted, and all the rest is."""
    splits = split(tracks(1000, 1000, 1000), 20.0, range(3))
    assert [each.held for each in splits] == [(Span(600, 400),), (Span(50, 400),), (Span(300, 400),)]
    for each in splits:
        parts = sorted((*each.held, *each.seen))
        assert parts[0].first == 0 and parts[-1].end == 1000
        assert all(one.end == other.first for one, other in itertools.pairwise(parts))


def test_of_many_short_recordings_whole_ones_are_held_out() -> None:
    """Three of eight, spread; nothing of these is fitted, and all of the others."""
    splits = split(tracks(*[100] * 8), 5.0, range(8))
    held = [number for number, each in enumerate(splits) if each.held]
    assert held == [2, 4, 7]
    assert all(not each.seen for each in splits if each.held)
    assert all(each.seen == (Span(0, 100),) for each in splits if not each.held)


def test_a_choice_that_fits_nothing_is_not_taken() -> None:
    """Of six seconds that end unlike their begin a block in the middle would leave rests too short to be fitted."""
    (found,) = split_tracks(tracks(60), 5.0, [0], [of_one_quantity(np.arange(60) >= 36)])
    assert found.held and found.seen
    assert unlikeness(np.zeros((0, len(QUANTITIES))), of_one_quantity(np.arange(60))) == math.inf


def test_nothing_is_held_out_of_other_tracks() -> None:
    """Two of four are judged: they are split as if alone, and the others are fitted whole."""
    points = (700, 1000, 800, 1000)
    splits = split(tracks(*points), 20.0, (1, 3))
    assert splits[1::2] == split(tracks(1000, 1000), 20.0, range(2))
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


def of_regimes(among: Any, regimes: Any, seconds: float = 20.0, place: int = 0) -> Any:
    """Spans that are held out of tracks with these values (points,) of one quantity, and the difference left."""
    values = [of_one_quantity(each, place) for each in regimes]
    splits = split_tracks(among, seconds, range(len(among)), values)

    def along(parts: Any) -> Any:
        return np.concatenate([values[n][span.first : span.end] for n, spans in enumerate(parts) for span in spans])

    apart = unlikeness(along([each.held for each in splits]), along([each.seen for each in splits]))
    return [each.held for each in splits], apart


def test_what_lies_in_one_half_alone_is_not_held_out_alone() -> None:
    """A minute and a half, the last 36 s in reverse: held out late, nothing of it would be fitted."""
    ahead = np.where(np.arange(900) < 540, 1.0, -1.0)
    (held,), apart = of_regimes(tracks(900), [ahead])
    assert held == (Span(270, 360),)
    # Of 360 points 90 in reverse, of the other 540 there are 270.
    assert apart == pytest.approx(2.0 * (270 / 540 - 90 / 360) / (2.0 * math.sqrt(0.4 * 0.6)))


def test_parts_of_all_regimes_stay_where_they_are() -> None:
    """What swings ten times in each block is everywhere alike."""
    swinging = np.sign(np.sin(2.0 * np.pi * np.arange(1000) / 40.0 + 0.1))
    held, apart = of_regimes(tracks(1000, 1000), [swinging, swinging])
    assert held == [(Span(600, 400),), (Span(50, 400),)]
    assert apart < 0.1


def test_whole_recordings_of_all_regimes_are_held_out() -> None:
    """Three slow drives of eight, just those that would be held out first: one of three, and two of five are fitted."""
    slow = [np.full(100, 1.0 if number in (2, 4, 7) else 5.0) for number in range(8)]
    held, apart = of_regimes(tracks(*[100] * 8), slow, 5.0)
    assert [number for number, spans in enumerate(held) if spans] == [1, 4, 6]
    slow_share = (95 + 200) / (3 * 95 + 500)  # the beginnings of whole recordings count for nothing
    assert apart == pytest.approx((2 / 5 - 1 / 3) / math.sqrt(slow_share * (1.0 - slow_share)))


def test_what_hardly_varies_is_no_regime() -> None:
    """A thrust of 1.00 and 1.02 N is one thrust."""
    hardly = np.where(np.arange(1000) < 600, 1.0, 1.02)
    held, apart = of_regimes(tracks(1000), [hardly])
    assert (held, apart) == ([(Span(600, 400),)], 0.0)


def test_depth_counts_less() -> None:
    """All but a twentieth of the last 36 s is deep, a twentieth before: 0.9 / 0.49 standard deviations, by weight."""
    deep = np.where((np.arange(900) < 540) ^ (np.arange(900) % 20 == 0), 1.0, 2.0)
    (held,), apart = of_regimes(tracks(900), [deep], place=DEPTH)
    assert held == (Span(540, 360),)
    assert apart == pytest.approx(0.9 * 0.9 / math.sqrt(0.41 * 0.59))
    (held,), apart = of_regimes(tracks(900), [deep])
    assert held == (Span(270, 360),)
