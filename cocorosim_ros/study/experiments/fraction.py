"""A fraction of all settings of many two-level factors, in which main effects stand clear of interactions of two.

The columns of a Hadamard matrix are orthogonal: as many settings as the matrix has rows tell as many main effects, but
mix each with interactions of two factors (resolution III). With every setting the one that is its opposite in all
factors is run too (foldover): an interaction of two factors has the same sign in both, a main effect has opposite ones,
so that they no longer mix (resolution IV). Interactions of two stay mixed with each other.
Source: Box, Hunter & Hunter 2005, Statistics for Experimenters, chapters 6 and 7; Plackett & Burman 1946, Biometrika
33:305-325.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import hadamard

from cocorosim_ros.foundation.arrays import Floats

Setting = tuple[bool, ...]
"""One level for each factor: whether it is the upper one."""


def folded_settings(factors: int) -> list[Setting]:
    """The settings of a fraction of resolution IV; the first has every factor at its lower level."""
    return [tuple(bool(sign < 0) for sign in row) for row in _folded(factors)]


def contrasts(factors: int) -> tuple[Floats, Floats]:
    """What weighs the settings' responses: (factors, settings) for main effects, the others for all that is left.

    Each weighs them to the mean at the upper level less that at the lower one. Those that are left (n, settings) are
    sums of interactions, most of two factors, and of noise.
    """
    mains = -_folded(factors).T
    half = hadamard(_size(factors))
    left = np.vstack([np.tile(half[1:], 2), np.hstack([half[factors:], -half[factors:]])])
    return mains / (mains.shape[1] / 2), left / (left.shape[1] / 2)


def _size(factors: int) -> int:
    return 1 << (factors - 1).bit_length()


def _folded(factors: int) -> NDArray[np.int64]:
    """Signs (settings, factors), 1 for the lower level."""
    half = hadamard(_size(factors))[:, :factors].astype(np.int64)
    return np.vstack([half, -half])
