"""Lift of a slender hull that drifts: named with its numbers where it is, and looked for only where a hull is slender.

The swims are the simulator's; the law is compared with closed forms in test/world/motion.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest
from hidden_effects import hiding

from cocorosim_ros.diagnosis.criteria.fitting import VEHICLE_NEEDS
from cocorosim_ros.diagnosis.diagnose import diagnose
from cocorosim_ros.diagnosis.fitting.vehicle_needs import HAS
from cocorosim_ros.diagnosis.tracks.vehicle_model import vehicle_model
from cocorosim_ros.scenario.parts.platform import Platform, load_platform

SECONDS, SEED = 200.0, 31
LIFT = {"sway_by_drift": 8.0, "yaw_by_drift": 0.03}  # kg/m, kg


def slender() -> Platform:
    """A Lily whose hull is said to be five times as long as wide."""
    lily = load_platform("lily")
    return replace(lily, hull=replace(lily.hull, width=lily.hull.length / 5.0))


def effects_of(swim: Any, truth: Platform, base: Platform) -> dict[str, Any]:
    """Numbers of what is named of one swim, by effect."""
    found = diagnose(swim(truth, SECONDS, seed=SEED, base=base), lambda words, share: None)
    return {effect.id: effect.parameters for effect in found.effects}


def test_lift_is_named_with_its_numbers(swim: Any) -> None:
    """It alone; both numbers lie in their intervals, which are narrower than they are."""
    found = effects_of(swim, hiding(slender(), {"hull_lift": LIFT}), slender())
    assert set(found) == {"hull_lift"}
    for name, true in LIFT.items():
        estimate = found["hull_lift"][name]
        assert estimate.holds(true) and estimate.high - estimate.low < true, (name, estimate)


def test_a_hull_without_lift_has_no_name(swim: Any) -> None:
    """The same swim of the same hull."""
    assert effects_of(swim, slender(), slender()) == {}


@pytest.mark.parametrize(("share", "is_slender"), [(1.01, True), (0.99, False)])
def test_a_hull_is_slender_from_a_quotient_on(share: float, is_slender: bool) -> None:
    """Length over width, of the criterion a little more and a little less."""
    lily = load_platform("lily")
    hull = replace(lily.hull, width=lily.hull.length / (share * VEHICLE_NEEDS.slender))
    assert HAS["slender_hull"](vehicle_model(replace(lily, hull=hull))) is is_slender
