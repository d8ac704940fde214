"""The log of the tutorial "Your robot's log", without its map: what is guessed of it is what was recorded."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from cocorosim_ros.graph.runs.in_process import run_in_process
from cocorosim_ros.library.convert import convert
from cocorosim_ros.library.guess import guess
from cocorosim_ros.library.record import new_record
from cocorosim_ros.library.recording import read_recording
from cocorosim_ros.world.checks.loading import load_scenario


def test_the_guessed_map_gives_the_recording_back(tmp_path: Path) -> None:
    """Places, headings and commands, although a Lily slips so much that its motion tells no bearing from a yaw."""
    scenario = load_scenario("weak_thruster")
    record = new_record(scenario, tmp_path / "bag")
    run_in_process(scenario, record)
    record.close()
    recorded = read_recording(tmp_path / "bag")
    track, commands = recorded.tracks["lily_01"], recorded.readings["lily_01"]["thruster_command"]
    columns = {
        "time": track.time,
        **dict(zip(("x", "y"), track.position.T, strict=False)),
        "depth": -track.position[:, 2],
        "heading": (90.0 - np.degrees(track.yaw)) % 360.0,
        **{name: commands.column(name) for name in ("left", "right", "buoyancy")},
    }
    table = np.column_stack(list(columns.values()))
    np.savetxt(tmp_path / "log.csv", table, delimiter=",", header=",".join(columns), comments="")
    doubts = guess(tmp_path / "log.csv", tmp_path / "guessed.yaml").doubts
    assert any("which way 'heading' counts" in sentence for sentence in doubts)
    guessed = convert(tmp_path / "guessed.yaml", tmp_path / "log.csv", tmp_path / "out").recordings[0].read()
    assert guessed.tracks["vehicle"].position == pytest.approx(track.position, abs=1e-9)
    assert np.exp(1j * guessed.tracks["vehicle"].yaw) == pytest.approx(np.exp(1j * track.yaw), abs=1e-9)
    for name in ("left", "right", "buoyancy"):
        again = guessed.readings["vehicle"]["thruster_command"].column(name)
        assert again == pytest.approx(commands.column(name), abs=1e-12)
