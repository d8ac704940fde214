"""A robot of a recording as the filter takes it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from cocorosim_ros.diagnosis.tracks.columns import COLUMN
from cocorosim_ros.diagnosis.tracks.make_tracks import make_tracks
from cocorosim_ros.scenario.parts.platform import load_platform


def test_a_robot_begins_with_its_own_numbers(swim: Callable[..., Any]) -> None:
    """What the platform's file says of this robot alone replaces what it says of all."""
    lily = load_platform("lily")
    other = replace(lily, robots={"lily_01": replace(lily, drag=2.5), "lily_02": replace(lily, drag=3.5)})
    (track,) = make_tracks(swim(lily, 20.0, base=other))
    assert track.vehicle.nominal[COLUMN["drag"]] == 2.5
