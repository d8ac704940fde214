"""A diagnosis as pages and the terminal show it: without what the recordings do not show.

Where a map fixes the height of a vehicle, or nothing shows its depth, its motion upwards is told by no reading: errors
of depth, forces upwards and effects that act by depth are left out. diagnosis.json and the found model keep all.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from dataclasses import replace
from typing import NamedTuple, TypeVar

from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES
from cocorosim_ros.diagnosis.catalogue.manoeuvres import NEEDS, dives, has_pump
from cocorosim_ros.diagnosis.filter.layout import KIND_NAMES, KINDS_OF_STREAM
from cocorosim_ros.diagnosis.findings import Diagnosis, FoundEffect, Located, ResidualForce, Unrecorded
from cocorosim_ros.diagnosis.fitting.vehicle_needs import moves_in_air
from cocorosim_ros.diagnosis.report.regressors import OF_BODY
from cocorosim_ros.diagnosis.tracks.columns import READING_NOISE_OF_KIND
from cocorosim_ros.scenario.parts.platform import Platform
from cocorosim_ros.scenario.parts.vehicle_parts import Thruster
from cocorosim_ros.world.laws.law import subject_and_product
from cocorosim_ros.world.state.state import HEAVE, Z

_Value = TypeVar("_Value")
_UPRIGHT_NOISE = "random.heave_force"
_UPRIGHT_EQUATIONS = ("heave", "world_z")
_UPRIGHT_NUMBERS = ("buoyancy_gain",)
_UPRIGHT_EFFECTS = frozenset(entry.id for entry in ENTRIES if entry.channel == "heave")
_UP_OR_DOWN = tuple(name for name, need in NEEDS.items() if need in (dives, has_pump))
_BY_DEPTH = _UPRIGHT_EFFECTS | {entry.id for entry in ENTRIES if entry.manoeuvre in _UP_OR_DOWN}
_ENTRIES = {(entry.id, entry.topic): entry for entry in ENTRIES}


def _reverses(platform: Platform) -> bool:
    return any(each.reverse > 0.0 for each in _thrusters(platform))


_ORGANS: dict[str, Callable[[Platform], bool]] = {
    "pump_lag": has_pump,
    "reverse_loss": _reverses,
    "crashback_loss": _reverses,
    "thruster_asymmetry": lambda platform: len(_thrusters(platform)) > 1,
    "hull_emergence": lambda platform: not moves_in_air(platform),
    "surface_loss": lambda platform: not moves_in_air(platform),
    "surface_waves": lambda platform: not moves_in_air(platform),
    "wash_loss": lambda platform: any(each.diameter is not None for each in _thrusters(platform)),
}
"""Effects of actuators, and of a surface, that not every vehicle has, by identifier, and whether one has them."""


def as_recorded(diagnosis: Diagnosis, platform: Platform | None = None) -> Diagnosis:
    """Copy a diagnosis without what its recordings do not show, nor effects of actuators that the platform lacks."""
    lacking = {name for name, has in _ORGANS.items() if platform is not None and not has(platform)}
    gone = diagnosis.unrecorded
    shown = _with_sizes(diagnosis, _Sizes(lacking, {*gone.readings, *gone.absent}))
    if gone == Unrecorded():
        return shown
    shown = replace(
        shown,
        noise={name: each for name, each in shown.noise.items() if not _is_unread(name, gone)},
        fit={channel: row for channel, row in shown.fit.items() if not _is_unmeasured(channel, gone)},
    )
    return _without_depth(shown) if gone.depth else shown


class _Sizes(NamedTuple):
    """Sizes from which effects would be seen that are left out: of whole effects, and of numbers of any effect."""

    effects: Collection[str]
    numbers: Collection[str]
    upright: bool = False  # whether numbers of motion upwards are left out too

    def keeps(self, name: str) -> bool:
        """Tell whether an effect stays, by its name or as effect:stream or effect:number."""
        effect, _, number = name.partition(":")
        return effect not in self.effects and not self._is_gone(number)

    def of(self, numbers: Mapping[str, _Value]) -> dict[str, _Value]:
        """Copy what is told by number, without the numbers that are left out."""
        return {name: each for name, each in numbers.items() if not self._is_gone(name)}

    def _is_gone(self, number: str) -> bool:
        return number in self.numbers or (self.upright and _is_upright(number))


def _with_sizes(diagnosis: Diagnosis, sizes: _Sizes) -> Diagnosis:
    """Copy a diagnosis without some effects and numbers where it tells from which size they would be seen."""
    against = diagnosis.against
    if against is not None:
        seen = {name: sizes.of(numbers) for name, numbers in against.seen_from.items() if sizes.keeps(name)}
        against = replace(against, seen_from=seen)
    return replace(
        diagnosis,
        screened=tuple(
            replace(each, detectable=sizes.of(each.detectable)) for each in diagnosis.screened if sizes.keeps(each.id)
        ),
        not_shown=tuple(name for name in diagnosis.not_shown if sizes.keeps(name)),
        against=against,
    )


def _without_depth(diagnosis: Diagnosis) -> Diagnosis:
    """Leave out numbers of motion upwards. An effect that was named stays, whatever it acts by."""
    return replace(
        _with_sizes(diagnosis, _Sizes(_BY_DEPTH, (), upright=True)),
        recalibrated=tuple(each for each in diagnosis.recalibrated if not _is_upright(each.parameter)),
        all_recalibrated=tuple(each for each in diagnosis.all_recalibrated if not _is_upright(each.parameter)),
        mismatch=tuple(each for each in diagnosis.mismatch if not _is_located_upright(each)),
        effects=tuple(map(_level, diagnosis.effects)),
        passed_over=tuple(replace(each, found=_level(each.found)) for each in diagnosis.passed_over),
        screened_laws=tuple(each for each in diagnosis.screened_laws if not _is_upright_law(each.id)),
        noise={name: each for name, each in diagnosis.noise.items() if name != _UPRIGHT_NOISE},
        residual_before=tuple(map(_level_force, diagnosis.residual_before)),
        residual_after=tuple(map(_level_force, diagnosis.residual_after)),
    )


def _level(found: FoundEffect) -> FoundEffect:
    """Copy an effect without its numbers of motion upwards, nor their parts of its equation."""
    numbers = {name: each for name, each in found.parameters.items() if not _is_upright(name)}
    entry = _ENTRIES.get((found.id, found.topic))
    if entry is None or not numbers or len(numbers) == len(found.parameters):
        return replace(found, parameters=numbers)
    return replace(found, parameters=numbers, equation=entry.shown_equation(numbers))


def _level_force(residual: ResidualForce) -> ResidualForce:
    """Copy a residual force without its part upwards, along a course of one height."""
    force, state = residual.force.copy(), residual.course.state.copy()
    force[:, OF_BODY.index("heave")] = 0.0
    state[:, [Z, HEAVE]] = 0.0
    return replace(residual, force=force, course=residual.course._replace(state=state))


def _is_upright(number: str) -> bool:
    """Tell whether a number, which may have the name of its effect before a dot, is of motion upwards."""
    effect, _, name = number.rpartition(".")
    upright = name.startswith("heave") or name.endswith("_dz") or name in _UPRIGHT_NUMBERS
    return upright or effect in _UPRIGHT_EFFECTS


def _is_located_upright(located: Located) -> bool:
    return (located.law.of if located.law is not None else located.equation) in _UPRIGHT_EQUATIONS


def _is_upright_law(identifier: str) -> bool:
    equation, _ = subject_and_product(identifier)
    return equation in _UPRIGHT_EQUATIONS


def _is_unread(noise: str, gone: Unrecorded) -> bool:
    """Tell whether a number of noise is of readings none of which vary."""
    _, _, name = noise.partition(".")
    kinds = {kind for kind, own in zip(KIND_NAMES, READING_NOISE_OF_KIND, strict=True) if own == name}
    return bool(kinds) and kinds <= set(gone.readings)


def _is_unmeasured(channel: str, gone: Unrecorded) -> bool:
    """Tell whether free runs have nothing to err by on a channel, or readings of a stream do not vary."""
    if channel == "depth":
        return gone.depth
    kinds = {KIND_NAMES[kind] for kind in KINDS_OF_STREAM.get(channel, ())}
    return bool(kinds) and kinds <= set(gone.readings)


def _thrusters(platform: Platform) -> list[Thruster]:
    return [each for each in platform.actuators if isinstance(each, Thruster)]
