"""The tank that is assumed around recorded poses: none where the hull could not come near its walls."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.tracks.make_tracks import introduced
from cocorosim_ros.diagnosis.tracks.surroundings import FAR

PLACES = np.column_stack([np.linspace(-2.0, 2.0, 200), np.linspace(-1.0, 1.0, 200), np.zeros(200), np.zeros(200)])


def water_of(width: float, *, dives: bool) -> Any:
    """The surroundings of a robot of this width and 0.07 m of height, that dives to a metre or stays 0.5 m deep."""
    pose = PLACES.copy()
    pose[:, 2] = -0.5 + (0.5 * np.sin(np.arange(200) / 9.0) if dives else 0.0)
    found: list[Any] = []
    track = SimpleNamespace(
        vehicle=SimpleNamespace(width=width, height=0.07),
        log=SimpleNamespace(streams={"pose": SimpleNamespace(value=pose)}),
        among=lambda water: found.append(water) or SimpleNamespace(),
    )
    introduced([track])  # type: ignore[list-item]
    (water,) = found
    return water


def test_a_small_hull_swims_in_a_tank() -> None:
    """A tenth of a metre beyond the farthest places on all sides, and the surface above it."""
    water = water_of(0.1, dives=True)
    np.testing.assert_allclose(water.upper, [2.1, 1.1, 0.0])
    np.testing.assert_allclose(water.lower[:2], [-2.1, -1.1])
    assert water.lower[2] == pytest.approx(-1.1, abs=0.01)


def test_a_wide_hull_has_no_walls_around_it() -> None:
    """Its side would stand in a wall a tenth of a metre from its middle; the surface is where it is."""
    water = water_of(0.9, dives=True)
    assert (water.lower == -FAR).all() and (water.upper == [FAR, FAR, 0.0]).all()


@pytest.mark.parametrize("width", [0.1, 0.9])
def test_what_keeps_its_depth_has_no_surface(width: float) -> None:
    """The surface is as near at all times, so that what it does to the drag is in the drag."""
    assert water_of(width, dives=False).upper[2] == FAR


def test_a_recording_without_robots_has_no_water() -> None:
    """Nothing stands in it, and nothing fails: of some of a day's drives no readings are left."""
    assert introduced([]) == []
