"""Denser water, a hull out of the water, thrust lost at the surface and to the side, a towed cable: all with numbers.

The swims are the simulator's; what an effect does is compared with closed forms in test/world/motion.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest
from hidden_effects import hiding

from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES
from cocorosim_ros.diagnosis.diagnose import diagnose
from cocorosim_ros.diagnosis.fitting.candidate import expand
from cocorosim_ros.diagnosis.fitting.vehicle_needs import HAS
from cocorosim_ros.diagnosis.tracks.make_tracks import make_tracks
from cocorosim_ros.diagnosis.tracks.vehicle_model import vehicle_model
from cocorosim_ros.scenario.parts.platform import load_platform
from cocorosim_ros.scenario.parts.vehicle_parts import Thruster

SECONDS = 150.0


def lily() -> Any:
    """A Lily as she is."""
    return load_platform("lily")


def tall() -> Any:
    """A Lily with a mast: 0.3 m from keel to top."""
    plain = load_platform("lily")
    return replace(plain, hull=replace(plain.hull, height=0.3))


def sideways() -> Any:
    """A Lily with a thruster to the side, 30 mm before the middle, in place of the pump."""
    plain = load_platform("lily")
    bow = Thruster("bow", (0.03, 0.0, 0.0), (0.0, 1.0, 0.0), 0.05)
    return replace(plain, actuators=(*plain.actuators[:2], bow))


def towing() -> Any:
    """A Lily with a cable of 4 mm to the surface."""
    plain = load_platform("lily")
    return replace(plain, hull=replace(plain.hull, cable_diameter=0.004))


CABLE = {"coefficient": 1.2, "diameter": 0.004, "x": 1.0, "y": 0.5}
CASES = [
    pytest.param(lily, "density_gradient", {"gradient": 2e-3}, {"gradient": 2e-3}, 31, id="density_gradient"),
    pytest.param(
        tall, "hull_emergence", {"share": 0.06, "height": 0.3, "weight": 0.44 * 9.81}, {"share": 0.06}, 46, id="hull"
    ),
    pytest.param(sideways, "side_thrust_lever", {"lever": 0.006}, {"lever": 0.006}, 31, id="side_thrust_lever"),
    pytest.param(lily, "surface_loss", {"loss": 0.5, "reach": 0.26}, {"loss": 0.5}, 46, id="surface_loss"),
    pytest.param(towing, "tether_drag", CABLE, {"coefficient": 1.2}, 31, id="tether_drag"),
]

WIDER = {"surface_loss": 2.0}
"""Widths that an interval may have, as shares of the number, where that is not below 1."""


@pytest.mark.parametrize(("make", "effect", "hidden", "numbers", "seed"), CASES)
def test_it_is_named_with_its_number(
    swim: Any, make: Any, effect: str, hidden: dict[str, float], numbers: dict[str, float], seed: int
) -> None:
    """It alone; the truth lies in the 95 % interval, which is narrower than the number itself.

    A loss at the surface is reckoned up to there from depths that are visited, by a form that may be another.
    """
    platform = make()
    found = diagnose(
        swim(hiding(platform, {effect: hidden}), SECONDS, seed=seed, base=platform), lambda words, share: None
    )
    assert [each.id for each in found.effects] == [effect]
    for name, true in numbers.items():
        estimate = found.effects[0].parameters[name]
        widest = WIDER.get(effect, 1.0) * true
        assert estimate.holds(true) and 0.0 < estimate.low and estimate.high - estimate.low < widest, estimate


@pytest.mark.parametrize(("make", "seed"), [(tall, 46), (sideways, 31), (towing, 31)])
def test_nothing_is_named_where_nothing_is_wrong(swim: Any, make: Any, seed: int) -> None:
    """The same swims without the effects."""
    found = diagnose(swim(make(), SECONDS, seed=seed), lambda words, share: None)
    assert [each.id for each in found.effects] == []


def test_denser_water_and_a_hull_that_swells_are_named_together(swim: Any) -> None:
    """One robot's recording cannot tell them: the other one is among what it is confused with."""
    hidden = hiding(lily(), {"density_gradient": {"gradient": 2e-3}})
    found = diagnose(swim(hidden, SECONDS, seed=31, base=lily()), lambda words, share: None)
    assert "hull_compressibility" in [rival.id for rival in found.effects[0].ambiguous_with]


def test_a_cable_in_long_bends_is_told_as_more_drag(swim: Any) -> None:
    """Of 20 m about 1.5 m from the anchor, it has the hull's law: 1/8 rho C_d d l = 0.5 kg/m more, without a name."""
    platform = replace(towing(), hull=replace(towing().hull, cable_length=20.0))
    slack = hiding(platform, {"tether_drag": {**CABLE, "coefficient": 0.05, "length": 20.0}})
    found = diagnose(swim(slack, SECONDS, seed=31, base=platform), lambda words, share: None)
    (moved,) = found.recalibrated
    assert (found.verdict, found.effects, moved.parameter) == ("recalibrate", (), "drag")
    assert moved.estimate.holds(platform.drag + 1000.0 * 0.05 * 0.004 * 20.0 / 8.0)


def test_what_a_vehicle_cannot_show_is_not_looked_for(swim: Any) -> None:
    """A Lily has no thruster to the side, a hull of 70 mm and no cable; what drifts has no motor."""
    tracks = make_tracks(swim(lily(), 30.0))
    asked = {candidate.entry.id for candidate in expand(ENTRIES, tracks, tracks[0].vehicle.row[None])}
    unseen = {"side_thrust_lever", "hull_emergence", "speed_log_scale", "speed_log_misalignment", "tether_drag"}
    assert not unseen & asked
    assert {"density_gradient", "surface_loss", "motor_field", "pose_heading", "pose_lever"} <= asked
    drifting = replace(lily(), actuators=lily().actuators[2:])
    for make, having in (
        (lily, {"thrusters"}), (tall, {"thrusters", "tall_hull"}), (sideways, {"thrusters", "side_thrusters"}),
        (towing, {"thrusters", "cable"}), (lambda: drifting, set()),
    ):  # fmt: skip
        assert {name for name, has in HAS.items() if has(vehicle_model(make()))} == having
