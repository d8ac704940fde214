"""Choice of manoeuvres that would show what a recording leaves open, among those that the vehicle can drive."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES
from cocorosim_ros.diagnosis.criteria.report import MANOEUVRE, REPORT
from cocorosim_ros.diagnosis.findings import FoundEffect
from cocorosim_ros.scenario.parts.fin import Fin
from cocorosim_ros.scenario.parts.platform import Platform
from cocorosim_ros.scenario.parts.steering import Rudder
from cocorosim_ros.scenario.parts.vehicle_parts import BuoyancyPump, Thruster
from cocorosim_ros.world.state.state import YAW, X, Y


def has_pump(platform: Platform) -> bool:
    """Tell whether a vehicle has a pump that changes its buoyancy."""
    return any(isinstance(each, BuoyancyPump) for each in platform.actuators)


def dives(platform: Platform) -> bool:
    """Tell whether a vehicle can change its depth by a pump, or by a thruster that pushes upwards or downwards."""
    return has_pump(platform) or any(
        isinstance(each, Thruster) and abs(each.direction[2]) > MANOEUVRE.least_rise for each in platform.actuators
    )


def drives(platform: Platform) -> bool:
    """Tell whether a vehicle can drive ahead: whether a thruster, perhaps turned by its azimuth, pushes along it."""
    return bool((abs(platform.actuator_wrenches()[:, X]) > REPORT.along_axis).any()) and _has_thrusters(platform)


def turns_at_rest(platform: Platform) -> bool:
    """Tell whether thrusters alone turn a vehicle, to both sides."""
    arm = platform.actuator_wrenches()[:, YAW]
    forwards, backwards = platform.full_forces().T
    turning = abs(arm) > MANOEUVRE.least_arm * platform.hull.length
    to_left = turning & ((arm * forwards > 0.0) | (arm * backwards < 0.0))
    to_right = turning & ((arm * forwards < 0.0) | (arm * backwards > 0.0))
    return bool(to_left.any() and to_right.any())


def _has_thrusters(platform: Platform) -> bool:
    return any(isinstance(each, Thruster) for each in platform.actuators)


def _turns(platform: Platform) -> bool:
    return turns_at_rest(platform) or (any(map(_steers, platform.actuators)) and drives(platform))


def _steers(actuator: object) -> bool:
    """Tell whether an actuator is a rudder, or a fin that pushes to the side."""
    return isinstance(actuator, Rudder) or (
        isinstance(actuator, Fin) and abs(actuator.direction[Y]) > REPORT.along_axis
    )


def _drives_and_turns(platform: Platform) -> bool:
    return drives(platform) and _turns(platform)


def _reverses(platform: Platform) -> bool:
    return any(
        isinstance(each, Thruster) and each.reverse > 0.0 and abs(each.direction[X]) > REPORT.along_axis
        for each in platform.actuators
    )


def _acts(platform: Platform) -> bool:
    return bool(platform.actuators)


NEEDS: dict[str, Callable[[Platform], bool]] = {
    "coast_down": drives,
    "zig_zag": _drives_and_turns,
    "four_headings": _drives_and_turns,
    "along_wall": drives,
    "follow_neighbour": _drives_and_turns,
    "steps": _has_thrusters,
    "ramps_through_zero": _has_thrusters,
    "thrust_staircase": _has_thrusters,
    "reverse_steps": _reverses,
    "crash_stops": _reverses,
    "repeat_at_end": _acts,
    "depth_staircase": dives,
    "pump_triangle": has_pump,
    "slow_turns": _turns,
    "surface_touch": dives,
    "rest": lambda platform: True,
    "ruler": _has_thrusters,
}
"""Abilities that a vehicle must have for each manoeuvre, by its actuators."""


def manoeuvre_of(effect: str) -> str | None:
    """Name of the manoeuvre that shows an effect of the catalogue, by its identifier; None if there is none."""
    return next((entry.manoeuvre for entry in ENTRIES if entry.id == effect and entry.manoeuvre), None)


def can_drive(platform: Platform, manoeuvre: str) -> bool:
    """Tell whether a vehicle has the actuators for a manoeuvre, given by name."""
    return NEEDS[manoeuvre](platform)


def advised(effects: Sequence[FoundEffect], unseen: Sequence[str], platform: Platform) -> tuple[str, ...]:
    """Choose up to three manoeuvres, by name, those first that serve most effects.

    They tell the found effects from their rivals, or, if there are no rivals, show effects that this recording could
    not show. A manoeuvre for which the vehicle has no actuator is never advised.
    """
    open_effects = [rival.id for effect in effects for rival in effect.ambiguous_with] + [
        effect.id for effect in effects if effect.ambiguous_with
    ]
    wanted = (manoeuvre_of(effect) for effect in dict.fromkeys(open_effects or unseen))
    names = [name for name in wanted if name and can_drive(platform, name)]
    return tuple(sorted(dict.fromkeys(names), key=lambda name: -names.count(name))[:3])
