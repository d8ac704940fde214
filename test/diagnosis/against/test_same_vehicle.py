"""Recordings that say themselves that they are of another vehicle are refused; those of one vehicle never are."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.against.comparable import comparable
from cocorosim_ros.diagnosis.evidence.streams.log import Evidence, RecordingLog, RobotLog, Stream
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.parts.platform import load_platform
from cocorosim_ros.world.checks.loading import load_scenario


def scenario(prefix: str = "lily", **changes: Any) -> str:
    """Text of the scenario of one Lily with a weak thruster, PREFIX_01, fields of its platform replaced."""
    made = load_scenario("weak_thruster")
    (group,) = made.swarm
    return replace(made, swarm=(replace(group, prefix=prefix, platform=replace(group.platform, **changes)),)).to_yaml()


def longer(factor: float) -> dict[str, Any]:
    """A Lily's hull so many times as long, as a field of a platform."""
    hull = load_platform("lily").hull
    return {"hull": replace(hull, length=factor * hull.length)}


def recording(origin: str, made_from: str, robot: str = "lily_01", commanded: tuple[str, ...] = ()) -> Evidence:
    """A short recording of one robot that says what it was made from, and whose commands name actuators."""
    pose = Stream(np.arange(3.0), np.zeros((3, 4)), np.full(4, 0.01))
    log = RobotLog(robot, np.zeros(1), np.full((1, 3), 0.5), {"pose": pose}, commanded=commanded)
    return Evidence(load_platform("lily"), (RecordingLog(origin, 2.0, (log,), (), made_from),))


def compare(bad: str, good: str, before: str = "lily_01") -> None:
    """Compare two recordings, by their scenarios, with the robot by another name before."""
    comparable(recording("tank/21", bad), recording("tank/22", good, before))


def test_another_hull_is_refused() -> None:
    """Half as long again: the sentence names both recordings, and what each was made with."""
    with pytest.raises(CocorosimError) as refused:
        compare(scenario(), scenario(name="long_lily", **longer(1.5)))
    said = str(refused.value)
    assert said.startswith("--against has tank/22, made with 'long_lily' (0.195 x 0.1 x 0.07 m, 0.44 kg, actuators ")
    assert "left, right, buoyancy) as lily_01, and tank/21 was made with 'lily_weak_thruster' (0.13 x 0.1 x" in said


def test_another_mass_is_refused() -> None:
    """A third more, in the same hull."""
    with pytest.raises(CocorosimError, match="give recordings of the same vehicle"):
        compare(scenario(mass=0.44 * 4 / 3), scenario())


def test_a_fault_is_no_other_vehicle() -> None:
    """A weak thruster has a platform of its own by another name; a little more mass is a load."""
    plain = scenario(name="lily", effect_quantities={})
    compare(scenario(), plain)
    compare(scenario(mass=0.44 * 1.1), plain)


def test_recordings_that_say_nothing_are_compared() -> None:
    """Those of real vehicles have no scenario; one of another version cannot be read."""
    for text in ("", "name: of a version to come"):
        compare(scenario(), text)


def test_the_robots_of_a_scenario_are_told_apart() -> None:
    """A recording's only robot has its own name in its scenario; another robot there says nothing of it."""
    with pytest.raises(CocorosimError, match=r"buoyancy\) as before_01"):
        compare(scenario(), scenario("before", **longer(1.5)), "before_01")
    compare(scenario(), scenario(**longer(1.5)), "before_01")


def test_other_actuators_are_refused() -> None:
    """Commands of each side name an actuator that the other lacks: the sentence has both sets."""
    mine, theirs = recording("sea/1", "", commanded=("left", "right", "bow")), ("left", "right", "stern")
    with pytest.raises(CocorosimError, match="actuators left, right, stern, and the recordings to be judged of left"):
        comparable(mine, recording("sea/2", "", "another_name", theirs))


@pytest.mark.parametrize("theirs", [(), ("left",), ("left", "right"), ("right", "left", "bow", "stern")])
def test_actuators_that_one_side_alone_names_say_nothing(theirs: tuple[str, ...]) -> None:
    """One that is lost, or was not used, may be missing in a log."""
    comparable(recording("sea/1", "", commanded=("left", "right", "bow")), recording("sea/2", "", commanded=theirs))


def test_other_actuators_of_a_scenario_are_refused() -> None:
    """Hull and mass are the same; the pump of one is called so, and that of the other otherwise."""
    actuators = load_platform("lily").actuators
    other = tuple(replace(each, name="ballast") if each.name == "buoyancy" else each for each in actuators)
    with pytest.raises(CocorosimError, match="actuators left, right, ballast"):
        compare(scenario(), scenario(name="other", actuators=other))
