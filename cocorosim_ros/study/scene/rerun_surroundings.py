"""Everything of a scene but its robots as entities of Rerun: tank, obstacles, water, who hears whom, metrics."""

from __future__ import annotations

import numpy as np
import rerun as rr

from cocorosim_ros.study.metrics import COLUMN, PAPER_METRICS
from cocorosim_ros.study.pictures.facts import ScenarioFacts
from cocorosim_ros.study.scene.rerun_robots import Canvas, Colour
from cocorosim_ros.study.scene.scene import DriftingPlume, MovingWater, Scene

_WALL, _SOLID, _WATER, _RADIO, _PLUME = (110, 150, 175), (120, 125, 130), (60, 140, 200), (90, 220, 190), (200, 90, 220)
_SOURCE, _PUFF = rr.Radius.ui_points(7.0), rr.Radius.ui_points(3.5)  # seen in tanks of every size
_FAINTEST = 0.5  # of the colour of a new puff; darker ones would be lost in the water
_SURFACE = (70, 140, 190, 40)
_SECONDS_SHOWN = 10.0
"""An arrow of the water is as long as the way that the water goes in this time [s]."""


def draw_surroundings(canvas: Canvas, scene: Scene, curve: Colour) -> None:
    """Tank, obstacles, water, radio, metrics, and in words what it is; `curve`: colour of the metrics' lines."""
    _draw_tank(canvas, scene.facts)
    _draw_water(canvas, scene)
    _draw_hearing(canvas, scene)
    _draw_metrics(canvas, scene, curve)
    canvas.always("about", rr.TextDocument(_words(scene), media_type=rr.MediaType.MARKDOWN))


def _draw_tank(canvas: Canvas, facts: ScenarioFacts) -> None:
    if facts.low_corner is not None and facts.high_corner is not None:
        low, high = np.array(facts.low_corner), np.array(facts.high_corner)
        walls = rr.Boxes3D(centers=[(low + high) / 2], half_sizes=[(high - low) / 2], colors=[_WALL], radii=0.006)
        canvas.always("tank/walls", walls)
        surface = np.array([[low[0], low[1]], [high[0], low[1]], [high[0], high[1]], [low[0], high[1]]])
        corners = np.column_stack([surface, np.full(4, high[2])])
        canvas.always(
            "tank/surface",
            rr.Mesh3D(vertex_positions=corners, triangle_indices=[(0, 1, 2), (0, 2, 3)], albedo_factor=_SURFACE),
        )
    if facts.spheres:
        balls = np.array(facts.spheres)
        shape = rr.Ellipsoids3D(centers=balls[:, :3], radii=balls[:, 3], colors=[_SOLID], fill_mode="solid")
        canvas.always("tank/spheres", shape)
    if facts.boxes:
        boxes = np.array(facts.boxes).reshape(-1, 2, 3)
        middle, half = boxes.mean(axis=1), (boxes[:, 1] - boxes[:, 0]) / 2
        canvas.always("tank/boxes", rr.Boxes3D(centers=middle, half_sizes=half, colors=[_SOLID], fill_mode="solid"))


def _draw_water(canvas: Canvas, scene: Scene) -> None:
    plume, water = scene.plume, scene.water
    if plume is not None:
        canvas.always("water/plume_source", rr.Points3D([plume.source], radii=[_SOURCE], colors=[_PLUME]))
        canvas.always("water/plume", rr.Points3D.from_fields(radii=[_PUFF]))
        draw_puffs(canvas, plume)
    if water is not None:
        canvas.always("water/current", rr.Arrows3D.from_fields(origins=water.place, colors=[_WATER], radii=[0.008]))
        draw_current(canvas, water)


def draw_current(canvas: Canvas, water: MovingWater) -> None:
    """Where the water goes, at each of the moments."""
    vectors = _SECONDS_SHOWN * water.velocity.reshape(-1, 3)
    columns = rr.Arrows3D.columns(vectors=vectors).partition([len(water.place)] * water.stamp_ns.size)
    canvas.over_time("water/current", water.stamp_ns, columns)


def draw_puffs(canvas: Canvas, plume: DriftingPlume) -> None:
    """A point for each puff, which fades as it spreads, at each of the moments."""
    if not plume.stamp_ns.size:
        return
    shade = np.maximum(plume.narrowness, _FAINTEST)[:, None] * np.array(_PLUME)
    columns = rr.Points3D.columns(positions=plume.centre, colors=shade.astype(np.uint8)).partition(plume.count)
    canvas.over_time("water/plume", plume.stamp_ns, columns)


def _draw_hearing(canvas: Canvas, scene: Scene) -> None:
    """A line from each sender to each robot that hears it, until the next delivery."""
    heard = scene.hearing
    canvas.always("hearing", rr.LineStrips3D.from_fields(colors=[_RADIO], radii=[0.0015]))
    canvas.over_time("hearing", heard.stamp_ns, rr.LineStrips3D.columns(strips=heard.links).partition(heard.count))


def _draw_metrics(canvas: Canvas, scene: Scene, curve: Colour) -> None:
    for name in PAPER_METRICS:
        values = scene.metrics.values[:, COLUMN[name]]
        known = np.isfinite(values)
        path = f"metrics/{name}"
        canvas.always(path, rr.SeriesLines(names=[canvas.root], colors=[curve], widths=[1.5]))
        canvas.over_time(path, scene.metrics.stamp_ns[known], rr.Scalars.columns(scalars=values[known]))


def _words(scene: Scene) -> str:
    facts = scene.facts
    lines = [f"# {facts.name}", f"{len(scene.robots)} robots" + ("" if facts.seed is None else f", seed {facts.seed}")]
    lines += [
        "Bodies have the colour of their shoal, trails that of their robot. White arrow: bow. Orange: what is asked of "
        "thrusters and pump, one hull long at full command. Yellow cones (`sight`) see a robot at the distance of "
        "their rim; they are hidden where they are too many, and so is their full reach (`cones`). Green lines: who "
        f"hears whom. Blue arrows: where the water goes in {_SECONDS_SHOWN:g} s."
    ]
    if scene.plume is not None:
        lines.append(
            "Purple: a leak, and the puffs that come from it; the water carries them, and they fade as they spread."
        )
    if any(robot.platform is None for robot in scene.robots):
        lines.append("The recording does not tell how large its robots are; they are drawn as large as a Lily.")
    return "\n\n".join([*lines, *(f"- {finding}" for finding in scene.findings)]) + "\n"
