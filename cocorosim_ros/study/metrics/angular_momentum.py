"""Angular momentum: how far the robots circle around their centre.

m = |sum_i r_i x v_i| / N, with the vector r_i from the centre of the robots to robot i and the unit
direction v_i. r_i is a unit vector in Couzin et al. (0 <= m <= 1); the raw variant keeps its length, in
patches of 0.1 m as the NetLogo original measures. The norm is taken of the sum, in three dimensions. A
robot exactly at the centre, or one exactly at rest in the variants of travel, adds nothing to the sum and
counts in N; one that was absent at the previous tick does not count in the variants of travel. The paper
calls the same quantity angular momentum and angular velocity; the default follows Couzin et al.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.four import LANES, chosen
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.study.metrics.four_runs import (
    FourRuns,
    Vectors,
    flags,
    four_of,
    in_all,
    list_runs,
    numbers,
    put,
    vectors,
)
from cocorosim_ros.study.metrics.metric import COUZIN, READ, Family, Metric
from cocorosim_ros.study.metrics.swarms import MEAN, MEDIAN, Swarms

_PATCH = 0.1


class _Arms(NamedTuple):
    """The vectors from the centre to a robot of four runs, and 1 over their lengths."""

    x: Any
    y: Any
    z: Any
    per_length: Any


class _Sums(NamedTuple):
    """The sums of r x v over the robots of four runs: for unit r, and for raw r."""

    x: Any
    y: Any
    z: Any
    raw_x: Any
    raw_y: Any
    raw_z: Any


@kernel
def _arms(place: Vectors, centre: Vectors, inside: Any) -> _Arms:
    """From the centre to a robot; zeros where the robot is no member."""
    nothing = in_all(0.0)
    x = chosen(inside > 0.0, place.x - centre.x, nothing)
    y = chosen(inside > 0.0, place.y - centre.y, nothing)
    z = chosen(inside > 0.0, place.z - centre.z, nothing)
    length = math.sqrt(x * x + y * y + z * z)
    return _Arms(x, y, z, chosen(length > 0.0, 1.0 / length, nothing))


@kernel
def _no_sums() -> _Sums:
    nothing = in_all(0.0)
    return _Sums(nothing, nothing, nothing, nothing, nothing, nothing)


@kernel
def _added(sums: _Sums, r: _Arms, v: Vectors) -> _Sums:
    """The sums with one robot more.

    Who is no member has neither arm nor direction. The zeros that are added then change no bit: sums that begin at 0.0
    are never -0.0.
    """
    x, y, z = r.y * v.z - r.z * v.y, r.z * v.x - r.x * v.z, r.x * v.y - r.y * v.x
    return _Sums(
        sums.x + x * r.per_length,
        sums.y + y * r.per_length,
        sums.z + z * r.per_length,
        sums.raw_x + x,
        sums.raw_y + y,
        sums.raw_z + z,
    )


@kernel
def _put_momenta(sums: _Sums, count: Any, values: Floats, runs: FourRuns, column: int) -> None:
    """The momentum with unit r is in values[:, column], that with raw r in the next column."""
    x, y, z, raw_x, raw_y, raw_z = sums
    put(values, runs, column, math.sqrt(x * x + y * y + z * z) / count)
    put(values, runs, column + 1, math.sqrt(raw_x * raw_x + raw_y * raw_y + raw_z * raw_z) / count / _PATCH)


@kernel
def _measure_four(swarms: Swarms, population: int, runs: FourRuns, values: Floats, column: int) -> None:
    members, movers = swarms.members[population], swarms.movers[population]
    count, moving = in_all(0.0), in_all(0.0)
    headed, travelled, headed_median, travelled_median = _no_sums(), _no_sums(), _no_sums(), _no_sums()
    mean, median = _centre(swarms.centre[population, MEAN], runs), _centre(swarms.centre[population, MEDIAN], runs)
    for i in range(members.shape[1]):
        place, inside = vectors(swarms.position, runs, i), flags(members, runs, i)
        heading, travel = vectors(swarms.heading, runs, i), vectors(swarms.travel, runs, i)
        count, moving = count + inside, moving + flags(movers, runs, i)
        arm = _arms(place, mean, inside)
        headed, travelled = _added(headed, arm, heading), _added(travelled, arm, travel)
        arm = _arms(place, median, inside)
        headed_median, travelled_median = _added(headed_median, arm, heading), _added(travelled_median, arm, travel)
    _put_momenta(headed, count, values, runs, column)
    _put_momenta(travelled, moving, values, runs, column + 2)
    _put_momenta(headed_median, count, values, runs, column + 4)
    _put_momenta(travelled_median, moving, values, runs, column + 6)


@kernel
def _centre(centre: Floats, runs: FourRuns) -> Vectors:
    return Vectors(numbers(centre, runs, 0), numbers(centre, runs, 1), numbers(centre, runs, 2))


@kernel
def _measure(swarms: Swarms, values: Floats, column: int) -> int:
    for population in range(2):
        count = list_runs(swarms, population)
        for first in range(0, count, LANES):
            _measure_four(swarms, population, four_of(swarms.runs, first, count), values, column + 8 * population)
    for run in range(values.shape[0]):
        if swarms.one_shoal[run]:
            for here in range(column + 8, column + 16):
                values[run, here] = values[run, here - 8]
    return column + 16


def _metric(members: str, centre: str, direction: str, raw: str) -> Metric:
    who = "the largest shoal's robots" if members else "all robots"
    length = "the vector (in patches of 0.1 m)" if raw else "the unit vector"
    middle = "coordinate-wise median" if centre else "mean"
    way = "direction of travel" if direction else "heading"
    formula = (
        f"length of the sum of r x v over {who}, divided by their number; r is {length} from their {middle} "
        f"position, v the unit vector of {way}"
    )
    name = f"angular_momentum{raw}{direction}{centre}{members}"
    unit = "0.1 m" if raw else "1"
    paper = name == "angular_momentum"
    return Metric(name, unit, formula, f"{COUZIN}; {READ}", paper=paper, frame_free=not centre)


FAMILY = Family(
    metrics=tuple(
        _metric(members, centre, direction, raw)
        for members in ("", "_largest")
        for centre in ("", "_median_centre")
        for direction in ("", "_travel")
        for raw in ("", "_raw")
    ),
    measure=_measure,
)
