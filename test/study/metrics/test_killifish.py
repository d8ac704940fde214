"""A shoal of real fish: the polarisation that its authors published.

Jhawar et al., Nature Physics 2020. Each row of the tracks holds a fish's position and its position in the
frame before, in pixels; the authors' direction is that displacement, a fish at rest counts with a zero
vector, and one without a previous position does not count. Two frames are the authors' own edge effects: in
the first frame the previous positions are written as zero, so that its "directions" are the positions
themselves, and the last frame was not evaluated (its published polarisation is not a number).
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from cocorosim_ros.study.metrics import COLUMN
from cocorosim_ros.study.metrics.shoal_monitor import ShoalMonitor

FOLDER = Path(__file__).resolve().parents[4] / "shared" / "data" / "killifish"
FRAMES = 247

pytestmark = pytest.mark.skipif(not FOLDER.is_dir(), reason="the killifish recording is not on this machine")


def read(name: str) -> NDArray[np.void]:
    """A table of the recording."""
    return np.genfromtxt(FOLDER / name, delimiter=",", names=True)


@pytest.fixture(scope="module")
def polarisation() -> NDArray[np.float64]:
    """(frames,) direction-of-travel polarisation, computed by our metric from the frames' displacements."""
    rows = read("rawdata_track.csv")
    return np.array([_of_frame(rows[rows["frame"] == frame]) for frame in range(1, FRAMES + 1)])


def _of_frame(rows: NDArray[np.void]) -> float:
    monitor = ShoalMonitor(rows.size)
    level, heading = np.zeros(rows.size), np.zeros(rows.size)
    before = np.column_stack([rows["prev_x"], rows["prev_y"], level])
    now = np.column_stack([rows["col_x"], rows["row_y"], level])
    monitor.update(0, before, heading)
    return float(monitor.update(1, now, heading)[COLUMN["polarisation_travel"]])


def test_published_polarisation_is_recomputed(polarisation: NDArray[np.float64]) -> None:
    """All 246 evaluated frames agree to rounding."""
    published = read("rawdata_track_published_order_parameter.csv")["polarization"]
    np.testing.assert_allclose(polarisation[: FRAMES - 1], published[: FRAMES - 1], rtol=0, atol=1e-12)


def test_the_last_frame_was_not_published(polarisation: NDArray[np.float64]) -> None:
    """The only frame without a published value is the last one, for which our metric has one."""
    published = read("rawdata_track_published_order_parameter.csv")["polarization"]
    np.testing.assert_array_equal(np.flatnonzero(np.isnan(published)), [FRAMES - 1])
    assert 0.0 < polarisation[-1] < 1.0


def test_the_first_frame_is_made_of_positions() -> None:
    """Its previous positions are all zero, so that its polarisation near 1 says nothing about the fish."""
    first = read("rawdata_track.csv")
    first = first[first["frame"] == 1]
    assert (first["prev_x"] == 0).all()
    assert (first["prev_y"] == 0).all()
