"""Numbers of a platform that no body can have are refused before anything moves."""

from __future__ import annotations

from dataclasses import replace

import pytest

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.parts.platform import Platform, load_platform
from cocorosim_ros.scenario.parts.vehicle_parts import BuoyancyPump
from cocorosim_ros.scenario.reading.config_files import config_names
from cocorosim_ros.scenario.reading.quantity import Quantity
from cocorosim_ros.world.vehicle_model.platform_effects import check_platform

LILY = load_platform("lily")


def with_volume(factor: float) -> Platform:
    """Lily with another volume of her pump."""
    parts = (
        replace(part, neutral_volume=factor * part.neutral_volume) if isinstance(part, BuoyancyPump) else part
        for part in LILY.actuators
    )
    return replace(LILY, actuators=tuple(parts))


def with_centre(ahead: float) -> Platform:
    """A Lily whose centre of mass is so far ahead of the origin [m]."""
    return replace(LILY, effect_quantities={"offset_centre": {"ahead": Quantity(ahead, "m", "length")}})


@pytest.mark.parametrize("name", config_names("platforms"))
def test_shipped_platforms_can_exist(name: str) -> None:
    """Swimmers, a boat, a passive body and a hovercraft in air."""
    check_platform(load_platform(name))


@pytest.mark.parametrize(
    ("platform", "sentence"),
    [
        (with_volume(10.0), r"'neutral_volume' displaces 4\.4 kg .* 'mass' has '0\.44 kg'.* neutral 440 cm\^3"),
        (with_volume(0.1), r"'neutral_volume' displaces 0\.044 kg"),
        (replace(LILY, mass=4.4), r"'mass' has '4\.4 kg'.* neutral 4400 cm\^3"),
        (replace(LILY, mass=1e300), r"'mass' has '1e\+300 kg' in a 'hull' .* heavier than any metal"),
        (replace(LILY, hull=replace(LILY.hull, length=1e300)), r"lighter than hydrogen"),
        (replace(LILY, yaw_inertia=1e300), r"'yaw_inertia' has '1e\+300 kg m\^2'"),
        (with_centre(-0.2), r"'ahead' of 'offset_centre' has '-0\.2 m' .* at most 0\.13 m to either side"),
    ],
)
def test_a_slipped_power_of_ten_is_a_sentence(platform: Platform, sentence: str) -> None:
    """Which file, which key, what was found, what would fit."""
    with pytest.raises(CocorosimError, match=rf"lily\.yaml: .*{sentence}"):
        check_platform(platform)


@pytest.mark.parametrize("factor", [0.6, 1.0, 1.9])
def test_weight_that_a_vehicle_may_have(factor: float) -> None:
    """A vehicle that is badly trimmed is not refused: this is what a diagnosis is for."""
    check_platform(with_volume(factor))


def test_one_robot_that_differs_is_checked_too() -> None:
    """The numbers below 'robots' count as well."""
    with pytest.raises(CocorosimError, match="heavier than any metal"):
        check_platform(replace(LILY, robots={"lily_02": replace(LILY, mass=1e300)}))
