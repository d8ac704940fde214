"""Attitudes of a log before they are believed: four numbers are one only if their squares sum to 1."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from cocorosim_ros.foundation.arrays import Flags, Floats
from cocorosim_ros.scenario.reading.entry import Entry
from cocorosim_ros.wire.conversion.rows import Rows

QUATERNION = ("qx", "qy", "qz", "qw")
FURTHEST_FROM_ONE = 0.01
"""Distance of a quaternion's norm from 1; chosen: two decimals err by less, degrees or another column by far more."""


def unset(columns: Mapping[str, Floats]) -> Flags:
    """(n,) where all four numbers of a quaternion are zero, which many programs send before they know it."""
    return np.asarray((np.array([columns[name] for name in QUATERNION]) == 0).all(axis=0))


def check_normalised(columns: Mapping[str, Floats], usable: Flags, rows: Rows, place: Entry) -> None:
    """Nothing, if the usable attitudes have a norm near 1. Raises CocorosimError naming the first other row."""
    norm = np.sqrt(sum(columns[name] ** 2 for name in QUATERNION))
    wrong = usable & ~(np.abs(norm - 1.0) <= FURTHEST_FROM_ONE)
    if wrong.any():
        row = int(np.argmax(wrong))
        others = np.count_nonzero(wrong) - 1
        more = f" and {others} more" if others else ""
        raise place.problem(
            f"has an attitude that is not normalised in {rows.origin} {rows.row_name(row)}{more} (norm "
            f"{norm[row]:.6g}); check which columns qx, qy, qz and qw are, or divide by the norm with 'formula'."
        )
