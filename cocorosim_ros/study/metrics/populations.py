"""Distances, shoals, the largest shoal and the centres of both populations."""

from __future__ import annotations

import numpy as np

from cocorosim_ros.foundation.arrays import Flags, Floats, Integers
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.study.metrics.median import median_of_first
from cocorosim_ros.study.metrics.swarms import ALL, CONTACT_RANGE, LARGEST, MEAN, MEDIAN, Swarms

_CONTACT_SQUARED = CONTACT_RANGE * CONTACT_RANGE


@kernel
def fill_distances(swarms: Swarms) -> None:
    """Fill `squared`."""
    position, members, squared = swarms.position, swarms.members[ALL], swarms.squared
    for run in range(members.shape[0]):
        pair = 0
        for i in range(members.shape[1]):
            for j in range(i + 1, members.shape[1]):
                x = position[run, j, 0] - position[run, i, 0]
                y = position[run, j, 1] - position[run, i, 1]
                z = position[run, j, 2] - position[run, i, 2]
                both = members[run, i] and members[run, j]
                squared[run, pair] = x * x + y * y + z * z if both else np.inf
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
        members, centre = swarms.members[population], swarms.centre[population]
        for run in range(members.shape[0]):
            if population == LARGEST and swarms.one_shoal[run]:
                for axis in range(3):
                    centre[MEAN, run, axis] = swarms.centre[ALL, MEAN, run, axis]
                    centre[MEDIAN, run, axis] = swarms.centre[ALL, MEDIAN, run, axis]
            else:
                write_centres(swarms.position, members, run, centre, swarms.scratch)


@kernel
def write_centres(
    position: Floats,
    members: Flags,
    run: int,
    centre: Floats,
    scratch: Floats,
) -> None:
    """The members' mean position and the median of each coordinate are in centre[:, run]; NaN of nobody.

    position: (runs, n, 3) [m; world]; members: (runs, n); centre: (2, runs, 3); scratch: at least (n + 1,).
    """
    for axis in range(3):
        total, count = 0.0, 0
        for i in range(members.shape[1]):
            if members[run, i]:
                scratch[count] = position[run, i, axis]
                total += position[run, i, axis]
                count += 1
        centre[MEAN, run, axis] = total / count if count > 0 else np.nan
        centre[MEDIAN, run, axis] = median_of_first(scratch, count)
