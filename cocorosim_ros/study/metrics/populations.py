"""Distances, shoals, the largest shoal and the centres of both populations."""

from __future__ import annotations

import numpy as np

from cocorosim_ros.foundation.arrays import Flags, Floats, Integers
from cocorosim_ros.foundation.compiling.four import LANES, chosen, in_fours
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.study.metrics.four_runs import FourRuns, coordinates, flags, four_of, in_all, list_runs, put, vectors
from cocorosim_ros.study.metrics.median_of_four import middles, no_filling, put_or_leave_out
from cocorosim_ros.study.metrics.swarms import ALL, CONTACT_RANGE, LARGEST, MEAN, MEDIAN, Swarms

_CONTACT_SQUARED = CONTACT_RANGE * CONTACT_RANGE


@kernel
def fill_distances(swarms: Swarms) -> None:
    """Fill `squared`."""
    members, squared, count = swarms.members[ALL], swarms.squared, list_runs(swarms, ALL)
    robot = in_fours(swarms.rows_of_robots)
    for first in range(0, count, LANES):
        runs, pair = four_of(swarms.runs, first, count), 0
        for i in range(members.shape[1]):
            robot[i, 0], robot[i, 1], robot[i, 2] = vectors(swarms.position, runs, i)
            robot[i, 3] = flags(members, runs, i)
        for i in range(members.shape[1]):
            for j in range(i + 1, members.shape[1]):
                x, y, z = robot[j, 0] - robot[i, 0], robot[j, 1] - robot[i, 1], robot[j, 2] - robot[i, 2]
                both = robot[i, 3] * robot[j, 3] > 0.0
                put(squared, runs, pair, chosen(both, x * x + y * y + z * z, in_all(np.inf)))
                pair += 1


@kernel
def fill_shoals(swarms: Swarms) -> None:
    """Fill `shoal` by joining the trees of robots within range (union-find; the lowest is the root)."""
    members, squared, shoal = swarms.members[ALL], swarms.squared, swarms.shoal
    for run in range(shoal.shape[0]):
        for i in range(shoal.shape[1]):
            shoal[run, i] = i if members[run, i] else -1
        pair = 0
        for i in range(shoal.shape[1]):
            for j in range(i + 1, shoal.shape[1]):
                if squared[run, pair] <= _CONTACT_SQUARED and shoal[run, i] != shoal[run, j]:
                    a, b = _root(shoal, run, i), _root(shoal, run, j)
                    shoal[run, max(a, b)] = min(a, b)
                pair += 1
        for i in range(shoal.shape[1]):
            if members[run, i]:
                shoal[run, i] = _root(shoal, run, i)


@kernel
def _root(shoal: Integers, run: int, i: int) -> int:
    while shoal[run, i] != i:
        shoal[run, i] = shoal[run, shoal[run, i]]
        i = shoal[run, i]
    return i


@kernel
def fill_populations(swarms: Swarms) -> None:
    """Fill `members[LARGEST]`, `movers[LARGEST]` and `one_shoal`."""
    shoal, members, movers = swarms.shoal, swarms.members, swarms.movers
    for run in range(shoal.shape[0]):
        largest = _largest_shoal(shoal, swarms.position, run)
        same = True
        for i in range(shoal.shape[1]):
            inside = largest >= 0 and shoal[run, i] == largest
            members[LARGEST, run, i] = inside
            movers[LARGEST, run, i] = inside and movers[ALL, run, i]
            same = same and inside == members[ALL, run, i]
        swarms.one_shoal[run] = same


@kernel
def _largest_shoal(shoal: Integers, position: Floats, run: int) -> int:
    """Root of the largest shoal, -1 if nobody has company."""
    best, best_size, best_spread = -1, 1, -1.0
    for root in range(shoal.shape[1]):
        if shoal[run, root] != root:
            continue
        size = 0
        for i in range(root, shoal.shape[1]):
            size += shoal[run, i] == root
        if size > best_size:
            best, best_size, best_spread = root, size, -1.0
        elif size == best_size and best >= 0:
            if best_spread < 0.0:
                best_spread = _spread(shoal, position, run, best)
            spread = _spread(shoal, position, run, root)
            if spread < best_spread:
                best, best_spread = root, spread
    return best


@kernel
def _spread(shoal: Integers, position: Floats, run: int, root: int) -> float:
    """Sum of squared distances of a shoal's robots from their mean position."""
    total = 0.0
    for axis in range(3):
        mean, count = 0.0, 0
        for i in range(shoal.shape[1]):
            if shoal[run, i] == root:
                mean += position[run, i, axis]
                count += 1
        mean /= count
        for i in range(shoal.shape[1]):
            if shoal[run, i] == root:
                total += (position[run, i, axis] - mean) ** 2
    return total


@kernel
def fill_centres(swarms: Swarms) -> None:
    """Fill `centre`."""
    for population in range(2):
        count = list_runs(swarms, population)
        write_centres(swarms.position, swarms.members[population], count, swarms.centre[population], swarms)
    everybody, largest = swarms.centre[ALL], swarms.centre[LARGEST]
    for run in range(swarms.one_shoal.shape[0]):
        if swarms.one_shoal[run]:
            copy_centres(everybody, run, largest)


@kernel
def copy_centres(source: Floats, run: int, target: Floats) -> None:
    """Copy the centres (2, runs, 3) of one run."""
    for axis in range(3):
        target[MEAN, run, axis] = source[MEAN, run, axis]
        target[MEDIAN, run, axis] = source[MEDIAN, run, axis]


@kernel
def write_centres(position: Floats, members: Flags, count: int, centre: Floats, swarms: Swarms) -> None:
    """The members' mean position and the median of each coordinate are in centre[:, run]; NaN of nobody.

    Of the first `count` of `swarms.runs`, whose working space for medians is used, too.
    position: (runs, n, 3) [m; world]; members: (runs, n); centre: (2, runs, 3).
    """
    for first in range(0, count, LANES):
        runs = four_of(swarms.runs, first, count)
        for axis in range(3):
            _write_centre(position, members, runs, axis, centre, swarms)


@kernel
def _write_centre(position: Floats, members: Flags, runs: FourRuns, axis: int, centre: Floats, swarms: Swarms) -> None:
    rows, filling, total, number = in_fours(swarms.rows), no_filling(), in_all(0.0), in_all(0.0)
    for i in range(members.shape[1]):
        coordinate, inside = coordinates(position, runs, i, axis), flags(members, runs, i)
        filling = put_or_leave_out(rows, i, coordinate, inside > 0.0, filling)
        # Zeros change no bit: a sum that begins at 0.0 is never -0.0.
        total, number = total + chosen(inside > 0.0, coordinate, in_all(0.0)), number + inside
    lower, upper = middles(swarms.rows, members.shape[1], filling, runs, swarms.scratch)
    put(centre[MEAN], runs, axis, chosen(number > 0.0, total / number, in_all(np.nan)))
    put(centre[MEDIAN], runs, axis, 0.5 * (lower + upper))
