"""Which manoeuvre is advised."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from cocorosim_ros.diagnosis.catalogue.catalogue import IDS
from cocorosim_ros.diagnosis.catalogue.manoeuvres import NEEDS, advised, can_drive, manoeuvre_of
from cocorosim_ros.diagnosis.report.advice import MANOEUVRES
from cocorosim_ros.scenario.parts.platform import load_platform

LILY = load_platform("lily")


def effect(name: str, *rivals: str) -> Any:
    """One that was found, with what is nearly as good."""
    return SimpleNamespace(id=name, ambiguous_with=tuple(SimpleNamespace(id=rival) for rival in rivals))


def test_rivals_come_before_what_was_not_seen() -> None:
    """What separates the found effect from its rival."""
    found = [effect("thruster_lag", "pump_lag")]
    assert set(advised(found, ["wall_effect"], LILY)) == {manoeuvre_of("thruster_lag"), manoeuvre_of("pump_lag")}


def test_what_was_not_seen_is_shown_whatever_was_found() -> None:
    """A mismatch without rivals leaves as much out of sight as no mismatch does."""
    for found in ([], [effect("thruster_lag")]):
        assert advised(found, ["wall_effect"], LILY) == ("along_wall",)
    assert advised([effect("thruster_lag")], [], LILY) == ()


@pytest.mark.parametrize(
    ("platform", "cannot"),
    [
        ("lily", set()),  # a pump, and thrusters that turn both ways
        ("hovercraft_epfl", {"depth_staircase", "surface_touch", "pump_triangle", "reverse_steps"}),
        ("haizhe_auv", {"pump_triangle", "reverse_steps"}),  # thrusters that push down, one way
    ],
)
def test_no_advice_for_organs_that_the_vehicle_lacks(platform: str, cannot: set[str]) -> None:
    """A hovercraft is not told to hold five depths, whatever single effect is out of sight."""
    vehicle = load_platform(platform)
    assert set(NEEDS) <= set(MANOEUVRES)
    assert {name for name in MANOEUVRES if not can_drive(vehicle, name)} == cannot
    told = {name for each in IDS for name in advised((), [each], vehicle)}
    assert told == {manoeuvre_of(each) for each in IDS} - cannot - {None}


def test_what_was_not_recorded_is_not_for_driving(swim: Any) -> None:
    """Without pressure and with one robot, neither touching the surface nor following a neighbour is advised."""
    from dataclasses import replace

    from cocorosim_ros.diagnosis.diagnose import diagnose
    from cocorosim_ros.scenario.parts.platform import load_platform

    evidence = swim(load_platform("lily"), 60.0)
    (recording,) = evidence.recordings
    (log,) = recording.robots
    only_pose = replace(log, streams={"pose": log.streams["pose"]})
    found = diagnose(
        replace(evidence, recordings=(replace(recording, robots=(only_pose,)),)), lambda words, share: None
    )
    assert {"pressure_offset", "neighbour_wake"} <= set(found.not_shown)
    assert found.manoeuvres and not {"surface_touch", "follow_neighbour"} & set(found.manoeuvres)
