"""Numbers of a platform that no body can have are refused before anything moves."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
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


def with_centre(ahead: float, left: float = 0.0, aside: float = 0.0) -> Platform:
    """A Lily whose centre of mass is so far ahead and left of the origin [m], with this added mass sideways [kg]."""
    effects = {"offset_centre": {"ahead": Quantity(ahead, "m", "length"), "left": Quantity(left, "m", "length")}}
    return replace(
        LILY, effect_quantities=effects | {"added_mass": {"sway_minus_surge": Quantity(aside, "kg", "mass")}}
    )


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
        (
            with_centre(0.065, aside=-0.1),
            r"'0\.065 m' beside .* with -0\.1 kg .* of -0\.000142 kg m\^2 in a turn",
        ),
        (with_centre(0.01, aside=-0.5), r"an inertia of -0\.06 kg against a push to the side"),
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


@pytest.mark.parametrize("aside", [-0.44, -0.3, -0.1, 0.0, 0.5])
@pytest.mark.parametrize("ahead", [-0.065, -0.04, 0.02, 0.065])
@pytest.mark.parametrize("left", [0.0, 0.05])
def test_what_is_refused_is_no_mass_matrix(aside: float, ahead: float, left: float) -> None:
    """Fossen's (2021, eq. 3.49) with added mass on its diagonal: an eigenvalue that is not above zero."""
    m, about_origin = LILY.mass, LILY.yaw_inertia + LILY.mass * (ahead**2 + left**2)
    matrix = np.array([[m, 0.0, -m * left], [0.0, m + aside, m * ahead], [-m * left, m * ahead, about_origin]])
    if np.linalg.eigvalsh(matrix).min() > 0.0:
        check_platform(with_centre(ahead, left, aside))
    else:
        with pytest.raises(CocorosimError, match="and a body has more than 0"):
            check_platform(with_centre(ahead, left, aside))
