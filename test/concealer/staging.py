"""Robots, water and programmes of commands: a scene with everything hidden that a plot wants, and how it moves."""

from __future__ import annotations

from typing import Any

import numpy as np

from concealer import layout as at
from concealer import water
from concealer.catalogue_sensors import CATALOGUE
from concealer.layout import FloatArray
from concealer.manoeuvres import MANOEUVRES, Pool
from concealer.outside import OUTSIDE
from concealer.physics import drive
from concealer.prior import Plot, entries
from concealer.scene import Faults, Scene, Secret

SURFACING = frozenset(("hull_emergence", "surface_loss"))
"""What acts near the surface alone: a programme comes up for it, which others need not."""

SPREAD = (at.MASS, at.INERTIA, at.DRAG, at.YAW_DRAG, at.THRUST, at.LEVER, at.PUMP)


def vehicle(rng: np.random.Generator, numbers: dict[str, Any], kind: str) -> FloatArray:
    """(SIZE,) a robot off nominal: a little everywhere, or by much in a few places, or not at all."""
    p = at.nominal_robot()
    width = float(rng.uniform(*numbers["spread"]))
    factors = 1.0 + rng.uniform(-width, width, len(SPREAD))
    exact = rng.random() < numbers["exact_when_nothing"]
    far = rng.choice([-1.0, 1.0], len(SPREAD)) * rng.uniform(*numbers["recalibration_spread"], size=len(SPREAD))
    chosen = rng.permutation(len(SPREAD))[: rng.integers(2, 5)]
    if kind == "nothing" and exact:
        factors[:] = 1.0
    if kind == "recalibration":
        factors[chosen] = 1.0 + far[chosen]
    p[list(SPREAD)] *= factors
    return p


def empty(rng: np.random.Generator, numbers: dict[str, Any], plot: Plot) -> Scene:
    """Robots and water with nothing hidden."""
    robots = np.array([vehicle(rng, numbers["vehicle"], plot.kind) for _ in range(plot.robots)])
    scene = Scene(robots, [Faults() for _ in robots], int(rng.integers(plot.robots)))
    along_x, along_y, down = plot.arena
    scene.everywhere(half_x=0.5 * plot.side * along_x, half_y=0.5 * plot.side * along_y)
    scene.everywhere(floor=-numbers["tank"]["depth"] * down, duration=plot.duration)
    return scene


def hide(rng: np.random.Generator, numbers: dict[str, Any], name: str, share: float, scene: Scene) -> Secret:
    """Hides an entry of the prior, of this size as a fraction of large."""
    large = entries(numbers)[name]["large"]
    return (CATALOGUE.get(name) or OUTSIDE[name])(rng, share * large, scene)


def stage(rng: np.random.Generator, numbers: dict[str, Any], plot: Plot) -> tuple[Scene, list[Secret]]:
    """Robots and water with everything hidden that the plot wants."""
    scene = empty(rng, numbers, plot)
    secrets = [hide(rng, numbers, name, share, scene) for name, share in plot.hidden.items()]
    if plot.kind == "cannot_tell":
        without_ramp(scene)
    return scene, secrets


def without_ramp(scene: Scene) -> None:
    """Behind a dead zone without a jump every level of thrust is a little lower, which any recording shows."""
    scene.own[at.DEAD_JUMP] = max(scene.own[at.DEAD_JUMP], scene.own[at.DEAD_CONTINUOUS])
    scene.own[at.DEAD_CONTINUOUS] = 0.0


def start(rng: np.random.Generator, plot: Plot, depth: float) -> FloatArray:
    """(robots, STATE) at rest around the middle of the tank."""
    s = np.zeros((plot.robots, at.STATE))
    s[:, at.X], s[:, at.Y] = 0.3 * plot.side * rng.uniform(-1.0, 1.0, (2, plot.robots))
    s[:, at.X], s[:, at.Y] = plot.arena[0] * s[:, at.X], plot.arena[1] * s[:, at.Y]
    s[:, at.Z] = -0.5 * depth + rng.uniform(-0.2, 0.2, plot.robots)
    s[:, at.YAW] = rng.uniform(-np.pi, np.pi, plot.robots)
    return s


def forces(rng: np.random.Generator, plot: Plot, ticks: int) -> FloatArray:
    """Knots (2 ticks + 2, robots, 4) of the water's random forces."""
    knots = water.matern(rng, (2 * ticks + 2, 4 * plot.robots), 0.5 * at.TICK, plot.correlation)
    scale = plot.noise * np.array([at.FULL_THRUST, at.FULL_THRUST, at.FULL_THRUST, at.FULL_TORQUE])
    return knots.reshape(-1, plot.robots, 4) * scale


def move(rng: np.random.Generator, plot: Plot, scene: Scene) -> tuple[FloatArray, FloatArray]:
    """Trajectory (rows, robots, ROW) and commands (ticks, robots, 3)."""
    ticks, depth = round(plot.duration / at.TICK), -float(scene.own[at.FLOOR])
    surfacing = not SURFACING.isdisjoint(plot.hidden)
    margin = 0.25 if surfacing or "wall_effect" in plot.hidden else 0.5
    deepest = min(at.TALL, depth) if surfacing else depth
    pool = Pool(0.5 * plot.side, deepest, plot.duration, margin, "neighbour_wake" in plot.hidden, plot.style)
    plans = [MANOEUVRES[plot.manoeuvre](rng, pool) for _ in range(plot.robots)]
    padded = np.zeros((plot.robots, max(map(len, plans)), plans[0].shape[1]))
    for row, plan in zip(padded, plans, strict=True):
        row[: len(plan)] = plan
        row[len(plan) :] = plan[-1]
        row[len(plan) :, 0] = 2.0 * plot.duration  # never reached
    rows, commands = drive(scene.robots, start(rng, plot, depth), padded, forces(rng, plot, ticks), ticks)
    return rows, commands
