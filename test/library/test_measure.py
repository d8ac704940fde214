"""Statistics of recordings, tracks and plain lists: the numbers of the command, and of closed forms."""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

import cocorosim_ros as cocorosim
from cocorosim_ros.study.metrics import sampling
from cocorosim_ros.wire.bags import kept_poses

TIME = [0.0, 0.5, 1.0]
ABREAST = [[[0.05 * t, 0.0, -1.0], [0.05 * t, 0.3, -1.0]] for t in TIME]
AHEAD = [[0.0, 0.0]] * 3


@pytest.fixture
def written(cocorosim: Callable[..., SimpleNamespace], shipped: Path, tmp_path: Path) -> Any:
    """What `cocorosim metrics --json` writes about the recording that comes along."""
    ended = cocorosim("metrics", shipped, "--json", tmp_path / "m.json")
    assert ended.status == 0, ended.err
    return json.loads((tmp_path / "m.json").read_text("utf-8"))


def test_a_recording_gives_what_the_command_writes(written: Any, shipped: Path) -> None:
    """By path and as a record, every key and number."""
    for source in (shipped, str(shipped), cocorosim.read_recording(shipped)):
        assert cocorosim.measure(source).tree() == written
    metrics = json.loads((shipped / "metrics.json").read_text("utf-8"))["metrics"]
    assert list(written["metrics"]) == list(metrics)
    for name, each in metrics.items():  # made on another version of NumPy, whose sums differ in the last digits
        assert written["metrics"][name]["value"] == pytest.approx(each["value"], rel=1e-12), name


def test_tracks_and_arrays_give_the_same_numbers(written: Any, shipped: Path) -> None:
    """The poses of the recording as tracks, as arrays and as lists, in any order of the robots."""
    tracks = cocorosim.read_recording(shipped).tracks
    assert cocorosim.measure(tracks).tree()["metrics"] == written["metrics"]
    names = list(reversed(tracks))
    time = tracks[names[0]].time
    position = np.stack([tracks[name].position for name in names], axis=1)
    yaw = np.stack([tracks[name].yaw for name in names], axis=1)
    for given in ((time, position, yaw), (time.tolist(), position.tolist(), yaw.tolist())):
        measured = cocorosim.measure(*given, robots=names)
        assert measured.robots == tuple(sorted(names))
        assert measured.tree()["metrics"] == written["metrics"]


def test_a_recording_is_the_same_in_parts(monkeypatch: pytest.MonkeyPatch, shipped: Path) -> None:
    """Poses in a file, decoded and measured by the dozen, give the numbers of the poses in memory, to the last bit."""
    in_memory = cocorosim.read_recording(shipped)
    assert in_memory.tracks
    monkeypatch.setattr(kept_poses, "MESSAGES_AT_ONCE", 12)
    monkeypatch.setattr(sampling, "POSES_AT_ONCE", 12)
    for interval in (None, "0.3 s"):
        kept = cocorosim.read_recording(shipped)
        whole, parts = in_memory.measure(interval), kept.measure(interval)
        assert "_poses" not in vars(kept)
        assert parts.tree() == whole.tree()
        assert parts.series.tobytes() == whole.series.tobytes()


def test_two_robots_abreast() -> None:
    """0.3 m apart, both ahead at 0.05 m/s: polarisation 1, one shoal, at each moment and for the run."""
    measured = cocorosim.measure(TIME, ABREAST, AHEAD)
    assert measured.robots == ("robot_1", "robot_2")
    assert measured.time.tolist() == TIME
    assert measured["polarisation"].tolist() == [1.0, 1.0, 1.0]
    np.testing.assert_allclose(measured["separation"], 0.3, rtol=1e-15)
    assert math.isnan(measured["shoal_speed"][0])
    np.testing.assert_allclose(measured["shoal_speed"][1:], 0.05, rtol=1e-12)
    assert measured.values["shoals"] == 1.0
    assert measured.series.shape == (3, len(measured.metrics))


