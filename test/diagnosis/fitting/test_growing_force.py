"""Random force that grows with speed: found with its number where it does, and not where it does not."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import boats
import numpy as np
import pytest

from cocorosim_ros.diagnosis.criteria.fitting import GROWING_FORCE
from cocorosim_ros.diagnosis.fitting.fit import Fit, evaluated
from cocorosim_ros.diagnosis.fitting.growing_force import speed_and_thrust, with_growing_force
from cocorosim_ros.diagnosis.fitting.recalibration import base_fit, nominal_fit
from cocorosim_ros.diagnosis.fitting.smoothed import smoothed_tracks
from cocorosim_ros.diagnosis.showing.noise_levels import noise_levels
from cocorosim_ros.diagnosis.showing.uneven_noise import growth_remarks
from cocorosim_ros.diagnosis.tracks.agitation import Agitation
from cocorosim_ros.diagnosis.tracks.columns import COLUMN, NEUTRAL

AT_REST, BY_SPEED = 0.5, 1.0  # N, N s/m


@pytest.fixture(scope="module")
def fitted(tmp_path_factory: pytest.TempPathFactory) -> Any:
    """Function of a boat's truth: the recalibrated model of one drive of four minutes."""
    boat = boats.platform(tmp_path_factory.mktemp("boat"), boats.KNOWN)
    return lambda truth: base_fit(boats.recorded(boat, truth, 240.0, 1))


def grown(fit: Fit) -> Fit | None:
    """The same model with a random force that grows, if it does."""
    return with_growing_force(fit, fit, smoothed_tracks(fit))


def test_the_variance_follows_the_shares_of_speed_and_thrust() -> None:
    """By hand: 1 + (2 * 0.5)^2 + (3 * 1)^2 = 11 at full thrust and half speed; without growth nothing is reckoned."""
    agitation = Agitation(np.array([0.0, 1.0]), np.array([[0.0, 0.0], [0.5, 1.0]]))
    row = NEUTRAL.copy()
    assert agitation.variance(row, np.array([0.0, 1.0])).size == 0
    row[COLUMN["random.with_speed"]], row[COLUMN["random.with_thrust"]] = math.log(2.0), math.log(3.0)
    assert agitation.variance(row, np.array([0.0, 1.0])) == pytest.approx([1.0, 11.0])


def test_growth_with_speed_is_found_with_its_number(fitted: Any) -> None:
    """Pushes of 0.5 N at rest, and 1 N for each m/s: the growth is that at the highest speed over that at rest."""
    fit = fitted(boats.Truth(choppy=AT_REST, rough=BY_SPEED))
    found = grown(fit)
    assert found is not None
    assert found.objective > fit.objective + 50.0
    (highest, _), level = (
        np.quantile(speed_and_thrust(fit.tracks[0], smoothed_tracks(fit)[0]), GROWING_FORCE.highest, axis=0),
        noise_levels(found)["random.with_speed"],
    )
    assert level.holds(BY_SPEED * highest / AT_REST)
    assert level.high < 2.0 * level.low
    (said,) = growth_remarks(found)
    assert "boat grows with speed" in said


def test_a_random_force_that_is_even_does_not_grow(fitted: Any) -> None:
    """The same pushes at all times: no growth is told, and none without pushes, whatever the filter's steps err by."""
    for truth in (boats.Truth(choppy=AT_REST), boats.Truth()):
        fit = fitted(truth)
        assert grown(fit) is None
        assert growth_remarks(fit) == ()


def test_the_nominal_model_has_a_growth_of_its_own(fitted: Any) -> None:
    """Fitted too, since a nominal model whose growth stays where the numbers' fit had it takes these for moved."""
    found = grown(fitted(boats.Truth(choppy=AT_REST, rough=BY_SPEED)))
    assert found is not None
    place = next(index for index, each in enumerate(found.noise) if each.column == "random.with_speed")
    q_noise = found.q_noise.copy()
    q_noise[place] -= 1.0  # of a base that had less to explain by growth
    nominal = nominal_fit(replace(found, q_noise=q_noise))
    assert nominal.q_noise[place] == pytest.approx(found.q_noise[place], abs=0.3)
    assert nominal.objective > evaluated(replace(nominal, q_noise=q_noise)).objective + 1.0


def test_a_part_of_a_track_grows_as_the_whole_does(fitted: Any) -> None:
    """A track cut out of another one, as for held-out blocks, has the variance of the same moments."""
    found = grown(fitted(boats.Truth(choppy=AT_REST, rough=BY_SPEED)))
    assert found is not None
    (track,), (row,) = found.tracks, found.filled
    even = row.copy()
    even[COLUMN["random.with_speed"]] = NEUTRAL[COLUMN["random.with_speed"]]
    part = track.piece(1200, 300)
    # Readings late in the part no longer know where it began: their variance is that of the whole.
    late = np.isin(track.timeline.stamp, part.timeline.stamp[-100:])
    whole, without = (track.filter.full(each).variance[late] for each in (row, even))
    assert np.median(part.filter.full(row).variance[-100:] / whole) == pytest.approx(1.0, rel=1e-3)
    assert np.median(without / whole) < 0.97
