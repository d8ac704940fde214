"""Rerun's viewer beside a run: one that ends by a fault is said, and the run goes on."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from cocorosim_ros.commands.rerun_viewer import WaitingViewer

Command = Callable[..., Any]
SHIPPED = Path(__file__).parents[2] / "bags" / "five_lilys"
NOBODY = "rerun+http://127.0.0.1:9/proxy"


def ended(status: int) -> WaitingViewer:
    """A viewer that has ended with this status."""
    process = subprocess.Popen([sys.executable, "-c", f"raise SystemExit({status})"])
    process.wait()
    return WaitingViewer(NOBODY, process)


def test_a_viewer_that_fails_is_said_once() -> None:
    """With its status and what to do instead; one whose window was closed, and one that is open, are no fault."""
    failed = ended(3)
    assert "ended with status 3" in failed.complaint() and failed.complaint() == ""
    assert ended(0).complaint() == ""
    process = subprocess.Popen([sys.executable, "-c", "input()"], stdin=subprocess.PIPE)
    assert WaitingViewer(NOBODY, process).complaint() == ""
    process.communicate(b"\n")


def test_the_run_goes_on_without_its_viewer(
    cocorosim: Command, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """All ticks are recorded, and the sentence stands once in the output."""
    pytest.importorskip("rerun")
    monkeypatch.setattr("cocorosim_ros.commands.rerun_viewer.await_scene", lambda: ended(1))
    result = cocorosim("run", "one_lily", "--in-process", "--view", "--duration", "5 s", "--out", tmp_path / "run")
    assert result.status == 0, result.err
    told = " ".join((result.out + result.err).split())
    assert told.count("Rerun's viewer ended with status 1") == 1
    assert "`cocorosim view --3d` shows its recording" in told
    assert (tmp_path / "run" / "bag").is_dir()


def test_a_scene_whose_viewer_fails_is_there(
    cocorosim: Command, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """view --3d has written its file; that nothing shows it is said, with the file and how a browser does."""
    pytest.importorskip("rerun")
    monkeypatch.setattr("cocorosim_ros.commands.rerun_viewer._start", lambda *_: ended(1).process)
    scene = tmp_path / "scene.rrd"
    result = cocorosim("view", SHIPPED, "--3d", "--out", scene)
    assert result.status == 0, result.err
    told = " ".join(result.out.split())
    assert told.count("Rerun's viewer ended with status 1") == 1
    assert f"rerun --web-viewer --bind 127.0.0.1 {scene}" in told
    assert scene.is_file()
