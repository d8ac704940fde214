"""A platform with `six_degrees` as one in surge, sway, heave and yaw, which is what a diagnosis moves.

Beside `mass`, the file has `yaw_inertia`, `drag`, `yaw_drag` and `drag_form`, of which a simulation in six degrees of
freedom takes nothing. What stands below six_degrees holds; a number outside that is another one is told.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from typing import Any

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.parts.actuator_checks import MOST_FINS
from cocorosim_ros.scenario.parts.effect_quantities import Effects
from cocorosim_ros.scenario.parts.fin import Fin
from cocorosim_ros.scenario.parts.level_numbers import CARRIED, EFFECTS, SIX, SURGE, LevelNumber, level_numbers
from cocorosim_ros.scenario.parts.platform import DragForm, Platform
from cocorosim_ros.scenario.parts.six_degrees import SixDegrees
from cocorosim_ros.scenario.parts.sliding_mass import SlidingMass
from cocorosim_ros.scenario.reading.entry import listed
from cocorosim_ros.scenario.reading.quantity import Quantity, dimension_of
from cocorosim_ros.scenario.reading.ranges import Range, Ranges

DRAG_FORM: DragForm = "own_speed"
ROUNDED = 0.01  # of a number that the file gives twice: how far apart the two may be, for one of them may be rounded
REPEATED = ("yaw_inertia", "drag", "yaw_drag")
"""Numbers that stand outside six_degrees too; `mass` is the vehicle's own alone there."""
TILTING = {"roll", "pitch"}


def in_four_degrees(platform: Platform) -> Platform:
    """The platform, and those of its robots, in surge, sway, heave and yaw alone; as it is without six_degrees.

    Ranges of numbers below six_degrees become those of what is made of them. What the vehicle has beyond is told in
    `told`. Raises CocorosimError for actuators that have no part in four degrees of freedom.
    """
    robots = {name: _level(robot) for name, robot in platform.robots.items()}
    return replace(_level(platform), robots=robots)


def _level(platform: Platform) -> Platform:
    six = platform.six_degrees
    if six is None:
        return platform
    _check_actuators(platform)
    numbers = level_numbers(platform, six)
    ranges = _carried(platform, platform.ranges, numbers, every=False)
    basic: dict[str, Any] = {each.key: each.value for each in numbers if not each.key.startswith(EFFECTS)}
    return replace(
        platform,
        **basic,
        drag_form=DRAG_FORM,
        six_degrees=None,
        effect_quantities=_effects(each for each in numbers if each.value != each.neutral or each.key in ranges),
        ranges=ranges,
        intervals=_carried(platform, platform.intervals, numbers, every=True),
        kept_as_given=_kept(platform, numbers),
        told=(_sentence(platform, six, _other_numbers(platform, numbers).values()),),
    )


def _check_actuators(platform: Platform) -> None:
    """Refuse what moves nothing, or too much, in four degrees of freedom."""
    place = f"{platform.origin}: a diagnosis knows surge, sway, heave and yaw, and"
    sliding = [part.name for part in platform.actuators if isinstance(part, SlidingMass)]
    if sliding:
        raise CocorosimError(
            f"{place} '{sliding[0]}' is a sliding mass, which moves none of these; take a copy of the platform without "
            "it, and of the recording without its commands: what it does is in recorded roll and pitch."
        )
    fins = sum(isinstance(part, Fin) for part in platform.actuators)
    if fins > MOST_FINS:
        raise CocorosimError(
            f"{place} {MOST_FINS} fins are the most there, where 'actuators' has {fins}; write those that turn "
            "together as one of all their area."
        )


def _effects(numbers: Iterable[LevelNumber]) -> Effects:
    """The effects beyond the basic physics."""
    found: dict[str, dict[str, Quantity]] = {}
    for each in numbers:
        if each.key.startswith(EFFECTS):
            effect, _, name = each.key.removeprefix(EFFECTS).partition(".")
            found.setdefault(effect, {})[name] = Quantity(each.value, each.unit, dimension_of(each.unit))
    return found


def _carried(platform: Platform, given: Ranges, numbers: Sequence[LevelNumber], *, every: bool) -> Ranges:
    """Ranges or intervals of the level vehicle: of what stays as it is in the file, and of what is made of others.

    every: whether all that a number is made of has to have one.
    """
    gone = {"mass", *_other_numbers(platform, numbers)}
    found = {key: part for key, part in given.items() if not key.startswith(SIX) and key not in gone}
    for each in numbers:
        known = [key for key in each.made_of if key in given]
        if known and (len(known) == len(each.made_of) or not every):
            ends = [_shift(each.made_of[key], _value(platform, key), given[key]) for key in known]
            low, high = (each.value + sum(end[side] for end in ends) for side in (0, 1))
            found[each.key] = Range(low, high, each.unit)
    return found


def _shift(factor: float, value: float, between: Range) -> tuple[float, float]:
    """By how much a number changes at most, downwards and upwards, with one whose range this is."""
    low, high = sorted((factor * (between.low - value), factor * (between.high - value)))
    return low, high


def _value(platform: Platform, key: str) -> float:
    """The number of the platform's record at a dotted key."""
    part: Any = platform
    for name in key.split("."):
        part = part[int(name)] if isinstance(part, tuple) else getattr(part, name)
    return float(part.value if isinstance(part, Quantity) else part)


def _kept(platform: Platform, numbers: Sequence[LevelNumber]) -> tuple[str, ...] | None:
    """Keys of numbers that a diagnosis does not fit, each by that of what is first made of it."""
    if platform.kept_as_given is None:
        return None
    made = {source: each.key for each in reversed(numbers) for source in each.made_of}
    keys = [made.get(key, key) for key in platform.kept_as_given]
    return tuple(dict.fromkeys(key for key in keys if not key.startswith(SIX)))


def _other_numbers(platform: Platform, numbers: Sequence[LevelNumber]) -> dict[str, str]:
    """By key what the file gives outside six_degrees unlike these, in words; mass is another thing there."""
    said = {}
    for each in numbers:
        if each.key in REPEATED:
            outside = getattr(platform, each.key)
            if not math.isclose(outside, each.value, rel_tol=ROUNDED):
                said[each.key] = f"'{each.key}' of {outside:g} {each.unit} (it gives {each.value:.4g} {each.unit})"
    if platform.drag_form not in (None, DRAG_FORM):
        said["drag_form"] = f"'drag_form: {platform.drag_form}' (in it drag goes by each axis' own speed)"
    return said


def _sentence(platform: Platform, six: SixDegrees, other: Iterable[str]) -> str:
    """What the level vehicle has not, and which numbers outside six_degrees do not hold."""
    missing = [*_uncarried(six), *other]
    beside = f", and {listed(missing, 'and')}" if missing else ""
    return (
        f"{platform.origin}: the vehicle is diagnosed in surge, sway, heave and yaw by what 'six_degrees' gives, with "
        f"roll and pitch as they are recorded; left out is what makes it roll and pitch{beside}."
    )


def _uncarried(six: SixDegrees) -> Iterator[str]:
    """Parts of a level motion that have no number in four degrees of freedom."""
    for part in six.couplings:
        if not {part.force, part.motion} & TILTING and (part.matrix, part.force, part.motion) not in CARRIED:
            yield f"the '{part.matrix}' of {part.motion} on {part.force}"
    if not six.quadratic_damping[SURGE] and any(six.quadratic_damping):
        yield "quadratic drag across and upwards, since there is none ahead to which it could be a ratio"
