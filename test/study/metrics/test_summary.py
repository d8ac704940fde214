"""Summaries of runs against numpy."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from cocorosim_ros.study.metrics import COLUMN, METRICS
from cocorosim_ros.study.metrics import summary as summaries
from cocorosim_ros.study.metrics.summary import summarise, summary_of


def some_values(ticks: int, runs: int) -> np.ndarray:
    """Values with gaps: a tenth of them undefined."""
    rng = np.random.default_rng(3)
    values = rng.gamma(2.0, size=(ticks, runs, len(METRICS)))
    values[rng.random(values.shape) < 0.1] = np.nan
    return values


def test_mean_and_median_leave_out_the_undefined() -> None:
    """Time mean, time median and number of defined moments are those of numpy's NaN functions."""
    values = some_values(200, 3)
    summary = summarise(values)
    np.testing.assert_allclose(summary.mean, np.nanmean(values, axis=0), rtol=1e-13)
    np.testing.assert_array_equal(summary.median, np.nanmedian(values, axis=0))
    np.testing.assert_array_equal(summary.defined, np.isfinite(values).sum(axis=0))


def test_value_is_what_the_record_asks_for() -> None:
    """Separation is a median over the run, lost the last count, shoals a mean."""
    values = some_values(50, 1)
    summary = summarise(values)
    lost = values[:, 0, COLUMN["lost"]]
    assert summary.value[0, COLUMN["separation"]] == summary.median[0, COLUMN["separation"]]
    assert summary.value[0, COLUMN["shoals"]] == summary.mean[0, COLUMN["shoals"]]
    assert summary.value[0, COLUMN["lost"]] == lost[np.isfinite(lost)][-1]


def test_a_run_among_others_has_the_bits_of_a_run_alone() -> None:
    """Memory layout changes no sum."""
    values = some_values(300, 40)
    together, alone = summarise(values), summarise(np.ascontiguousarray(values[:, 7:8]))
    assert together.mean[7].tobytes() == alone.mean[0].tobytes()
    assert together.median[7].tobytes() == alone.median[0].tobytes()


@pytest.mark.parametrize("most", [1, 7 * 8 * 300 + 1, 1 << 23])
def test_values_in_a_file_have_the_bits_of_those_in_memory(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, most: int
) -> None:
    """Whether metrics are summed up one by one, by the seven, or all at once."""
    monkeypatch.setattr(summaries, "_MOST_IN_MEMORY", most)
    values = some_values(300, 1)
    filed = np.memmap(tmp_path / "values", np.float64, "w+", 0, values.shape)
    filed[:] = values
    there, here = summarise(filed), summarise(values)
    for part in ("value", "mean", "median", "defined"):
        assert getattr(there, part).tobytes() == getattr(here, part).tobytes()


def test_one_metric_has_the_bits_of_all() -> None:
    """A mean, a median and a last value."""
    values = some_values(300, 1)
    whole = summarise(values).value[0]
    assert [summary_of(name, values[:, 0, column]) for name, column in COLUMN.items()] == whole.tolist()


def test_no_moments_give_no_numbers() -> None:
    """A run without ticks has neither mean nor median."""
    summary = summarise(np.empty((0, 1, len(METRICS))))
    assert np.isnan(summary.value).all()
    assert (summary.defined == 0).all()
