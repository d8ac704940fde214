"""What another platform's file knows is taken over robot by robot."""

from __future__ import annotations

from dataclasses import replace

from cocorosim_ros.scenario.parts.known_effects import knowing
from cocorosim_ros.scenario.parts.platform import Platform, load_platform
from cocorosim_ros.scenario.reading.quantity import Quantity


def lily(torque: float = 0.0, trim: float = 0.0, pose: str = "", **robots: Platform) -> Platform:
    """A Lily with a torque bias and a trim, where they are given, and axes of the pose."""
    effects = {}
    if torque:
        effects["torque_bias"] = {"torque": Quantity(torque, "N m", "torque")}
    if trim:
        effects["buoyancy_trim"] = {"force": Quantity(trim, "N", "force")}
    corrections = {"pose": pose} if pose else {}
    return replace(load_platform("lily"), effect_quantities=effects, frame_corrections=corrections, robots=robots)


def test_effects_of_single_robots_are_taken_over() -> None:
    """Also where all have none; each robot keeps what the platform says of it, and its numbers."""
    heavy = replace(lily(), mass=0.5)
    found = knowing(lily(a=heavy), lily(b=lily(trim=2e-3)))
    assert (found.effects, found.of_robot("a").effects) == ({}, {})
    assert found.of_robot("b").effects == {"buoyancy_trim": {"force": 2e-3}}
    assert found.of_robot("a").mass == 0.5 and found.of_robot("b").mass == lily().mass


def test_a_robot_s_own_counts_for_more_than_everybody_s() -> None:
    """And of two that say the same, what is known counts for more than what the platform says."""
    platform = lily(torque=1e-6, a=lily(torque=5e-6), b=lily(torque=6e-6))
    found = knowing(platform, lily(torque=2e-6, trim=1e-3, b=lily(torque=7e-6)))
    both = {"buoyancy_trim": {"force": 1e-3}}
    assert found.effects == {"torque_bias": {"torque": 2e-6}} | both
    assert found.of_robot("a").effects == {"torque_bias": {"torque": 5e-6}} | both
    assert found.of_robot("b").effects == {"torque_bias": {"torque": 7e-6}, "buoyancy_trim": {"force": 1e-3}}


def test_axes_and_units_are_taken_over() -> None:
    """They are knowledge of the same kind."""
    found = knowing(lily(a=lily()), lily(pose="y mirrored", b=lily(pose="degrees")))
    assert (found.frame_corrections, found.of_robot("a").frame_corrections) == ({"pose": "y mirrored"},) * 2
    assert found.of_robot("b").frame_corrections == {"pose": "degrees"}
