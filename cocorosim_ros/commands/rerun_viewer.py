"""Recordings as scenes for Rerun, and its viewer; Rerun is asked for when a scene is."""

from __future__ import annotations

import socket
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

from cocorosim_ros.commands.missing_package import check_installed
from cocorosim_ros.graph.runs.results import readable_scenario, scenario_facts
from cocorosim_ros.library.recording import Recording


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


def await_scene() -> str:
    """Start Rerun's viewer without a file, and give the address at which it waits for a scene."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    _start("--port", str(port), "--hide-welcome-screen")
    return f"rerun+http://127.0.0.1:{port}/proxy"


def open_viewer(file: Path) -> None:
    """Start Rerun's viewer on a file; it stays when this process ends."""
    _start(str(file))


def _start(*arguments: str) -> None:
    subprocess.Popen(
        [sys.executable, "-m", "rerun", *arguments],
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        start_new_session=True,
    )
