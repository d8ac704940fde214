"""Whether a platform's mass, volume and inertia can belong to one body: a slipped power of ten is said, not simulated.

The limits are those of nature, not of taste: hydrogen is the lightest and osmium the heaviest that a hull can be filled
with (CRC Handbook of Chemistry and Physics: 0.0899 and 22 590 kg/m^3), no mass within a hull is farther from its
centre than a corner, and no two points of a hull are farther apart than it is long or wide. What displaces less than
half or more than twice its mass does not swim, whatever its pump does.
"""

from __future__ import annotations

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.parts.platform import Platform
from cocorosim_ros.scenario.parts.sliding_mass import SlidingMass
from cocorosim_ros.scenario.parts.vehicle_parts import BuoyancyPump

LIGHTEST, HEAVIEST = 0.0899, 22590.0  # kg/m^3
LEAST_DISPLACED, MOST_DISPLACED = 0.5, 2.0  # of the mass
WATER_THAT_TURNS_ALONG = 10.0  # times what the hull could hold: added inertia of a slender hull


def check_body(platform: Platform) -> None:
    """Nothing, if the numbers can belong to one body. Raises CocorosimError with the first that cannot."""
    _check_density(platform)
    _check_displacement(platform)
    _check_inertia(platform)
    _check_sliding(platform)
    _check_centre(platform)


def displaced_mass(platform: Platform) -> float:
    """Mass [kg] of the water that a platform displaces with its pumps neutral; 0 without a pump."""
    volume = sum(part.neutral_volume for part in platform.actuators if isinstance(part, BuoyancyPump))
    return platform.water_density * volume


def _check_density(platform: Platform) -> None:
    hull, mass = platform.hull, platform.mass
    volume = hull.length * hull.width * hull.height
    if not LIGHTEST * volume <= mass <= HEAVIEST * volume:
        wrong = "lighter than hydrogen" if mass < LIGHTEST * volume else "heavier than any metal"
        raise CocorosimError(
            f"{platform.origin}: 'mass' has '{mass:g} kg' in a 'hull' of {hull.length:g} m x {hull.width:g} m x "
            f"{hull.height:g} m, {wrong}; correct the one or the other."
        )


def _check_displacement(platform: Platform) -> None:
    displaced, mass = displaced_mass(platform), platform.mass
    if displaced > 0.0 and not LEAST_DISPLACED * mass <= displaced <= MOST_DISPLACED * mass:
        raise CocorosimError(
            f"{platform.origin}: 'neutral_volume' displaces {displaced:.4g} kg of water, and 'mass' has '{mass:g} kg'; "
            f"a vehicle that is to swim displaces {LEAST_DISPLACED:g} to {MOST_DISPLACED:g} times its mass, and one "
            f"that is neutral {mass / platform.water_density * 1e6:.4g} cm^3."
        )


def _check_inertia(platform: Platform) -> None:
    hull = platform.hull
    at_corners = platform.mass * (hull.length**2 + hull.width**2) / 4.0
    if platform.yaw_inertia > WATER_THAT_TURNS_ALONG * at_corners:
        raise CocorosimError(
            f"{platform.origin}: 'yaw_inertia' has '{platform.yaw_inertia:g} kg m^2'; all of its mass at the corners "
            f"of its hull would have {at_corners:.3g} kg m^2, of which {WATER_THAT_TURNS_ALONG:g} times are allowed "
            "for the water that turns along."
        )


def _check_sliding(platform: Platform) -> None:
    parts = [part for part in platform.actuators if isinstance(part, SlidingMass)]
    moving, size = sum(part.mass for part in parts), (platform.hull.length, platform.hull.width, platform.hull.height)
    if moving >= platform.mass:
        raise CocorosimError(
            f"{platform.origin}: 'mass' has '{platform.mass:g} kg', and its sliding masses have {moving:g} kg; these "
            "are a part of it."
        )
    for part in parts:
        if any(abs(way) * part.travel > 0.5 * side for way, side in zip(part.direction, size, strict=True)):
            raise CocorosimError(
                f"{platform.origin}: '{part.name}' has the 'travel' {part.travel:g} m to each side, which is beyond "
                f"the 'hull' of {size[0]:g} m x {size[1]:g} m x {size[2]:g} m; correct the one or the other."
            )


def _check_centre(platform: Platform) -> None:
    place, hull = platform.effects.get("offset_centre", {}), platform.hull
    # One limit for both: a diagnosis looks for both up to half the length, and what it finds has to be read back.
    most = max(hull.length, hull.width)
    for name in ("ahead", "left"):
        offset = place.get(name, 0.0)
        if abs(offset) > most:
            raise CocorosimError(
                f"{platform.origin}: '{name}' of 'offset_centre' has '{offset:g} m' in a 'hull' of {hull.length:g} m x "
                f"{hull.width:g} m, which has no centre of mass there; at most {most:g} m to either side are allowed."
            )
    _check_resistance(platform, place.get("ahead", 0.0))


def _check_resistance(platform: Platform, ahead: float) -> None:
    """Refuse a centre of mass `ahead` [m] of the origin beside added mass, if forces would accelerate backwards.

    By Sylvester's criterion of the mass matrix of surge, sway and yaw (effects.offset_centre): with A_v sideways and
    A_r in yaw, m + A_v and I + A_r + m x^2 A_v / (m + A_v) are greater than zero, wherever the centre is to the side.
    """
    added = platform.effects.get("added_mass", {})
    aside, turning = added.get("sway_minus_surge", 0.0), added.get("yaw", 0.0)
    if not ahead or not (aside or turning):
        return
    across = platform.mass + aside
    around = platform.yaw_inertia + turning + platform.mass * ahead**2 * aside / across if across > 0.0 else 0.0
    if across <= 0.0 or around <= 0.0:
        left_over = f"{across:.3g} kg against a push to the side" if across <= 0.0 else f"{around:.3g} kg m^2 in a turn"
        raise CocorosimError(
            f"{platform.origin}: 'ahead' of 'offset_centre' has '{ahead:g} m' beside 'added_mass' with {aside:g} kg as "
            f"'sway_minus_surge' and {turning:g} kg m^2 as 'yaw', which leaves an inertia of {left_over}, and a body "
            "has more than 0; correct the one or the other."
        )
