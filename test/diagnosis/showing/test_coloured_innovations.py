"""Predictions that err not at random are said once for each robot, with the worst of its recordings."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np

from cocorosim_ros.diagnosis.filter.layout import COMPASS, POSE_X
from cocorosim_ros.diagnosis.showing.coloured_innovations import coloured_innovations

COUNT = 200


def case(*recordings: tuple[str, float, float]) -> Any:
    """A finished fit: for each recording the robot, and by what share of the expected its place and compass err."""
    rng = np.random.default_rng(0)
    kind = np.repeat([POSE_X, COMPASS], COUNT)
    tracks, passes = [], []
    for robot, of_place, of_compass in recordings:
        noise = rng.standard_normal((2, COUNT))
        noise /= np.sqrt((noise**2).mean(axis=1, keepdims=True))
        sizes = (np.array([[of_place], [of_compass]]) * noise).ravel()
        tracks.append(SimpleNamespace(name=robot, timeline=SimpleNamespace(kind=kind)))
        everything = np.ones(2 * COUNT, dtype=bool)
        passes.append(SimpleNamespace(innovation=sizes, variance=np.ones(2 * COUNT), believed=everything))
    return SimpleNamespace(final=SimpleNamespace(tracks=tracks, passes=passes))


def test_each_robot_is_said_once_with_the_worst_of_its_recordings() -> None:
    """Three of four recordings of one robot err; the other robot does not; readings are called by words."""
    found = case(("blimp", 3.0, 1.0), ("blimp", 5.0, 4.0), ("ship", 1.0, 1.0), ("blimp", 1.0, 3.0), ("blimp", 1.0, 1.0))
    (told,) = coloured_innovations(found)
    assert told.robots == ("blimp",)
    assert "of blimp errs not at random, in 3 of its 4 recordings, at most: " in told.sentence
    assert "the pose along x by 5 times" in told.sentence and "the compass by 4 times" in told.sentence
    assert "_" not in told.sentence and told.sentence.endswith("; something is still missing.")


def test_the_only_recording_is_not_counted() -> None:
    """Nothing is said of how many, and nothing of readings that err as expected."""
    (told,) = coloured_innovations(case(("ship", 3.0, 1.0)))
    assert "errs not at random: the pose along x by 3 times" in told.sentence and "compass" not in told.sentence
    assert list(coloured_innovations(case(("ship", 1.0, 1.0)))) == []
