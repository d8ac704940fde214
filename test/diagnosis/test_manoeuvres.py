"""Which manoeuvre is advised."""

from __future__ import annotations

from dataclasses import replace
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


UP_AND_DOWN = {"depth_staircase", "surface_touch"}
AHEAD = {"coast_down", "along_wall", "reverse_steps", "crash_stops"}
AHEAD_AND_TURNING = {"zig_zag", "four_headings", "follow_neighbour", "slow_turns"}
WITH_THRUSTERS = {"steps", "ramps_through_zero", "thrust_staircase", "ruler"}


@pytest.mark.parametrize(
    ("platform", "cannot"),
    [
        ("lily", set()),  # a pump, and thrusters that turn both ways
        ("hovercraft_epfl", {"pump_triangle", "reverse_steps", "crash_stops"} | UP_AND_DOWN),
        ("haizhe_auv", {"pump_triangle"} | AHEAD | AHEAD_AND_TURNING),  # thrusters that push down, one way
        ("slocum_glider", AHEAD | AHEAD_AND_TURNING | WITH_THRUSTERS),  # a pump alone
        ("kvlcc2_hsva", {"pump_triangle"} | UP_AND_DOWN),  # a propeller that reverses, and a rudder
        ("milliampere_ferry", {"pump_triangle"} | UP_AND_DOWN),  # four azimuths
        ("tauv_pool", {"pump_triangle"}),  # thrusters along all axes
        ("floater", set(MANOEUVRES) - {"rest"}),
    ],
)
def test_no_advice_for_organs_that_the_vehicle_lacks(platform: str, cannot: set[str]) -> None:
    """A hovercraft is not told to hold five depths, nor a glider to drive ahead, whatever effect is out of sight."""
    vehicle = load_platform(platform)
    assert set(NEEDS) == set(MANOEUVRES)
    assert {name for name in MANOEUVRES if not can_drive(vehicle, name)} == cannot
    told = {name for each in IDS for name in advised((), [each], vehicle)}
    assert told == {manoeuvre_of(each) for each in IDS} - cannot - {None}


def test_a_propeller_without_a_rudder_drives_straight_on() -> None:
    """One thruster along the hull pushes ahead and turns nothing; a tenth of the hull aside, it turns one way."""
    ship = load_platform("kvlcc2_hsva")
    (propeller,) = (each for each in ship.actuators if each.kind == "thruster")
    alone = replace(ship, actuators=(propeller,))
    aside = replace(propeller, position=(0.0, 0.1 * ship.hull.length, 0.0), maximum_reverse=0.0)
    for vehicle in (alone, replace(ship, actuators=(aside,))):
        assert can_drive(vehicle, "coast_down")
        assert not can_drive(vehicle, "zig_zag") and not can_drive(vehicle, "slow_turns")
    both_ways = replace(ship, actuators=(replace(aside, maximum_reverse=propeller.maximum),))
    assert can_drive(both_ways, "slow_turns")


def test_words_of_manoeuvres_name_no_organs_of_single_vehicles() -> None:
    """Neither "the other" thruster nor left and right ones, a tank, or a gyroscope that may not be there."""
    for words in MANOEUVRES.values():
        assert not any(organ in words for organ in ("the other is off", "left and right", "tank", "gyro")), words


def test_what_was_not_recorded_is_not_for_driving(swim: Any) -> None:
    """Without pressure and with one robot, neither touching the surface nor following a neighbour is advised."""
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
