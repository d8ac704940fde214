"""Tracks from above as a small drawing of text (SVG), as a notebook shows it; loads no plots."""

from __future__ import annotations

from collections.abc import Mapping
from html import escape

import numpy as np

from cocorosim_ros.foundation.arrays import Floats

WIDTH, HIGHEST = 360.0, 360.0  # px
_MARGIN = 12.0  # px
_MOST_POINTS = 400  # of a track
_SMALLEST = 0.1  # m; a robot that stands still is no speck blown up


def tracks_sketch(places: Mapping[str, Floats]) -> str:
    """Ways of robots (n, 2 or more) [m; world], x to the right and y up, a disc at each end; "" without any place."""
    known = {name: way[np.isfinite(way[:, :2]).all(axis=1), :2] for name, way in places.items()}
    known = {name: way for name, way in known.items() if len(way)}
    if not known:
        return ""
    everything = np.concatenate(list(known.values()))
    low, high = everything.min(axis=0), everything.max(axis=0)
    size = np.maximum(high - low, _SMALLEST)
    scale = float(min((WIDTH - 2 * _MARGIN) / size[0], (HIGHEST - 2 * _MARGIN) / size[1]))
    height = scale * float(size[1]) + 2 * _MARGIN
    parts = [
        _way(name, (way - low) * scale * (1, -1) + (_MARGIN, height - _MARGIN), 360.0 * number / len(known))
        for number, (name, way) in enumerate(known.items())
    ]
    words = f"ways from above, {size[0]:.3g} m by {size[1]:.3g} m, a disc at each end"
    return (
        f'<svg viewBox="0 0 {WIDTH:.0f} {height:.0f}" width="{WIDTH:.0f}" role="img" aria-label="{words}">'
        f"{''.join(parts)}</svg><div>{words}</div>"
    )


def _way(name: str, points: Floats, hue: float) -> str:
    """A line through points (n, 2) [px], and where it ends."""
    drawn = points[np.unique(np.linspace(0, len(points) - 1, min(len(points), _MOST_POINTS)).astype(int))]
    line = " ".join(f"{x:.1f},{y:.1f}" for x, y in drawn.tolist())
    colour = f"hsl({hue:.0f} 65% 45%)"
    x, y = drawn[-1].tolist()
    return (
        f'<g><title>{escape(name)}</title><polyline points="{line}" fill="none" stroke="{colour}"/>'
        f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3.5" fill="{colour}"/></g>'
    )
