"""Recordings as scenes for Rerun, and its viewer; Rerun is asked for when a scene is."""

from __future__ import annotations

import socket
import subprocess
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from cocorosim_ros.commands.missing_package import check_installed
from cocorosim_ros.graph.runs.results import readable_scenario, scenario_facts
from cocorosim_ros.library.recording import Recording

HERE = "127.0.0.1"
PATIENCE = 3.0  # s that a viewer on a file gets to fail; one without a display needs half of that


def write_scenes(recordings: Sequence[Recording], file: Path) -> None:
    """Write one recording, or two side by side, as a Rerun recording.

    Raises CocorosimError if rerun-sdk is not installed, or the file cannot be written.
    """
    check_installed(("rerun",), "leave out --3d for a page that needs nothing")
    from cocorosim_ros.study.scene.gathering import gather_scene
    from cocorosim_ros.study.scene.rerun_file import write_rerun

    scenes = [
        gather_scene(each.bag, each.tracks, scenario_facts(each.bag), readable_scenario(each.bag)[0])
        for each in recordings
    ]
    write_rerun(scenes, file)


@dataclass
class WaitingViewer:
    """Rerun's viewer, which waits for a scene at an address."""

    address: str
    process: subprocess.Popen[bytes]
    _told: bool = False

    def complaint(self) -> str:
        """Sentence, once, if the viewer has ended by a fault; "" else. To close its window is no fault."""
        status = self.process.poll()
        if self._told or not status:
            return ""
        self._told = True
        return _ended(status, "the run goes on, and `cocorosim view --3d` shows its recording")


def _ended(status: int, instead: str) -> str:
    return f"Rerun's viewer ended with status {status}, as it does where there is no display; {instead}."


def await_scene() -> WaitingViewer:
    """Start Rerun's viewer without a file; it hears this machine alone."""
    with socket.socket() as free:
        free.bind((HERE, 0))
        port = free.getsockname()[1]
    process = _start("--bind", HERE, "--port", str(port), "--hide-welcome-screen")
    return WaitingViewer(f"rerun+http://{HERE}:{port}/proxy", process)


def open_viewer(file: Path) -> str:
    """Start Rerun's viewer on a file; it stays when this process ends. Sentence if it fails at once; "" else."""
    process = _start("--bind", HERE, str(file))
    try:
        status = process.wait(PATIENCE)
    except subprocess.TimeoutExpired:
        return ""
    way_out = f"look at {file} where there is one, or in a browser by `rerun --web-viewer --bind {HERE} {file}`"
    return _ended(status, way_out) if status else ""


def _start(*arguments: str) -> subprocess.Popen[bytes]:
    return subprocess.Popen(
        [sys.executable, "-m", "rerun", *arguments],
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        start_new_session=True,
    )
