"""What is not looked for because a platform's file lacks a number is told with the key; what cannot be is not."""

from __future__ import annotations

from dataclasses import replace

import pytest

from cocorosim_ros.diagnosis.fitting.undeclared import KEYS_OF_NEED, not_looked_for
from cocorosim_ros.diagnosis.fitting.vehicle_needs import HAS
from cocorosim_ros.scenario.parts.platform import Platform, load_platform
from cocorosim_ros.scenario.parts.vehicle_parts import Thruster
from cocorosim_ros.scenario.reading.quantity import Quantity

CABLE = {"tether_drag": ("hull.cable_diameter",)}
AREAS = {"wind": ("hull.front_above_water", "hull.side_above_water")}


def lacking(platform: Platform) -> dict[str, tuple[str, ...]]:
    """Keys that a platform lacks, by effect."""
    return {each.id: each.numbers for each in not_looked_for(platform)}


def test_every_need_of_the_table_is_one_of_effects() -> None:
    """A need that no effect has would never be asked."""
    assert set(KEYS_OF_NEED) <= set(HAS)


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("lily", CABLE),  # it dives: no wind; and both jets blow beside each other
        ("kvlcc2_hsva", CABLE | AREAS),
        ("remus100", {}),  # it dives by its fins, and swims free
        ("bluerov2_heavy", {}),  # all is given
        ("hovercraft_epfl", {}),  # in the air wind is a current
        ("rgblimp", {}),
        ("floater", {}),  # nothing drives it
        ("slocum_glider", {}),
    ],
)
def test_platforms_that_ship(name: str, expected: dict[str, tuple[str, ...]]) -> None:
    """What each may have, and its file does not tell."""
    assert lacking(load_platform(name)) == expected


def test_a_number_that_is_given_is_not_lacking() -> None:
    """Zeros are numbers: nothing stands in the wind. One area is enough, and an effect of the file is known anyway."""
    ship = load_platform("kvlcc2_hsva")
    for areas in ({"front_above_water": 0.0, "side_above_water": 0.0}, {"side_above_water": 0.3}):
        assert lacking(replace(ship, hull=replace(ship.hull, **areas))) == CABLE
    tied = replace(ship, hull=replace(ship.hull, cable_diameter=0.004))
    assert lacking(tied) == AREAS
    towing = {"tether_drag": {"coefficient": Quantity(1.2, "1", "coefficient")}}
    assert lacking(replace(ship, effect_quantities=towing)) == AREAS


@pytest.mark.parametrize(
    ("place", "given", "told"),
    [
        ((-0.3, 0.0, 0.0), (None, None), ("actuators.left.diameter", "actuators.right.diameter")),
        ((-0.3, 0.0, 0.0), (0.05, None), ()),  # the front one's jet is known to meet the other
        ((-0.3, 0.0, 0.0), (0.05, 0.05), ()),
        ((0.0, 0.3, 0.0), (None, None), ()),  # side by side: no jet of whatever width meets the other
        ((0.0, 0.0, 0.0), (None, None), ()),  # forces of a wrench at one place
    ],
)
def test_jets_that_could_meet_a_thruster(
    place: tuple[float, float, float], given: tuple[float | None, float | None], told: tuple[str, ...]
) -> None:
    """Two thrusters that push ahead, the second at `place` from the first, with these diameters."""
    lily = load_platform("lily")
    first, second = (each for each in lily.actuators if isinstance(each, Thruster))
    ahead = (1.0, 0.0, 0.0)
    pair = (
        replace(first, name="left", position=(0.0, 0.0, 0.0), direction=ahead, diameter=given[0]),
        replace(second, name="right", position=place, direction=ahead, diameter=given[1]),
    )
    others = tuple(each for each in lily.actuators if not isinstance(each, Thruster))
    assert lacking(replace(lily, actuators=(*pair, *others))).get("wash_loss", ()) == told
