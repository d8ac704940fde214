"""A shift of all readings is one of the start, and tells nothing; what changes them in time does."""

from __future__ import annotations

import numpy as np
import pytest

from cocorosim_ros.diagnosis.against.starts import as_well


def test_what_a_start_gives_as_well_is_all_of_an_offset_and_a_part_of_a_drift() -> None:
    """A constant has no information left; of a slope in time that of the deviations from its mean is left."""
    time, variance = np.linspace(0.0, 10.0, 11), np.full(11, 0.5)
    moved = np.column_stack([np.ones(11), time])
    whole = moved.T @ moved / 0.5
    left = whole - as_well(np.column_stack([np.ones(11), np.zeros(11)]), moved, variance)
    assert left[0, 0] == pytest.approx(0.0, abs=1e-9)
    assert left[1, 1] == pytest.approx(float(np.sum((time - time.mean()) ** 2)) / 0.5)
