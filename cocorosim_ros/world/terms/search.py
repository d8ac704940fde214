"""How an effect is looked for in recordings: what they span, and what its slopes are sums of."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import NamedTuple


class Scene(NamedTuple):
    """What the recordings span: lowest and highest x, y, z [m; world] and the duration [s].

    periods: at which the random force that the model needs swings most, by equation [s]. changes: moments at which
    that of heave steps most [s]. scales: typical sizes of the
    regressors of laws, of the forces by equation, and the mass [kg]. driven: whether thrusters moved the robots more
    than the water did at random.
    """

    lower: tuple[float, float, float]
    upper: tuple[float, float, float]
    duration: float
    hull: float  # length of the hull [m]
    arm: float  # how far the thrusters sit before the centre [m]
    periods: Mapping[str, tuple[float, ...]]
    changes: tuple[float, ...]
    scales: Mapping[str, float]
    driven: bool


Basis = Callable[[Mapping[str, float]], list[tuple[dict[str, float], float]]]
"""Function of the shapes by column: other shapes and the weight of the slope there."""
