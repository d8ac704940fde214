"""How Rerun shows scenes when it opens them: the tank large, metrics below, a robot to follow, words."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import rerun.blueprint as rrb

from cocorosim_ros.study.metrics import METRICS, PAPER_METRICS
from cocorosim_ros.study.pictures.extent import extent
from cocorosim_ros.study.scene.rerun_robots import TIMELINE
from cocorosim_ros.study.scene.scene import Scene
from cocorosim_ros.wire.cdr.primitives import NANOSECONDS

TRAIL = 30.0
"""How much of its way a robot's trail shows [s]."""
_BACKGROUND = (16, 24, 34)
_EYE = np.array([-0.22, -0.5, 0.32])  # from the middle of the swarm, as multiples of the scene's largest side
_WATCHED_IN = 60.0  # s that playing takes at first, of a recording that is longer


def layout(roots: Sequence[str], scenes: Sequence[Scene], *, live: bool = False) -> rrb.Blueprint:
    """One scene, or two side by side, each below its root; every metric of all of them in one plot.

    live: whether the time follows what comes, instead of being played.
    """
    tanks = rrb.Horizontal(*(_tank_view(root, scene) for root, scene in zip(roots, scenes, strict=True)))
    seconds = max(_seconds(scene) for scene in scenes)
    plots = [_plot(name, roots, seconds) for name in PAPER_METRICS]
    words = rrb.Tabs(*(rrb.TextDocumentView(origin=f"{root}/about", name=f"about {root}") for root in roots))
    right = rrb.Vertical(_follow_view(roots[0], scenes[0]), words, row_shares=[3, 2])
    metrics = rrb.Grid(*plots, grid_columns=3)
    if len(scenes) > 1:
        shown = rrb.Vertical(tanks, metrics, row_shares=[3, 2])
    else:
        shown = rrb.Vertical(rrb.Horizontal(tanks, right, column_shares=[5, 2]), metrics, row_shares=[3, 2])
    return rrb.Blueprint(
        shown,
        rrb.BlueprintPanel(state="collapsed"),
        rrb.SelectionPanel(state="collapsed"),
        rrb.TimePanel(
            state="collapsed",
            timeline=TIMELINE,
            play_state="following" if live else "playing",
            loop_mode="off" if live else "all",
            playback_speed=1.0 if live else max(1.0, round(seconds / _WATCHED_IN)),
        ),
    )


def _tank_view(root: str, scene: Scene) -> rrb.Spatial3DView:
    view = extent({robot.name: robot.track for robot in scene.robots}, scene.facts)
    middle = np.mean([robot.track.position[0] for robot in scene.robots], axis=0)
    side = float(np.max(view.high - view.low))
    eye = rrb.EyeControls3D(kind="orbital", position=middle + side * _EYE, look_target=middle, eye_up=(0.0, 0.0, 1.0))
    return _scene_view(root, scene, f"{root}: {scene.facts.name}", eye, hidden=("cones", "sight"))


def _follow_view(root: str, scene: Scene) -> rrb.Spatial3DView:
    """The first robot in the middle all the time; another is chosen by a double click on it."""
    robot = scene.robots[0]
    first = robot.track.position[0]
    eye = rrb.EyeControls3D(
        kind="orbital",
        position=first + np.array([-0.9, -0.6, 0.6]),
        look_target=first,
        eye_up=(0.0, 0.0, 1.0),
        tracking_entity=f"/{root}/robots/{robot.name}",
    )
    return _scene_view(root, scene, f"following {robot.name}", eye, hidden=("cones",))


def _scene_view(root: str, scene: Scene, name: str, eye: rrb.EyeControls3D, hidden: Sequence[str]) -> rrb.Spatial3DView:
    """A view of everything but those parts of the robots that are hidden at first."""
    trail = rrb.VisibleTimeRanges(
        timeline=TIMELINE,
        start=rrb.TimeRangeBoundary.cursor_relative(seconds=-TRAIL),
        end=rrb.TimeRangeBoundary.cursor_relative(),
    )
    unseen = rrb.EntityBehavior(visible=False)
    overrides = {f"{root}/robots/{robot.name}/{part}": unseen for robot in scene.robots for part in hidden}
    trails = {f"{root}/trails/{robot.name}": trail for robot in scene.robots}
    return rrb.Spatial3DView(
        origin=root,
        name=name,
        background=_BACKGROUND,
        line_grid=False,
        eye_controls=eye,
        overrides={**overrides, **trails},
    )


def _plot(metric: str, roots: Sequence[str], seconds: float) -> rrb.TimeSeriesView:
    """A metric of all scenes, from the first to the last moment."""
    unit = METRICS[metric].unit
    title = metric.replace("_", " ") + ("" if unit == "1" else f" [{unit}]")
    ends = rrb.TimeRangeBoundary.absolute(seconds=0.0), rrb.TimeRangeBoundary.absolute(seconds=seconds)
    return rrb.TimeSeriesView(
        origin="/",
        contents=[f"/{root}/metrics/{metric}" for root in roots],
        name=title,
        axis_x=rrb.TimeAxis(view_range=rrb.TimeRange(*ends)),
        plot_legend=rrb.PlotLegend(rrb.Corner2D.RightTop, visible=len(roots) > 1),
    )


def _seconds(scene: Scene) -> float:
    return float(max(robot.track.stamp_ns[-1] for robot in scene.robots) - scene.start_ns) / NANOSECONDS
