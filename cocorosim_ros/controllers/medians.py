"""Medians of vectors, coordinate by coordinate: exact, and without branches on the values.

What a robot hears is in no order, so that a processor would guess half of the branches of a common sort wrong.
Here a new row walks past all that are there already and each time the larger number of both walks on; the three
coordinates go side by side.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from cocorosim_ros.compilation import kernel, stack_array
from cocorosim_ros.signals.radio import HEARING_LIMIT

Floats = NDArray[np.float64]
LANES = 4  # coordinates side by side; three are used
ROOM = LANES * HEARING_LIMIT  # numbers in a list of sorted columns


@kernel
def insert_row(columns: Floats, count: int, row: Floats) -> None:
    """Put the numbers of `row` (at least LANES,) into the ascending columns of `columns[:count]` (n, LANES)."""
    carried = stack_array(LANES)
    for lane in range(LANES):
        carried[lane] = row[lane]
    for place in range(count):
        for lane in range(LANES):
            here, new = columns[place, lane], carried[lane]
            smaller = new < here
            columns[place, lane] = new if smaller else here
            carried[lane] = here if smaller else new
    for lane in range(LANES):
        columns[count, lane] = carried[lane]


@kernel
def middle_row(columns: Floats, count: int, median: Floats) -> None:
    """Write the medians of the ascending `columns[:count]` (n, LANES) into `median` (3,); of none, it stays."""
    if count == 0:
        return
    for axis in range(3):
        median[axis] = 0.5 * (columns[(count - 1) // 2, axis] + columns[count // 2, axis])


@kernel
def coordinate_median(rows: Floats, count: int, median: Floats) -> None:
    """Write the coordinate-wise median of the first `count` of `rows` (n, LANES) into `median` (3,).

    n is at most HEARING_LIMIT; `median` stays where there is no row.
    """
    columns = stack_array(ROOM).reshape(HEARING_LIMIT, LANES)
    for index in range(count):
        insert_row(columns, index, rows[index])
    middle_row(columns, count, median)
