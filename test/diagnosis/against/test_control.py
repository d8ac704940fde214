"""The spread of recordings that should be alike, by closed forms."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any, cast

import numpy as np
import pytest
from scipy.stats import chi2

from cocorosim_ros.diagnosis.against.control import Alike, Told, overdispersion
from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES
from cocorosim_ros.diagnosis.criteria.against import ALIKE
from cocorosim_ros.diagnosis.fitting.candidate import Candidate
from cocorosim_ros.diagnosis.fitting.screening import Screened


def told(sizes: list[float], information: float = 4.0) -> list[Told]:
    """One amplitude in as many parts, each so many standard deviations from what the others show."""
    return [Told(np.array([[information]]), np.array([size * np.sqrt(information)])) for size in sizes]


def test_parts_that_differ_by_noise_are_nearly_alike() -> None:
    """Six parts at one standard deviation each: a sum of squares of 6, over a cautious quantile of chi-squared."""
    assert overdispersion(told([1.0, -1.0, 1.0, -1.0, 1.0, -1.0])) == pytest.approx(6.0 / chi2.ppf(ALIKE.quantile, 6))


def test_three_times_the_spread_counts_nine_times() -> None:
    """Evidence goes with the square of a distance."""
    sizes = [2.0, -3.0, 1.0, 4.0]
    assert overdispersion(told([3.0 * size for size in sizes])) == pytest.approx(9.0 * overdispersion(told(sizes)))


def test_the_unit_of_an_amplitude_does_not_matter() -> None:
    """Information and score in other units of the amplitude give the same spread."""
    assert overdispersion(told([2.0, -3.0], 1e-3)) == pytest.approx(overdispersion(told([2.0, -3.0], 1e3)))


def test_parts_that_tell_nothing_leave_evidence_as_it_is() -> None:
    """No information, or very calm parts, never make evidence stronger."""
    assert overdispersion([Told(np.zeros((2, 2)), np.zeros(2))]) == 1.0
    assert overdispersion(told([0.01, 0.02])) == 1.0


@pytest.mark.parametrize(("steps", "spread"), [(1.0, 1.0 + 20.0), (4.0, 1.0 + 20.0 / 16.0)])
def test_a_delay_of_which_alike_recordings_tell_nothing_may_be_a_step_by_chance(steps: float, spread: float) -> None:
    """20 nats on two tracks by a delay of one step are worth one; of four steps they are worth nine."""
    amplitude = SimpleNamespace(column="sensor_latency.pose", searched=(0.25,), factor=False)
    entry = SimpleNamespace(amplitudes=(amplitude,), topic="pose")
    unknown = SimpleNamespace(scale=0.15)
    late: Any = SimpleNamespace(entry=entry, amplitudes=lambda: [unknown], everybody=(0, 1), sharers=((),))
    grid = SimpleNamespace(step=0.02)
    track = SimpleNamespace(timeline=SimpleNamespace(grid=grid), log=SimpleNamespace(streams={}))
    alike = Alike.__new__(Alike)
    alike._fit, alike._over = cast("Any", SimpleNamespace(tracks=[track])), frozenset()
    q = np.array([steps * 0.02 / 0.15])
    assert alike.spread(Screened(late, {}, q, 20.0, np.zeros((1, 1)), q)) == pytest.approx(spread)


@pytest.mark.parametrize(
    ("offset", "drift", "spread"),
    [
        # The same evidence by either name: no less usual as a drift.
        (16.0, 16.0, 4.0),
        # 16 nats by the offset, 24 more by the rate: 16 / 4 + 24 / 2 of 40 nats.
        (16.0, 40.0, 2.5),
        # An offset that explains nothing takes nothing from a drift.
        (0.0, 16.0, 2.0),
    ],
)
def test_an_offset_is_no_less_usual_for_being_called_a_drift(
    offset: float, drift: float, spread: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Alike recordings differ four times as much in offsets as their noise explains, and twice as much in drifts."""
    of_entry = {each.id: each for each in ENTRIES if each.id in {"pressure_offset", "pressure_drift"}}
    spreads = {"pressure_offset": 4.0, "pressure_drift": 2.0}
    found = [
        Screened(Candidate(of_entry[name], ("a",), ((0,),)), {}, np.zeros(2), nats, np.eye(2), np.zeros(2))
        for name, nats in (("pressure_offset", offset), ("pressure_drift", drift))
    ]
    monkeypatch.setattr(Alike, "spread", lambda self, screened: spreads[screened.candidate.entry.id])
    alike = Alike.__new__(Alike)
    for weighed in (alike.weighed(found), alike.all_weighed(found)):
        by_name = {each.candidate.entry.id: each for each in weighed}
        assert by_name["pressure_offset"].candidate.spread == 4.0
        assert by_name["pressure_drift"].candidate.spread == pytest.approx(spread)
        assert by_name["pressure_drift"].nats == pytest.approx(drift / spread)
    again = {each.candidate.entry.id: each for each in alike.all_weighed(alike.weighed(found))}
    assert again["pressure_drift"].candidate.spread == pytest.approx(spread)