def test_a_robot_with_a_nan_is_absent() -> None:
    """It is left out of that moment, and it is said."""
    position = np.array(ABREAST)
    position[1, 1] = math.nan
    measured = cocorosim.measure(TIME, position, AHEAD)
    assert np.isnan(measured["separation"]).tolist() == [False, True, False]
    assert "At 1 of 3 ticks a robot was absent" in measured.findings[0]


def test_an_interval_interpolates() -> None:
    """Straight ways measured twice as often have the same speed; text and number are the same interval."""
    for interval in ("0.25 s", 0.25):
        measured = cocorosim.measure(TIME, ABREAST, AHEAD, interval=interval)
        assert measured.time.tolist() == [0.0, 0.25, 0.5, 0.75, 1.0]
        np.testing.assert_allclose(measured["shoal_speed"][1:], 0.05, rtol=1e-12)


def test_frames(shipped: Path) -> None:
    """One row a moment, one column a metric; of the summary one row a metric, with unit and formula."""
    measured = cocorosim.measure(shipped)
    frame = measured.to_frame()
    assert list(frame.columns) == ["time", *measured.metrics]
    np.testing.assert_array_equal(frame["separation"].to_numpy(), measured["separation"])
    summary = measured.summary_frame().set_index("metric")
    assert list(summary.index) == list(measured.metrics)
    assert summary.loc["separation", "value"] == measured.values["separation"]
    assert (summary.loc["separation", "unit"], summary.loc["shoal_speed", "unit"]) == ("m", "m/s")
    assert summary.loc["separation", "formula"].startswith("median distance")


def test_it_shows_itself(parse: Callable[[str], Any]) -> None:
    """The paper's six; a number that was never defined is a dash."""
    measured = cocorosim.measure(TIME, np.array(ABREAST)[:, :1], np.zeros((3, 1)))
    page = parse(measured._repr_html_())
    assert {"polarisation", "shoal_speed", "lost", "-"} <= set(page.cells)
    assert math.isnan(measured.values["separation"])
    assert repr(measured) == "<shoaling statistics of arrays: robots 1, moments 3>"


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (([0.0, 0.5], ABREAST, AHEAD), r"'time' has the shape \(2,\); give \(3,\)"),
        ((TIME, np.zeros((3, 2)), AHEAD), r"'position' has the shape \(3, 2\); give \(t, robots, 3\)"),
        (
            (TIME, ABREAST, [0.0, 0.0, 0.0]),
            r"'position' has the shape \(3, 2, 3\); give \(t, robots, 3\) with a yaw of",
        ),
        ((TIME, np.zeros((3, 0, 3)), np.zeros((3, 0))), "'position' has the shape"),
        ((TIME, [["a"]], AHEAD), "'position' has .* which is no array of numbers"),
        (([0.0, [1.0, 2.0], 3.0], ABREAST, AHEAD), "'time' has .* which is no array of numbers"),
        (([0.0, 1.0, 0.5], ABREAST, AHEAD), "'time' does not grow"),
        (([0.0, 1.0, math.nan], ABREAST, AHEAD), "'time' has numbers that are not finite"),
        ((TIME, ABREAST), "give all three"),
        (({},), "No robot has a usable pose"),
        (("nowhere",), "nowhere does not exist"),
    ],
)
def test_what_does_not_fit_is_a_sentence(arguments: tuple[Any, ...], words: str) -> None:
    """One line that says what is wrong and what is wanted."""
    with pytest.raises(cocorosim.CocorosimError, match=words) as refused:
        cocorosim.measure(*arguments)
    assert "\n" not in str(refused.value)


def test_names_that_do_not_fit() -> None:
    """Names for the columns are as many as there are, and different; a metric's name is one of the table."""
    with pytest.raises(cocorosim.CocorosimError, match="'robots' names 1 robots; give 2 different names"):
        cocorosim.measure(TIME, ABREAST, AHEAD, robots=["a", "a"])
    with pytest.raises(cocorosim.CocorosimError, match="did you mean 'polarisation'"):
        cocorosim.measure(TIME, ABREAST, AHEAD)["polarization"]
