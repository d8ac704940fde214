"""Signs that recordings are of another vehicle: numbers of several kinds that differ by a factor, all at once.

What happens to one vehicle changes numbers of one kind by that much: a weak battery its thrust, growth on the hull its
drag. Those of another hull differ in kind after kind. Mass is in each of them, since forces are known relative to it.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from cocorosim_ros.diagnosis.against.numbers import THRUST
from cocorosim_ros.diagnosis.criteria.against import SAME_VEHICLE
from cocorosim_ros.diagnosis.findings import Estimate, FoundEffect, Recalibrated
from cocorosim_ros.diagnosis.naming.single_thrusters import number_words, thruster_of
from cocorosim_ros.diagnosis.showing.case import Objection

_THRUST, _DRAG = "thrust", "drag"
_KINDS = {
    THRUST: _THRUST,
    "yaw_torque_gain": _THRUST,
    "drag": _DRAG,
    "yaw_drag": _DRAG,
    "inertia": "inertia",
    "buoyancy_gain": "buoyancy",
}


class Change(NamedTuple):
    """A number of some kind, by its name, as a factor of what it was before."""

    kind: str
    name: str
    factor: Estimate
    robots: tuple[str, ...]


def as_another_vehicle(moved: Sequence[Recalibrated], effects: Sequence[FoundEffect]) -> tuple[Objection, ...]:
    """Object to all differences of robots of which numbers of several kinds differ by a factor; () without any.

    moved: numbers of the platform that differ; effects: all other differences, single thrusters among them.
    """
    large = [each for each in (*_of_platform(moved), *_of_thrusters(effects)) if _is_large(each.factor)]
    robots = dict.fromkeys(name for each in large for name in each.robots)
    by_robot = {robot: [each for each in large if robot in each.robots] for robot in robots}
    return tuple(
        Objection(_sentence(own, robot), (robot,))
        for robot, own in by_robot.items()
        if len({each.kind for each in own}) >= SAME_VEHICLE.kinds
    )


def _of_platform(moved: Sequence[Recalibrated]) -> Iterator[Change]:
    for each in moved:
        if each.parameter in _KINDS:
            before, now = each.nominal, each.estimate
            factor = Estimate(now.value / before, now.low / before, now.high / before, "1")
            yield Change(_KINDS[each.parameter], number_words(each.parameter), factor, each.robots)


def _of_thrusters(effects: Sequence[FoundEffect]) -> Iterator[Change]:
    for effect in effects:
        if thruster_of(effect.id):
            for gain in effect.parameters.values():
                yield Change(_THRUST, number_words(effect.id), gain, effect.robots)


def _is_large(factor: Estimate) -> bool:
    """Tell whether the whole interval of a factor is beyond what happens to one vehicle."""
    return factor.low > SAME_VEHICLE.number_ratio or factor.high < 1.0 / SAME_VEHICLE.number_ratio


def _sentence(changes: Sequence[Change], robot: str) -> str:
    told = ", ".join(f"{each.name} {each.factor.value:.2g}" for each in changes)
    return (
        f"Numbers of {robot} differ in kind after kind from those of the recordings of --against (times what they "
        f"were: {told}), as those of another vehicle do; check that both are of the same one."
    )
