"""Who is near whom: for every robot the others within reach, in ascending order of their numbers.

Sensors and radio look through these lists instead of through all robots. A list holds everybody within `reach`
and perhaps somebody a hair beyond, never less: who reads it measures distances himself, so that what a robot
senses does not depend on how its neighbours were found, bit for bit.

Up to GRID_FROM robots all pairs are compared; larger swarms are sorted into cells at least as wide as the reach,
and only robots of the same or touching cells are compared, so that the cost of a robot depends on the density of
the swarm and not on its size.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from cocorosim_ros.foundation.arrays import Floats, Integers
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.foundation.compiling.stretch import Stretch, ends_of
from cocorosim_ros.foundation.side_by_side import SideBySide
from cocorosim_ros.world.state.state import X, Y, Z
from cocorosim_ros.world.surroundings.tank import Tank

GRID_FROM = 48  # robots; below, sorting costs more than it saves
MOST_CELLS_PER_ROBOT = 8  # cells beyond that are made wider
FIRST_CAPACITY = 24  # neighbours that a robot of a large swarm has room for at first
MARGIN = 1e-9  # relative widening of the reach, so that rounding can never lose somebody


class Neighbours(NamedTuple):
    """Lists of neighbours with leading axes (runs, robots)."""

    near: Integers  # (runs, robots) how many are near
    who: NDArray[np.int32]  # (runs, robots, capacity) their numbers, ascending; what lies beyond `near` is void


class Grid(NamedTuple):
    """Cells that cover the tank."""

    lower: Floats  # (3,) corner of the first cell [m; world]
    per_metre: Floats  # (3,) cells per metre along each axis
    size: Integers  # (3,) cells along each axis


class Sorting(NamedTuple):
    """The robots of one run in the order of their cells."""

    cell: Integers  # (robots,) of each robot
    start: Integers  # (cells + 1,) where each cell begins in the order
    order: Integers  # (robots,) cell by cell, ascending in each
    place: Floats  # (robots, 3) in that order [m; world]


def cover(tank: Tank, reach: float, robots: int) -> Grid:
    """Cells at least as wide as `reach` [m] over the whole tank; wider ones where there would be too many."""
    extent = np.maximum(tank.upper - tank.lower, 1e-9)
    width = max(reach * (1.0 + 2.0 * MARGIN), 1e-9)
    width = max(width, float(np.prod(extent) / (MOST_CELLS_PER_ROBOT * robots)) ** (1.0 / 3.0))
    size = np.maximum(np.floor(extent / width), 1.0).astype(np.int64)
    return Grid(tank.lower, size / extent, size)


class NeighbourSearch:
    """Finds the neighbours of all robots of all runs, again and again, in the same arrays."""

    def __init__(
        self, runs: int, robots: int, tank: Tank, reach: float, side_by_side: SideBySide | None = None
    ) -> None:
        """`reach` [m]: as far as any robot senses or is heard; `side_by_side` goes through the robots of one run."""
        self._grid = cover(tank, reach, robots)
        self._squared = (reach * (1.0 + MARGIN)) ** 2
        self._gridded = robots > GRID_FROM
        self._lists = _empty_lists(runs, robots, FIRST_CAPACITY if self._gridded else max(1, robots - 1))
        in_threads = self._gridded and runs == 1 and side_by_side is not None and side_by_side.threaded
        self._side_by_side = side_by_side if in_threads else None
        self._sorting = empty_sorting(robots, self._grid)

    def find(self, state: Floats) -> Neighbours:
        """The neighbours in `state` (runs, robots, columns); the arrays are those of the next call too."""
        if not self._gridded:
            pair_up(state, self._squared, self._lists)
            return self._lists
        most = self._most_found(state)
        if most > self._lists.who.shape[2]:
            runs, robots = state.shape[:2]
            self._lists = _empty_lists(runs, robots, min(robots, most + most // 2))
            self._most_found(state)
        return self._lists

    def _most_found(self, state: Floats) -> int:
        """Fill the lists, cut where they are full; return the most neighbours that anybody has."""
        squared, grid, sorting, lists = self._squared, self._grid, self._sorting, self._lists
        if self._side_by_side is None:
            return int(sort_and_pair_up(state, squared, grid, sorting, lists))
        sort_into_cells(state, 0, grid, sorting)
        found: list[int] = []
        self._side_by_side.do(lambda robots: found.append(pair_up_some(0, robots, squared, grid, sorting, lists)))
        return max(found)


def _empty_lists(runs: int, robots: int, capacity: int) -> Neighbours:
    return Neighbours(np.zeros((runs, robots), np.int64), np.zeros((runs, robots, capacity), np.int32))


@kernel
def pair_up(state: Floats, squared_reach: float, lists: Neighbours) -> None:
    """Fill `lists`, which have room for everybody, by comparing all pairs.

    No branch on who is near, of which a processor would guess every third wrong: a number is written in any case and
    counts where it belongs. There is room for it, as no pair is compared twice.
    """
    near, who = lists.near, lists.who
    for run in range(state.shape[0]):
        for robot in range(state.shape[1]):
            near[run, robot] = 0
        for one in range(state.shape[1]):
            x, y, z = state[run, one, X], state[run, one, Y], state[run, one, Z]
            mine = near[run, one]
            for other in range(one + 1, state.shape[1]):
                east, north, up = state[run, other, X] - x, state[run, other, Y] - y, state[run, other, Z] - z
                is_near = int(east * east + north * north + up * up <= squared_reach)
                theirs = near[run, other]
                who[run, one, mine] = other
                who[run, other, theirs] = one
                near[run, other] = theirs + is_near
                mine += is_near
            near[run, one] = mine


def empty_sorting(robots: int, grid: Grid) -> Sorting:
    """Room for the order of so many robots."""
    cells = int(np.prod(grid.size))
    return Sorting(
        np.empty(robots, np.int64), np.empty(cells + 1, np.int64), np.empty(robots, np.int64), np.empty((robots, 3))
    )


@kernel
def sort_and_pair_up(state: Floats, squared_reach: float, grid: Grid, sorting: Sorting, lists: Neighbours) -> int:
    """Fill `lists` by comparing robots of touching cells; return the most neighbours that anybody has.

    A list is cut where it is full: then the result exceeds the capacity.
    """
    most = 0
    for run in range(state.shape[0]):
        sort_into_cells(state, run, grid, sorting)
        most = max(most, pair_up_some(run, None, squared_reach, grid, sorting, lists))
    return most


@kernel
def pair_up_some(
    run: int, some: Stretch | None, squared_reach: float, grid: Grid, sorting: Sorting, lists: Neighbours
) -> int:
    """Fill the lists of some robots of a sorted run; return the most neighbours that any of them has."""
    (first, last), most = ends_of(some, lists.near.shape[1]), 0
    for robot in range(first, last):
        found = _look_around(run, robot, squared_reach, grid, sorting, lists)
        lists.near[run, robot] = min(found, lists.who.shape[2])
        most = max(most, found)
    return most


@kernel
def _cell_along(coordinate: float, axis: int, grid: Grid) -> int:
    """Number of the cell along one axis; the outermost for a robot beyond, the first for one that is nowhere."""
    place = (coordinate - grid.lower[axis]) * grid.per_metre[axis]
    return int(min(max(place, 0.0), grid.size[axis] - 1.0)) if math.isfinite(place) else 0


@kernel
def sort_into_cells(state: Floats, run: int, grid: Grid, sorting: Sorting) -> None:
    """Counting sort: `order[start[c] : start[c + 1]]` are the robots of cell c, ascending; `place` is in that order."""
    cell, start, order, place = sorting
    for index in range(start.shape[0]):
        start[index] = 0
    for robot in range(cell.shape[0]):
        number = 0
        for axis in range(3):
            number = number * grid.size[axis] + _cell_along(state[run, robot, X + axis], axis, grid)
        cell[robot] = number
        start[number + 1] += 1
    for index in range(1, start.shape[0]):
        start[index] += start[index - 1]
    for robot in range(cell.shape[0] - 1, -1, -1):
        # Filled from behind, the start of the next cell becomes the start of this one.
        start[cell[robot] + 1] -= 1
        rank = start[cell[robot] + 1]
        order[rank] = robot
        for axis in range(3):
            place[rank, axis] = state[run, robot, X + axis]
    for index in range(start.shape[0] - 1):
        start[index] = start[index + 1]
    start[start.shape[0] - 1] = cell.shape[0]


@kernel
def _look_around(
    run: int,
    robot: int,
    squared_reach: float,
    grid: Grid,
    sorting: Sorting,
    lists: Neighbours,
) -> int:
    """Fill the list of one robot from its own and the touching cells; return how many belong in it."""
    cell, start, order, place = sorting
    high, middle = grid.size[2], grid.size[1]
    i, j, k = cell[robot] // (high * middle), cell[robot] // high % middle, cell[robot] % high
    capacity, found = lists.who.shape[2], 0
    mine = _own_rank(robot, cell, start, order)
    x, y, z = place[mine, 0], place[mine, 1], place[mine, 2]
    for row in range(max(i - 1, 0), min(i + 2, grid.size[0])):
        for column in range(max(j - 1, 0), min(j + 2, middle)):
            base = (row * middle + column) * high
            # Cells one above the other lie side by side in the order: one stretch for all three.
            for rank in range(start[base + max(k - 1, 0)], start[base + min(k + 2, high)]):
                east, north, up = place[rank, 0] - x, place[rank, 1] - y, place[rank, 2] - z
                if rank == mine or not east * east + north * north + up * up <= squared_reach:
                    continue
                if found < capacity:
                    _insert(lists.who, run, robot, found, order[rank])
                found += 1
    return found


@kernel
def _own_rank(robot: int, cell: Integers, start: Integers, order: Integers) -> int:
    """Where the robot stands in the order."""
    rank = int(start[cell[robot]])
    while order[rank] != robot:
        rank += 1
    return rank


@kernel
def _insert(index: NDArray[np.int32], run: int, robot: int, count: int, other: int) -> None:
    """Put `other` into its place among the ascending first `count` numbers of a robot's list."""
    place = count
    while place > 0 and index[run, robot, place - 1] > other:
        index[run, robot, place] = index[run, robot, place - 1]
        place -= 1
    index[run, robot, place] = other
