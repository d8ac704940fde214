"""Simulations as arrays: the numbers of the command's recording, one run or many, and what is refused."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import FrozenInstanceError
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cocorosim_ros as cocorosim

SCENARIO = "lilys_and_jeffs"


@pytest.fixture(scope="module")
def simulated() -> cocorosim.SimulatedRun:
    """The run of the fixture `commanded`, as arrays."""
    return cocorosim.simulate(SCENARIO, seed=7, duration=20.0)


def test_poses_are_those_of_the_commands_recording(simulated: cocorosim.SimulatedRun, commanded: Path) -> None:
    """Stamp by stamp, bit by bit, for every robot."""
    tracks = cocorosim.read_recording(commanded).tracks
    assert sorted(simulated.robots) == list(tracks)
    assert simulated.position.shape == (40, 9, 3)
    for robot, name in enumerate(simulated.robots):
        np.testing.assert_array_equal(simulated.stamp_ns, tracks[name].stamp_ns)
        assert simulated.position[:, robot].tobytes() == tracks[name].position.tobytes()
        assert simulated.yaw[:, robot].tobytes() == tracks[name].yaw.tobytes()


def test_readings_and_commands_are_those_of_the_commands_recording(
    simulated: cocorosim.SimulatedRun, commanded: Path
) -> None:
    """Compass, pressure, rates, ranges and commands by the names of their actuators."""
    recorded = cocorosim.read_recording(commanded).readings
    for robot, name in enumerate(simulated.robots):
        topics = recorded[name]
        assert simulated.readings["compass"][:, robot].tolist() == topics["compass"].column("heading").tolist()
        assert simulated.readings["pressure"][:, robot].tolist() == topics["pressure"].column("pressure").tolist()
        rate = topics["imu"].column("angular_rate_z")
        assert simulated.readings["angular_rate"][:, robot, 2].tolist() == rate.tolist()
        names = simulated.actuators[robot]
        assert names == topics["thruster_command"].columns
        np.testing.assert_array_equal(simulated.command[:, robot, : len(names)], topics["thruster_command"].values)
        assert np.isnan(simulated.command[:, robot, len(names) :]).all()
        sensors = topics["blss"].values[:, ::2]
        np.testing.assert_array_equal(simulated.readings["neighbour_range"][:, robot, : sensors.shape[1]], sensors)


def test_statistics_are_those_of_the_command(simulated: cocorosim.SimulatedRun, commanded: Path) -> None:
    """metrics.json, number by number."""
    written = json.loads((commanded / "metrics.json").read_text("utf-8"))
    assert simulated.measure().tree()["metrics"] == written["metrics"]


def test_a_recording_is_that_of_the_command(commanded: Path, tmp_path: Path) -> None:
    """`record` writes the same topics with the same bytes; a second time it has to be forced."""
    made = cocorosim.record(SCENARIO, tmp_path / "bag", seed=7, duration="20 s")
    assert made.digest == cocorosim.read_recording(commanded).digest
    assert (tmp_path / "bag" / "bag_0.mcap").read_bytes() == (commanded / "bag" / "bag_0.mcap").read_bytes()
    with pytest.raises(cocorosim.CocorosimError, match="exists already"):
        cocorosim.record(SCENARIO, tmp_path / "bag")
    again = cocorosim.record(SCENARIO, tmp_path / "bag", seed=7, duration="10 s", force=True)
    assert len(again.tracks["lily_01"].stamp_ns) == 20


def test_many_runs_are_each_of_them_alone() -> None:
    """Runs 3 and 4 at once give the bits of run 3 and of run 4, which differ."""
    several = cocorosim.simulate_runs("five_lilys", 2, first=3, duration="10 s")
    assert [each.run for each in several] == [3, 4]
    for each in several:
        alone = cocorosim.simulate("five_lilys", run=each.run, duration="10 s")
        for name in ("position", "yaw", "velocity", "yaw_rate", "command"):
            assert getattr(each, name).tobytes() == getattr(alone, name).tobytes()
    assert (several[0].position != several[1].position).any()


def test_a_scenario_is_a_name_a_file_or_a_record(tmp_path: Path) -> None:
    """All three give the same run; so does the text of a record in a new file; NumPy's integers are seeds."""
    loaded = cocorosim.load_scenario("five_lilys", seed=5, duration="5 s")
    file = tmp_path / "five.yaml"
    file.write_text(loaded.to_yaml(), "utf-8")
    by_name = cocorosim.simulate("five_lilys", seed=np.int64(5), duration=5)
    for source in (loaded, file, str(file)):
        assert cocorosim.simulate(source).position.tobytes() == by_name.position.tobytes()
    assert cocorosim.load_scenario(loaded) is loaded
    other = cocorosim.simulate(loaded, seed=6)
    assert (other.scenario.seed, other.scenario.duration) == (6, 5.0)
    assert (other.position != by_name.position).any()


