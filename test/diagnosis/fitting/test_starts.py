"""Starts of fits where the likelihood is flat but near the truth, as that of a scale by exact readings."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES
from cocorosim_ros.diagnosis.fitting.candidate import Candidate
from cocorosim_ros.diagnosis.fitting.starts import best_start
from cocorosim_ros.foundation.arrays import Floats

WIDTH = 0.4  # of q: farther away all readings lie beyond the gate


def candidate(effect: str, topic: str) -> Candidate:
    """An entry of the catalogue for one robot."""
    entry = next(each for each in ENTRIES if (each.id, each.topic) == (effect, topic))
    return Candidate(entry, ("a",), ((0,),))


def flat_but_at(truth: float) -> Any:
    """Makes fits of one number, whose objective grows within WIDTH of the truth alone."""

    def fit(q: Floats) -> Any:
        return SimpleNamespace(objective=-min(abs(float(q[0]) - truth), WIDTH), q=q)

    return fit


@pytest.mark.parametrize("scale", ["camera_scale pose", "speed_log_scale velocity"])
@pytest.mark.parametrize("truth", [-3.3, -1.4, 0.8, 2.6, 3.9])
def test_a_scale_is_found_where_its_slope_leads_nowhere(scale: str, truth: float) -> None:
    """To an eighth of a spacing by the grid; the slope promised a tenth of it, where it is as flat as at zero."""
    each = candidate(*scale.split())
    found: Any = best_start(flat_but_at(truth), np.array([0.1 * truth]), each)
    assert float(found.q[0]) == pytest.approx(truth, abs=0.13)


def test_what_has_no_grid_begins_where_its_slope_leads() -> None:
    """An offset, whose likelihood bends evenly; delays have the grid that they are searched by."""
    offset, late = candidate("pressure_offset", "pressure"), candidate("sensor_latency", "pose")
    assert offset.starts() == []
    assert [q.tolist() for q in late.starts()] == [q.tolist() for q in late.searched()] != []
