"""Blocks of the filter that noises act on: two noises of different blocks show in one pass.

The filter takes its horizontal and its vertical block as independent of each other (`filter.filter`), so that a noise
of one block changes innovations of the other through the mean alone: next to nothing beside what it changes in its own.
"""

from __future__ import annotations

from collections.abc import Sequence

from cocorosim_ros.diagnosis.filter.layout import KIND_NAMES, UPRIGHT
from cocorosim_ros.diagnosis.tracks.columns import READING_NOISE_OF_KIND

_OF_UPRIGHT = frozenset(READING_NOISE_OF_KIND[code] for code in UPRIGHT)
_OF_LEVEL = frozenset(READING_NOISE_OF_KIND[code] for code in range(len(KIND_NAMES)) if code not in UPRIGHT)


def _columns(readings: frozenset[str]) -> frozenset[str]:
    return frozenset(f"{place}.{name}" for place in ("reading", "memory") for name in readings)


UPRIGHT_NOISE = _columns(_OF_UPRIGHT - _OF_LEVEL) | {"random.heave_force"}
"""Columns of noise of the vertical block alone."""
LEVEL_NOISE = _columns(_OF_LEVEL - _OF_UPRIGHT) | {"random.force", "random.moment"}
"""Columns of noise of the horizontal block alone."""


def in_passes(columns: Sequence[str]) -> list[tuple[int, ...]]:
    """Places of noise columns that one pass shows: a level one and an upright one, in that order, or one alone."""
    level = [place for place, column in enumerate(columns) if column in LEVEL_NOISE]
    upright = [place for place, column in enumerate(columns) if column in UPRIGHT_NOISE]
    pairs = list(zip(level, upright, strict=False))
    paired = {place for pair in pairs for place in pair}
    return [*pairs, *((place,) for place in range(len(columns)) if place not in paired)]
