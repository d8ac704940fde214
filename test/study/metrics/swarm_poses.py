"""Hand-made swarms whose statistics are known."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from cocorosim_ros.study.metrics import COLUMN, METRICS
from cocorosim_ros.study.metrics.kernel import measure_tick
from cocorosim_ros.study.metrics.memory import new_memory

STEP_NS = 500_000_000


@dataclass(frozen=True)
class Poses:
    """Swarm at successive ticks: position (t, n, 3) [m; world], yaw (t, n) [rad], present (t, n)."""

    position: NDArray[np.float64]
    yaw: NDArray[np.float64]
    present: NDArray[np.bool_]


def measured(poses: Poses, step_ns: int = STEP_NS) -> NDArray[np.float64]:
    """Values (t, metrics) of one run, measured tick by tick."""
    ticks, robots = poses.yaw.shape
    memory, values = new_memory(1, robots), np.empty((ticks, 1, len(METRICS)))
    for tick in range(ticks):
        elapsed = np.array([0 if tick == 0 else step_ns])
        row = slice(tick, tick + 1)
        measure_tick(
            poses.position[row].copy(),
            poses.yaw[row].copy(),
            poses.present[row].copy(),
            elapsed,
            memory,
            values[tick],
        )
    return values[:, 0]


def column(values: NDArray[np.float64], name: str) -> NDArray[np.float64]:
    """The values of one metric."""
    return values[..., COLUMN[name]]


def everybody(position: NDArray[np.float64], yaw: NDArray[np.float64]) -> Poses:
    """Poses at which all robots are present."""
    return Poses(np.asarray(position, float), np.asarray(yaw, float), np.ones(np.shape(yaw), np.bool_))


def wandering(seed: int, ticks: int = 12, robots: int = 11) -> Poses:
    """A swarm that drifts about and splits now and then."""
    rng = np.random.default_rng(seed)
    start = rng.uniform(-0.5, 0.5, (1, robots, 3))
    position = start + np.cumsum(rng.normal(0.0, 0.06, (ticks, robots, 3)), axis=0)
    return everybody(position, rng.uniform(-np.pi, np.pi, (ticks, robots)))


def aligned(robots: int = 11) -> Poses:
    """A line of robots 0.2 m apart that all head and swim along 30 degrees at 0.1 m/s."""
    line = np.column_stack([0.2 * np.arange(robots), np.zeros(robots), np.full(robots, -1.0)])
    step = 0.05 * np.array([np.cos(np.pi / 6), np.sin(np.pi / 6), 0.0])
    return everybody(np.stack([line, line + step]), np.full((2, robots), np.pi / 6))


def milling(robots: int = 8, radius: float = 0.3) -> Poses:
    """A ring of robots that circle counter-clockwise: position, heading and (in the mean) travel are
    tangential.
    """
    angle = 2.0 * np.pi * np.arange(robots) / robots + np.array([[0.0], [0.01]])
    position = np.stack([radius * np.cos(angle), radius * np.sin(angle), np.full(angle.shape, -1.0)], axis=-1)
    return everybody(position, angle + np.pi / 2)


def two_clusters(apart: float = 1.0) -> Poses:
    """Three robots in a line 0.1 m apart, and two robots 0.1 m apart at a distance, all at rest and heading
    east.
    """
    x = np.array([0.0, 0.1, 0.2, 0.2 + apart, 0.3 + apart])
    position = np.column_stack([x, np.zeros(5), np.full(5, -1.0)])
    return everybody(np.stack([position, position]), np.zeros((2, 5)))
