"""The colour of each robot, the same on every picture and page; apart from drawing, of which pages need no more."""

from __future__ import annotations

import matplotlib

_TEN_COLOURS = 10


def robot_colours(names: list[str]) -> dict[str, tuple[float, float, float, float]]:
    """One colour per robot: ten that differ strongly, or as many as needed along a rainbow."""
    if len(names) <= _TEN_COLOURS:
        palette = matplotlib.colormaps["tab10"]
        return {name: palette(number) for number, name in enumerate(names)}
    rainbow = matplotlib.colormaps["turbo"]
    return {name: rainbow(0.04 + 0.92 * number / (len(names) - 1)) for number, name in enumerate(names)}
