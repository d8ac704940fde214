"""What a page of many poses takes while it is written, and what is loaded for it."""

from __future__ import annotations

import subprocess
import sys
import tracemalloc

import numpy as np

from cocorosim_ros.study.pictures.facts import ScenarioFacts
from cocorosim_ros.study.pictures.player import page_pieces
from cocorosim_ros.world.state.pose_track import PoseTrack

ROBOTS, POSES = 20, 10_000


def test_one_robot_after_the_other_is_written() -> None:
    """A page of 4 MB takes half of it at most; as one text it took it several times."""
    stamps, places = np.arange(POSES) * 1_000_000_000, np.random.default_rng(1).normal(size=(POSES, 3))
    tracks = {f"fish_{number}": PoseTrack(stamps, places, places[:, 0]) for number in range(ROBOTS)}
    written = sum(len(piece) for piece in page_pieces(tracks, ScenarioFacts("fish")))  # jinja keeps the template
    tracemalloc.start()
    try:
        assert sum(len(piece) for piece in page_pieces(tracks, ScenarioFacts("fish"))) == written > 4e6
        most = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    assert most < 0.5 * written


def test_nothing_that_draws_is_loaded() -> None:
    """A page needs colours, and no axes: 15 MB and a quarter of a second less."""
    loaded = "cocorosim_ros.study.pictures.player, cocorosim_ros.graph.runs.results"
    code = f"import sys, {loaded}; sys.exit('matplotlib.axes' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0
