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


def test_a_platform_for_the_robot_of_a_recording(cocorosim: Run, tmp_path: Path) -> None:
    """Its actuators are those that the recording commands, by their names, and its sensors those recorded."""
    log, table = tmp_path / "map.yaml", tmp_path / "drive.csv"
    names = ("port_esc", "thr_starboard", "Vertical", "ballast_tank", "rudder", "stern_planes")
    limits = '{column: %s, unit: "1", stop: 0, forward: 1, reverse: -1}'
    commands = "".join(f"        {name}: {limits % name}\n" for name in names)
    log.write_text(
        "name: log\nformat: csv\ntables:\n  - files: drive.csv\n    time: {column: t, unit: s}\n    robot: boat\n"
        "    streams:\n      compass: {heading: {column: yaw, unit: rad}}\n"
        f"      thruster_command:\n{commands}"
    )
    rows = np.column_stack([np.arange(20) * 0.1, np.linspace(0, 1, 20), np.full((20, len(names)), 0.5)])
    np.savetxt(table, rows, delimiter=",", header=",".join(("t", "yaw", *names)), comments="")
    made = cocorosim("convert", log, table, "--out", tmp_path / "bag")
    assert made.status == 0, made.err
    done = cocorosim("new", "platform", "boat", "--for", tmp_path / "bag", "--out", tmp_path / "boat.yaml")
    assert done.status == 0, done.err
    assert f"diagnose {tmp_path / 'bag'} --platform" in done.out
    platform = load_platform(str(tmp_path / "boat.yaml"))
    check_platform(platform)
    kinds = {each.name: each.kind for each in platform.actuators}
    assert list(kinds.values()) == ["thruster", "thruster", "thruster", "buoyancy", "rudder", "fin"]
    port, starboard, vertical = platform.actuators[:3]
    assert (port.position[1], starboard.position[1]) == (0.15, -0.15)  # y points to the left
    assert (port.direction, vertical.direction) == ((1, 0, 0), (0, 0, 1))
    assert platform.actuators[5].direction == (0, 0, 1)
    assert (platform.sensors.compass, platform.sensors.pressure, platform.sensors.imu) == (True, False, False)


def test_a_recording_that_tells_no_actuators(cocorosim: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """One sentence for a recording without commands, and for a kind that no recording tells; nothing is written."""
    monkeypatch.chdir(tmp_path)
    table, log = tmp_path / "drive.csv", tmp_path / "map.yaml"
    table.write_text("t,yaw\n0,0.1\n1,0.2\n2,0.3\n")
    log.write_text(
        "name: log\nformat: csv\ntables:\n  - files: drive.csv\n    time: {column: t, unit: s}\n    robot: boat\n"
        "    streams:\n      compass: {heading: {column: yaw, unit: rad}}\n"
    )
    assert cocorosim("convert", log, table, "--out", "bag").status == 0
    done = cocorosim("new", "platform", "boat", "--for", "bag")
    assert (done.status, done.err.count("\n")) == (2, 1)
    assert "holds no thruster_command (it has compass)" in done.err
    assert "does not follow from a recording" in cocorosim("new", "map", "boat", "--for", "bag").err
    assert not list(tmp_path.glob("boat*"))


@pytest.mark.parametrize("sticks", [("surge", "yaw"), ("heave",)])
def test_sticks_are_no_actuators(cocorosim: Run, tmp_path: Path, sticks: tuple[str, ...]) -> None:
    """A log of sticks tells of no thruster; the sentence points to what a platform says of sticks."""
    log, table = tmp_path / "map.yaml", tmp_path / "drive.csv"
    limits = '{column: %s, unit: "1", stop: 0, forward: 1, reverse: -1}'
    commands = "".join(f"        {name}: {limits % name}\n" for name in sticks)
    log.write_text(
        "name: log\nformat: csv\ntables:\n  - files: drive.csv\n    time: {column: t, unit: s}\n    robot: boat\n"
        f"    streams:\n      thruster_command:\n{commands}"
    )
    rows = "".join(f"{0.1 * k:g}{',0.5' * len(sticks)}\n" for k in range(20))
    table.write_text(f"{','.join(('t', *sticks))}\n{rows}")
    assert cocorosim("convert", log, table, "--out", tmp_path / "bag").status == 0
    done = cocorosim("new", "platform", "boat", "--for", tmp_path / "bag", "--out", tmp_path / "boat.yaml")
    assert (done.status, done.err.count("\n")) == (2, 1)
    assert f"of {' and '.join(sticks)}, which are sticks and no actuators" in done.err
    assert "'mixing'" in done.err
    assert not (tmp_path / "boat.yaml").exists()
