"""Tracks seen from above and from the side.

Whole tracks are thin and pale; their last part is strong, so that a long run is not a ball of wool. A ring
marks where a robot started, a disc where it ended; from above an arrow shows its final heading.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Rectangle

from cocorosim_ros.study.pictures.colours import robot_colours
from cocorosim_ros.study.pictures.decimation import every_nth, with_breaks
from cocorosim_ros.study.pictures.extent import Extent
from cocorosim_ros.study.pictures.facts import ScenarioFacts
from cocorosim_ros.world.state.pose_track import Poses
from cocorosim_ros.world.state.state import X, Y, Z

MOST_POSES = 4000
"""Poses per robot beyond which only every n-th is drawn."""

_WATER, _WALL = "#eaf3f8", "#33566b"
_ARROW_SHARE = 0.055


class _Plane(NamedTuple):
    """Axes of the world that are drawn across and up."""

    across: int
    up: int


_FROM_ABOVE, _FROM_THE_SIDE = _Plane(X, Y), _Plane(X, Z)


def draw_from_above(
    axes: Axes, tracks: Mapping[str, Poses], facts: ScenarioFacts, view: Extent, strong_from_ns: int
) -> None:
    """The x-y plane: walls, tracks, starts, ends and final headings."""
    _prepare(axes, _FROM_ABOVE, facts, view)
    colours = robot_colours(list(tracks))
    arrow = _ARROW_SHARE * float(view.high[X] - view.low[X])
    for name, track in tracks.items():
        _draw_track(axes, track, _FROM_ABOVE, colours[name], strong_from_ns)
        position, yaw = track.at(np.array([track.stamp_ns.size - 1]))
        x, y = position[0, 0], position[0, 1]
        tip = (x + arrow * np.cos(yaw[0]), y + arrow * np.sin(yaw[0]))
        style = {
            "arrowstyle": "-|>,head_length=0.45,head_width=0.22",
            "color": colours[name],
            "linewidth": 1.5,
        }
        axes.annotate("", xy=tip, xytext=(x, y), arrowprops=style | {"shrinkA": 0, "shrinkB": 0}, zorder=6)
    axes.set_ylabel("y north [m]")
    axes.set_title("From above", loc="left", fontweight="bold")


def draw_from_the_side(
    axes: Axes, tracks: Mapping[str, Poses], facts: ScenarioFacts, view: Extent, strong_from_ns: int
) -> None:
    """The x-z plane: surface, floor, tracks, starts and ends."""
    _prepare(axes, _FROM_THE_SIDE, facts, view)
    colours = robot_colours(list(tracks))
    for name, track in tracks.items():
        _draw_track(axes, track, _FROM_THE_SIDE, colours[name], strong_from_ns)
    if facts.low_corner is not None and facts.high_corner is not None:
        label: Any = {"textcoords": "offset points", "color": _WALL, "fontsize": 9, "zorder": 7}
        corner = (facts.low_corner[0], facts.high_corner[2])
        axes.annotate("surface", corner, (7, -5), va="top", **label)
        axes.annotate("floor", (corner[0], facts.low_corner[2]), (7, 5), **label)
    axes.set_xlabel("x east [m]")
    axes.set_ylabel("z up [m]")
    axes.set_title("From the side", loc="left", fontweight="bold")


def _prepare(axes: Axes, plane: _Plane, facts: ScenarioFacts, view: Extent) -> None:
    across, up = plane
    axes.set_aspect("equal", adjustable="box", anchor="W")
    for spine in axes.spines.values():
        spine.set_visible(facts.low_corner is None)
    axes.set_xlim(view.low[across], view.high[across])
    axes.set_ylim(view.low[up], view.high[up])
    axes.grid(color="white", linewidth=0.8)
    axes.set_axisbelow(True)
    if facts.low_corner is None or facts.high_corner is None:
        axes.set_facecolor(_WATER)
        return
    corner = (facts.low_corner[across], facts.low_corner[up])
    width, height = facts.high_corner[across] - corner[0], facts.high_corner[up] - corner[1]
    axes.add_patch(Rectangle(corner, width, height, facecolor=_WATER, edgecolor="none", zorder=0))
    axes.add_patch(Rectangle(corner, width, height, facecolor="none", edgecolor=_WALL, linewidth=2, zorder=2))


def _draw_track(
    axes: Axes,
    track: Poses,
    plane: _Plane,
    colour: tuple[float, float, float, float],
    strong_from_ns: int,
) -> None:
    kept, _ = every_nth(track.stamp_ns, MOST_POSES)
    across, up = with_breaks(track.stamp_ns[kept], track.at(kept)[0][:, plane]).T
    axes.plot(across, up, color=colour, linewidth=0.7, alpha=0.3, zorder=3)
    late = np.flatnonzero(track.stamp_ns >= strong_from_ns)
    if late.size > 1:
        across, up = with_breaks(track.stamp_ns[late], track.at(late)[0][:, plane]).T
        axes.plot(across, up, color=colour, linewidth=1.8, alpha=0.95, zorder=4, solid_capstyle="round")
    first, last = track.at(np.array([0, track.stamp_ns.size - 1]))[0][:, plane]
    axes.plot(*first, marker="o", markersize=5.5, markerfacecolor="white", markeredgecolor=colour, zorder=5)
    axes.plot(*last, marker="o", markersize=6, color=colour, markeredgecolor="black", zorder=7)
