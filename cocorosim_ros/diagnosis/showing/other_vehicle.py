"""Signs that recordings are of another vehicle: numbers of several kinds that differ by a factor, all at once.

What happens to one vehicle changes numbers of one kind by that much: a weak battery its thrust, a lost rope its drag.
Two causes change several. A load makes all forces weaker alike, since they are known relative to mass; growth makes
drag more and thrust less. The lift and the added mass of a hull are of its form: beside less drag, or another inertia,
they are of another hull. What differs in several kinds in any other way, or by more than either does, is of another
vehicle: then no difference has a name.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from cocorosim_ros.diagnosis.against.numbers import SURGE_DRAG, THRUST
from cocorosim_ros.diagnosis.criteria.against import SAME_VEHICLE
from cocorosim_ros.diagnosis.findings import Estimate, FoundEffect, Recalibrated
from cocorosim_ros.diagnosis.naming.single_thrusters import number_words, thruster_of
from cocorosim_ros.diagnosis.showing.case import Objection

_THRUST, _DRAG, _INERTIA = "thrust", "drag", "inertia"
_KINDS = {
    THRUST: _THRUST,
    "yaw_torque_gain": _THRUST,
    "drag": _DRAG,
    "yaw_drag": _DRAG,
    "inertia": _INERTIA,
    "buoyancy_gain": "buoyancy",
}
_OF_FORM = ("hull_lift", "added_mass")


class Change(NamedTuple):
    """A number of some kind, by its name, as a factor of what it was before."""

    kind: str
    name: str
    factor: Estimate
    robots: tuple[str, ...]


class Unlike(NamedTuple):
    """A robot, and its numbers that differ by much in several kinds at once; form: effects of its hull's form too."""

    robot: str
    changes: tuple[Change, ...]
    form: tuple[str, ...] = ()

    @property
    def factors(self) -> dict[str, float]:
        """Words of the numbers, and how many times what it was each is."""
        return {each.name: each.factor.value for each in self.changes}


def other_vehicles(moved: Sequence[Recalibrated], effects: Sequence[FoundEffect]) -> tuple[Unlike, ...]:
    """List the robots whose numbers differ in kind after kind as nothing that happens to one vehicle makes them.

    moved: numbers of the platform that differ; effects: all other differences, single thrusters among them.
    """
    return tuple(each for each in _unlike(moved, effects) if not (_is_load(each.changes) or _is_growth(each.changes)))


def under_a_load(moved: Sequence[Recalibrated], effects: Sequence[FoundEffect]) -> tuple[Objection, ...]:
    """Object to all differences of robots whose numbers are smaller alike, in kind after kind; () without any."""
    return tuple(
        Objection(
            f"Numbers of {each.robot} are smaller alike in kind after kind (times what they were: "
            f"{_told(each.changes)}), as under a load: weigh it, and give its mass, before these are taken for causes.",
            (each.robot,),
        )
        for each in _unlike(moved, effects)
        if _is_load(each.changes)
    )


def other_vehicle_sentence(unlike: Unlike) -> str:
    """Say of a robot which of its numbers differ too much for one vehicle, and what to do."""
    return (
        f"The recordings of {unlike.robot} and those of --against do not look like the same vehicle: its numbers "
        f"differ in kind after kind (times what they were: {_told(unlike.changes)}){_form_words(unlike)}. Nothing is "
        "named; give recordings of the same vehicle, or diagnose these by themselves with its own platform."
    )


def _unlike(moved: Sequence[Recalibrated], effects: Sequence[FoundEffect]) -> Iterator[Unlike]:
    large = [each for each in (*_of_platform(moved), *_of_effects(effects)) if _is_large(each.factor)]
    for robot in dict.fromkeys(name for each in large for name in each.robots):
        own = tuple(each for each in large if robot in each.robots)
        form = tuple(each.name for each in effects if each.id in _OF_FORM and robot in each.robots)
        of_hull = form if any(map(_is_of_another_hull, own)) else ()
        if len({*(each.kind for each in own), *of_hull}) >= SAME_VEHICLE.kinds:
            yield Unlike(robot, own, of_hull)


def _is_of_another_hull(change: Change) -> bool:
    """Tell whether a large change is one of inertia, or of drag that is less: growth and tethers make it more."""
    return change.kind == _INERTIA or (change.kind == _DRAG and change.factor.high < 1.0)


def _form_words(unlike: Unlike) -> str:
    return f", and so does the form of its hull ({', '.join(unlike.form)})" if unlike.form else ""


def _of_platform(moved: Sequence[Recalibrated]) -> Iterator[Change]:
    for each in moved:
        if each.parameter in _KINDS:
            before, now = each.nominal, each.estimate
            factor = Estimate(now.value / before, now.low / before, now.high / before, "1")
            yield Change(_KINDS[each.parameter], number_words(each.parameter), factor, each.robots)


def _of_effects(effects: Sequence[FoundEffect]) -> Iterator[Change]:
    for effect in effects:
        kind = _THRUST if thruster_of(effect.id) else _DRAG if effect.id == SURGE_DRAG else ""
        if kind:
            for factor in effect.parameters.values():
                yield Change(kind, number_words(effect.id), factor, effect.robots)


def _is_large(factor: Estimate) -> bool:
    """Tell whether the whole interval of a factor is beyond what is told as one difference among others."""
    return factor.low > SAME_VEHICLE.number_ratio or factor.high < 1.0 / SAME_VEHICLE.number_ratio


def _is_load(changes: Sequence[Change]) -> bool:
    """Tell whether all forces are smaller alike, and inertia is more by no more than a load makes it.

    Inertia is known relative to the moments of the thrusters, which seem weaker too.
    """
    forces = [each.factor.value for each in changes if each.kind != _INERTIA]
    if not forces or min(forces) <= 0.0:
        return False
    mean = math.exp(sum(map(math.log, forces)) / len(forces))
    inertias = [each.factor.value / mean for each in changes if each.kind == _INERTIA]
    return (
        max(forces) <= SAME_VEHICLE.alike * min(forces)
        and 1.0 <= SAME_VEHICLE.use * mean < SAME_VEHICLE.use
        and all(1.0 <= SAME_VEHICLE.alike * each <= SAME_VEHICLE.use * SAME_VEHICLE.alike**2 for each in inertias)
    )


def _is_growth(changes: Sequence[Change]) -> bool:
    """Tell whether drag is more and thrust less, by no more than growth makes them, and nothing else differs."""

    def grown(each: Change) -> bool:
        worse = {_DRAG: each.factor.low, _THRUST: 1.0 / each.factor.high if each.factor.high > 0.0 else math.inf}
        return each.kind in worse and 1.0 < worse[each.kind] <= SAME_VEHICLE.use

    return all(map(grown, changes))


def _told(changes: Sequence[Change]) -> str:
    return ", ".join(f"{each.name} {each.factor.value:.2g}" for each in changes)
