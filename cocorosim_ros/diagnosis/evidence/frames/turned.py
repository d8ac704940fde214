"""Quarter turns and mirror images of horizontal axes, as matrices and in words."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from cocorosim_ros.diagnosis.evidence.frames.expected import Complex
from cocorosim_ros.foundation.arrays import Floats


class Turned(NamedTuple):
    """A change of horizontal axes: v becomes i^quarters v, or i^quarters conj(v) where mirrored, for v = x + iy."""

    mirrored: int  # 0 or 1
    quarters: int  # 0 to 3


SAME = Turned(0, 0)
SWAPPED = Turned(1, 1)  # x and y exchanged; an angle counted clockwise from north
ALL_TURNED = tuple(Turned(mirrored, quarters) for mirrored in (0, 1) for quarters in range(4))

_POSITION = {
    Turned(0, 1): "the horizontal axes are turned by 90 degrees: x = -y, y = x",
    Turned(0, 2): "the signs of x and y are flipped",
    Turned(0, 3): "the horizontal axes are turned by 90 degrees: x = y, y = -x",
    Turned(1, 0): "the sign of y is flipped",
    Turned(1, 1): "x and y are swapped",
    Turned(1, 2): "the sign of x is flipped",
    Turned(1, 3): "x and y are swapped and their signs flipped",
}
_ANGLE = {
    Turned(0, 1): "90 degrees have to be added to it",
    Turned(0, 2): "it is off by 180 degrees",
    Turned(0, 3): "90 degrees have to be taken from it",
    Turned(1, 0): "its sign is flipped (clockwise positive)",
    SWAPPED: "it counts clockwise from north (+y) instead of counter-clockwise from east: pi/2 minus the reading is "
    "right",
    Turned(1, 2): "it counts clockwise from west: pi minus the reading is right",
    Turned(1, 3): "it counts clockwise from south: -pi/2 minus the reading is right",
}


def turned_by(turned: Turned, axes: Complex) -> Complex:
    """Turn or mirror horizontal vectors x + iy (n,)."""
    return np.asarray(1j**turned.quarters * (np.conj(axes) if turned.mirrored else axes))


def matrix_of(turned: Turned) -> Floats:
    """Matrix (2, 2) on x, y of a turn or mirror image."""
    columns = turned_by(turned, np.array([1.0 + 0.0j, 1.0j]))
    return np.array([columns.real, columns.imag]).round()


def on_angle(turned: Turned) -> tuple[float, float]:
    """Factor and summand [rad] by which a turn or mirror image changes an angle."""
    summand = (turned.quarters if turned.quarters <= 2 else -1) * np.pi / 2.0
    return (-1.0 if turned.mirrored else 1.0), summand


def position_words(turned: Turned) -> str:
    """Words for the fault of positions that this turn corrects."""
    return _POSITION[turned]


def angle_words(turned: Turned) -> str:
    """Words for the fault of an angle that this turn corrects."""
    return _ANGLE[turned]
