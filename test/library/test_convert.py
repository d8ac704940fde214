"""Conversions: what was made, topic by topic, and what is refused."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import cocorosim_ros as cocorosim

MAP = """
name: boats
format: csv
tables:
  - files: "{run}.csv"
    time: {column: t, unit: s}
    robot: boat
    streams:
      pose:
        x: {column: x, unit: mm}
        y: {column: y, unit: mm}
        z: {fixed: 0 m}
        yaw: {column: h, unit: deg}
"""
ROWS = "t,x,y,h\n0,0,0,0\n1,1000,0,90\n3,2000,nan,90\n4,3000,500,180\n"


@pytest.fixture
def log(tmp_path: Path) -> tuple[Path, Path]:
    """A map and a folder with the logs of two runs, in each a row without a number."""
    (tmp_path / "boats.yaml").write_text(MAP, "utf-8")
    (tmp_path / "logs").mkdir()
    for run in ("one", "two"):
        (tmp_path / "logs" / f"{run}.csv").write_text(ROWS, "utf-8")
    return tmp_path / "boats.yaml", tmp_path / "logs"


def test_recordings_of_several_runs(log: tuple[Path, Path], tmp_path: Path) -> None:
    """Each run is a recording of its own; its extent is counted, and what was left out is said."""
    told: list[str] = []
    done = cocorosim.convert(*log, tmp_path / "out", progress=told.append)
    assert told == ["one", "two"]
    assert [made.folder.name for made in done.recordings] == ["one", "two"]
    first = done.recordings[0]
    (extent,) = first.topics
    assert (extent.robot, extent.topic, extent.messages, first.messages) == ("boat", "pose", 3, 3)
    assert (extent.duration, extent.rate, extent.longest_gap) == (4.0, 0.5, 3.0)
    assert "1 row with missing or infinite numbers was left out" in first.findings[0]
    assert done.findings == tuple(f"{name}: {first.findings[0].replace('one', name)}" for name in ("one", "two"))
    track = first.read().tracks["boat"]
    assert track.position[:, 0].tolist() == [0.0, 1.0, 3.0]
    assert first.read().digest == first.digest


def test_frame_and_card(log: tuple[Path, Path], tmp_path: Path, parse: Callable[[str], Any]) -> None:
    """One row a topic in both."""
    done = cocorosim.convert(log[0], log[1] / "one.csv", str(tmp_path / "out"))
    assert done.to_frame().to_dict("list") == {
        "recording": ["out"],
        "robot": ["boat"],
        "topic": ["pose"],
        "messages": [3],
        "duration": [4.0],
        "rate": [0.5],
        "longest_gap": [3.0],
    }
    page = parse(done._repr_html_())
    assert {"conversion by boats", "boat", "pose", "3", "0.5"} <= set(page.cells)
    assert done.findings[0] in page.cells
    assert repr(done) == "<conversion by boats: recordings 1, messages 3>"


def test_what_is_there_stays_unless_forced(log: tuple[Path, Path], tmp_path: Path) -> None:
    """A recording that exists is refused; an unknown map is named; nothing is left behind."""
    done = cocorosim.convert(*log, tmp_path / "out")
    with pytest.raises(cocorosim.CocorosimError, match="exists already"):
        cocorosim.convert(*log, tmp_path / "out")
    again = cocorosim.convert(*log, tmp_path / "out", force=True)
    assert [made.digest for made in again.recordings] == [made.digest for made in done.recordings]
    with pytest.raises(cocorosim.CocorosimError, match="'ships' is the name of no map"):
        cocorosim.convert("ships", log[1], tmp_path / "none")
    with pytest.raises(cocorosim.CocorosimError):
        cocorosim.convert(log[0], tmp_path / "absent", tmp_path / "none")
    assert not (tmp_path / "none").exists()