def test_a_run_cannot_be_changed(simulated: cocorosim.SimulatedRun) -> None:
    """Neither its fields nor its arrays."""
    with pytest.raises(FrozenInstanceError):
        simulated.run = 1  # type: ignore[misc]
    with pytest.raises(ValueError, match="read-only"):
        simulated.position[0] = 0.0
    with pytest.raises(ValueError, match="read-only"):
        simulated.readings["compass"][0] = 0.0


def test_what_follows_from_the_arrays(simulated: cocorosim.SimulatedRun) -> None:
    """Time is ticks of half a second, depth is positive below the surface."""
    np.testing.assert_allclose(simulated.time, 0.5 * np.arange(40), rtol=0, atol=0)
    np.testing.assert_array_equal(simulated.depth, -simulated.position[..., 2])
    assert (simulated.depth > 0.0).all()


def test_the_frame_is_long(simulated: cocorosim.SimulatedRun) -> None:
    """One row a tick and robot; an actuator that a robot lacks is NaN there."""
    frame = simulated.to_frame()
    assert len(frame) == 40 * 9
    one = frame[frame["robot"] == "jeff_01"]
    place = simulated.robots.index("jeff_01")
    assert one["time"].tolist() == simulated.time.tolist()
    assert one["y"].tolist() == simulated.position[:, place, 1].tolist()
    assert one["yaw"].tolist() == simulated.yaw[:, place].tolist()
    assert one["r"].tolist() == simulated.yaw_rate[:, place].tolist()
    commands = {name for name in frame.columns if name.startswith("command_")}
    assert commands == {f"command_{name}" for names in simulated.actuators for name in names}
    strange = commands - {f"command_{name}" for name in simulated.actuators[place]}
    assert one[sorted(strange)].isna().all(axis=None)
    own = [f"command_{name}" for name in simulated.actuators[place]]
    np.testing.assert_array_equal(one[own].to_numpy(), simulated.command[:, place, : len(own)])


def test_it_shows_itself(simulated: cocorosim.SimulatedRun, parse: Callable[[str], Any]) -> None:
    """A line in a shell, a table of all robots in a notebook."""
    assert repr(simulated) == "<simulation of lilys_and_jeffs: robots 9, ticks 40 of 0.5 s, seed 7, run 0>"
    text = simulated._repr_html_()
    assert set(simulated.robots) <= set(parse(text).cells)
    assert text.count("<polyline") == len(simulated.robots), "and a drawing of their ways"


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: cocorosim.simulate("five_lilis"), "did you mean 'five_lilys'"),
        (lambda: cocorosim.simulate("five_lilys", seed=-1), "The argument 'seed' has -1"),
        (lambda: cocorosim.simulate("five_lilys", duration="60"), "which has no unit"),
        (lambda: cocorosim.simulate("five_lilys", duration=float("nan")), "not a finite number"),
        (lambda: cocorosim.simulate("five_lilys", duration=0.75), "not a whole number of ticks"),
        (lambda: cocorosim.simulate("five_lilys", run=-1), "'run' has -1; give a whole number from 0 on"),
        (lambda: cocorosim.simulate_runs("five_lilys", 0), "'runs' has 0"),
        (lambda: cocorosim.simulate("five_lilys", duration="5 s").measure("5"), "The argument 'interval' has '5'"),
    ],
)
def test_what_cannot_be_meant_is_a_sentence(call: Callable[[], Any], words: str) -> None:
    """One line that says what is wrong."""
    with pytest.raises(cocorosim.CocorosimError, match=words) as refused:
        call()
    assert "\n" not in str(refused.value)


def test_a_controller_that_is_left_to_others_is_refused(tmp_path: Path) -> None:
    """Nobody could answer for it; nothing is written."""
    scenario = cocorosim.load_scenario("five_lilys", external=["lily_02"])
    for call in (lambda: cocorosim.simulate(scenario), lambda: cocorosim.record(scenario, tmp_path / "bag")):
        with pytest.raises(cocorosim.CocorosimError, match="The controller of lily_02 is left to somebody else"):
            call()
    assert list(tmp_path.iterdir()) == []


def test_a_controller_that_cannot_be_made_is_refused(tmp_path: Path) -> None:
    """By a recording and by a design before their folders are made."""
    source = (
        "class Mine:\n    def __init__(self):\n        {}['gain']\n    def __call__(self, sensed):\n        return {}\n"
    )
    (tmp_path / "unmade.py").write_text(source, "utf-8")
    own = f"{tmp_path / 'unmade.py'}:Mine"
    scenario, design = (
        cocorosim.load_scenario("five_lilys", controller=own),
        cocorosim.load_design("smoke", controller=own),
    )
    for call in (cocorosim.record, cocorosim.run_design):
        with pytest.raises(cocorosim.CocorosimError, match=r"unmade\.py:3: KeyError: 'gain'; 'Mine' of lily_01"):
            call(scenario if call is cocorosim.record else design, tmp_path / "out")  # type: ignore[operator]
    assert [path.name for path in tmp_path.iterdir()] == ["unmade.py"]
