"""The small drawing of tracks that a notebook shows."""

from __future__ import annotations

from xml.etree import ElementTree

import numpy as np
import pytest

from cocorosim_ros.study.pictures.sketch import WIDTH, tracks_sketch


def drawn(places: dict[str, np.ndarray[tuple[int, int], np.dtype[np.float64]]]) -> list[tuple[str, np.ndarray]]:
    """Name and points (n, 2) [px] of each line."""
    svg = ElementTree.fromstring(tracks_sketch(places).partition("<div>")[0])
    return [
        (way.findtext("title") or "", np.array([point.split(",") for point in line.split()], dtype=float))
        for way in svg
        for line in [way.find("polyline").attrib["points"]]  # type: ignore[union-attr]
    ]


def test_x_goes_right_and_y_goes_up_by_one_scale() -> None:
    """A way of 2 m east and then 1 m north fills the width, and rises by half of what it goes."""
    ((name, line),) = drawn({"a<b": np.array([[0.0, 0.0, -1.0], [2.0, 0.0, -1.0], [2.0, 1.0, -2.0]])})
    assert name == "a<b"
    east, north = np.diff(line, axis=0)
    assert east == pytest.approx([WIDTH - 24.0, 0.0], abs=0.1)
    assert north == pytest.approx([0.0, -(WIDTH - 24.0) / 2], abs=0.1), "upwards is less in a picture"


def test_gaps_are_left_out_and_long_ways_are_thinned() -> None:
    """No NaN is drawn; of ten thousand points first and last stay; where nobody is, nothing is drawn."""
    long = np.column_stack([np.linspace(0.0, 1.0, 10_000), np.zeros(10_000)])
    long[5] = np.nan
    ((_, line),) = drawn({"far": long, "nowhere": np.full((3, 3), np.nan)})
    assert len(line) <= 400
    assert line[-1, 0] - line[0, 0] == pytest.approx(WIDTH - 24.0, abs=0.1)
    assert tracks_sketch({"nowhere": np.full((3, 3), np.nan)}) == ""


def test_a_robot_at_rest_is_a_point() -> None:
    """What it trembles by is not blown up to the width of the picture."""
    ((_, line),) = drawn({"still": np.array([[1.0, 1.0], [1.001, 1.0]])})
    assert np.ptp(line, axis=0).max() < 10.0
