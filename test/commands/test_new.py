"""`cocorosim new`: files to begin with, which work as they are."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from cocorosim_ros.library.beginning import KINDS, begin_file
from cocorosim_ros.library.scenario import load_scenario
from cocorosim_ros.scenario.parts.platform import load_platform
from cocorosim_ros.scenario.parts.python_controller import PythonController
from cocorosim_ros.wire.bags.bag_reader import read_bag
from cocorosim_ros.world.controllers.plain.plain_controller import rehearse_plain
from cocorosim_ros.world.vehicle_model.platform_effects import check_platform

Run = Callable[..., SimpleNamespace]


def test_the_scenario_passes_all_checks(cocorosim: Run, tmp_path: Path) -> None:
    """A new scenario has the name that was given, and can be run."""
    file = tmp_path / "pond.yaml"
    assert cocorosim("new", "scenario", "pond", "--out", file).status == 0
    scenario = load_scenario(file)
    assert scenario.name == "pond"
    assert len(scenario.robots) == 5


def test_the_platform_passes_all_checks(tmp_path: Path) -> None:
    """A new platform is one body with known effects, and neutral in its water."""
    platform = load_platform(begin_file("platform", "boat", tmp_path / "boat.yaml"))
    check_platform(platform)
    (pump,) = [each for each in platform.actuators if each.name == "pump"]
    assert platform.mass == pytest.approx(platform.water_density * pump.neutral_volume)
    assert {"mass", "drag", "actuators.left.maximum"} <= platform.ranges.keys()


def test_the_controller_swims(tmp_path: Path) -> None:
    """A new controller can be made for every robot and answers the first tick."""
    file = begin_file("controller", "shy_fish", tmp_path / "shy_fish.py")
    scenario = load_scenario("five_lilys", controller=f"{file}:ShyFish")
    rehearse_plain(scenario.robots, scenario.seed)
    assert all(isinstance(robot.controller, PythonController) for robot in scenario.robots)


def test_the_map_converts_a_log(cocorosim: Run, tmp_path: Path) -> None:
    """A new map reads the log that its comment describes."""
    begin_file("map", "boat_log", tmp_path / "boat_log.yaml")
    rows = np.column_stack(
        [np.arange(20) * 0.1, np.linspace(0, 1, 20), np.zeros((20, 2)), np.full(20, 90.0), np.ones((20, 2))]
    )
    np.savetxt(tmp_path / "trial.csv", rows, delimiter=",", header="t,x,y,depth,yaw,left,right", comments="")
    done = cocorosim("convert", tmp_path / "boat_log.yaml", tmp_path / "trial.csv", "--out", tmp_path / "bag")
    assert done.status == 0, done.err
    assert read_bag(tmp_path / "bag").summary.counts == {"/vehicle/pose": 20, "/vehicle/thruster_command": 20}


@pytest.mark.parametrize("kind", KINDS)
def test_nothing_is_overwritten(cocorosim: Run, tmp_path: Path, kind: str) -> None:
    """A file that is there stays unless --force is given."""
    file = tmp_path / f"mine{KINDS[kind]}"
    file.write_text("precious")
    refused = cocorosim("new", kind, "mine", "--out", file)
    assert (refused.status, file.read_text()) == (2, "precious")
    assert "--force" in refused.err
    assert cocorosim("new", kind, "mine", "--out", file, "--force").status == 0
    assert "mine" in file.read_text()


def test_names_that_are_none(cocorosim: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A name that could be no robot's or file's is refused in a sentence, and nothing is written."""
    monkeypatch.chdir(tmp_path)
    for name in ("My Boat", "../boat", "boat.yaml", "2boats"):
        done = cocorosim("new", "platform", name)
        assert done.status == 2
        assert "is no name of a platform" in done.err
    assert cocorosim("new", "elephant", "boat").status == 2
    assert list(tmp_path.iterdir()) == []
