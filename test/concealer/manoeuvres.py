"""Programmes of commands: what the robots are asked to do for ten minutes.

`rich` has everything that separates one effect from another; the others are recordings that cannot tell.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from concealer import pilot as at
from concealer.layout import FloatArray


class Pool(NamedTuple):
    """The tank and how long it is used."""

    half: float  # m, half the side of the square tank
    depth: float  # m
    duration: float  # s
    margin: float  # m, kept from walls
    follow: bool  # others swim behind the first robot
    # Of rich programmes: factors of durations and thruster commands, spread of the log weights of manoeuvres.
    style: tuple[float, float, float] = (1.0, 1.0, 0.0)


Segment = tuple[float, float, float, float, float]  # duration [s], left and right command, first and last


def _forward(rng: np.random.Generator) -> list[Segment]:
    c = rng.uniform(0.25, 1.0)
    return [(rng.uniform(2.0, 7.0), c, c, c, c)]


def _coast(rng: np.random.Generator) -> list[Segment]:
    c = rng.uniform(0.5, 1.0)
    return [(rng.uniform(2.5, 5.0), c, c, c, c), (rng.uniform(3.0, 7.0), 0.0, 0.0, 0.0, 0.0)]


def _spin(rng: np.random.Generator) -> list[Segment]:
    c = rng.choice([-1.0, 1.0]) * rng.uniform(0.05, 1.0)
    return [(rng.uniform(1.5, 4.0), -c, -c, c, c), (rng.uniform(1.5, 3.0), 0.0, 0.0, 0.0, 0.0)]


def _reverse(rng: np.random.Generator) -> list[Segment]:
    c = -rng.uniform(0.2, 1.0)
    d = c + rng.uniform(-0.1, 0.1)
    return [(rng.uniform(2.0, 6.0), c, c, d, d)]


def _turn(rng: np.random.Generator) -> list[Segment]:
    c, d = rng.uniform(-0.2, 1.0, 2)
    return [(rng.uniform(1.5, 6.0), c, c, d, d)]


def _ramp(rng: np.random.Generator) -> list[Segment]:
    """One thruster slowly through zero, the other steady or its mirror."""
    low, high = -rng.uniform(0.15, 0.5), rng.uniform(0.15, 0.5)
    if rng.random() < 0.5:
        low, high = high, low
    steady = rng.uniform(-0.3, 0.5)
    ramp = (rng.uniform(5.0, 9.0), low, high)
    if rng.random() < 0.4:
        return [(*ramp, -low, -high)]
    if rng.random() < 0.5:
        return [(*ramp, steady, steady)]
    return [(ramp[0], steady, steady, low, high)]


def _zigzag(rng: np.random.Generator) -> list[Segment]:
    c, d, hold = rng.uniform(0.4, 0.85), rng.uniform(0.08, 0.15), rng.uniform(2.0, 4.0)
    return [(hold, c - s * d, c - s * d, c + s * d, c + s * d) for s in (1.0, -1.0, 1.0, -1.0)]


RICH: tuple[tuple[Callable[[np.random.Generator], list[Segment]], float], ...] = (
    (_forward, 0.18), (_coast, 0.17), (_spin, 0.15), (_reverse, 0.13), (_turn, 0.17), (_ramp, 0.12), (_zigzag, 0.08),
)  # fmt: skip


def _depths(rng: np.random.Generator, pool: Pool) -> list[tuple[float, float, float, float]]:
    """Start [s], open?, first and last value: depths to hold in turn with open pulses and ramps of the pump."""
    out: list[tuple[float, float, float, float]] = []
    t = 0.0
    near = 0.25 if pool.margin > 0.3 else 0.12
    while t < pool.duration:
        depth = rng.uniform(near, pool.depth - near)
        out.append((t, 0.0, depth, depth))
        t += rng.uniform(12.0, 30.0)
        for _ in range(rng.integers(0, 4)):
            a, b = rng.uniform(-0.12, 0.12, 2)
            out.append((t, 1.0, a, a if rng.random() < 0.6 else b))
            t += rng.uniform(1.5, 4.0)
    return out


def _merged(pool: Pool, moves: list[Segment], pumps: list[tuple[float, float, float, float]]) -> FloatArray:
    """Both programmes in one table: a new row wherever either begins a new segment."""
    starts = np.cumsum([0.0] + [move[0] for move in moves])
    times = np.unique(np.concatenate([starts[:-1], [pump[0] for pump in pumps]]).round(1))
    times = times[times < pool.duration]
    ends = np.append(times[1:], pool.duration)
    table = np.zeros((len(times), at.COLUMNS))
    opened = np.array([pump[0] for pump in pumps]).round(1)
    for row, begin, end in zip(table, times, ends, strict=True):
        k = int(np.searchsorted(starts[:-1].round(1), begin, side="right")) - 1
        move, begun = moves[k], starts[k].round(1)
        parts = (np.array([begin, end]) - begun) / max(starts[k + 1].round(1) - begun, 0.1)
        row[at.START] = begin
        row[[at.LEFT, at.LEFT_END]] = move[1] + parts * (move[2] - move[1])
        row[[at.RIGHT, at.RIGHT_END]] = move[3] + parts * (move[4] - move[3])
        n = int(np.searchsorted(opened, begin, side="right")) - 1
        row[[at.PUMP_OPEN, at.PUMP, at.PUMP_END]] = pumps[n][1:]
        row[at.FOLLOW], row[at.MARGIN] = float(pool.follow), pool.margin
    return table


def rich(rng: np.random.Generator, pool: Pool) -> FloatArray:
    """Coasts, spins, reverse, turns, zigzags, ramps through zero; depths, pulses and ramps of the pump."""
    weights = np.array([weight for _, weight in RICH])
    stretch, level, taste = pool.style
    if taste > 0.0:
        weights = weights * np.exp(taste * rng.standard_normal(len(RICH)))
    moves: list[Segment] = []
    total = 0.0
    while total < pool.duration:
        kind = RICH[int(rng.choice(len(RICH), p=weights / weights.sum()))][0]
        moves += [(stretch * time, level * a, level * b, level * c, level * d) for time, a, b, c, d in kind(rng)]
        total = sum(move[0] for move in moves)
    return _merged(pool, moves, _depths(rng, pool))


def cruise(rng: np.random.Generator, pool: Pool) -> FloatArray:
    """Always forward at a good half of the thrust, gentle bends, one depth."""
    moves: list[Segment] = []
    while sum(move[0] for move in moves) < pool.duration:
        c, d = rng.uniform(0.5, 0.75), rng.uniform(-0.03, 0.03)
        moves.append((rng.uniform(8.0, 20.0), c - d, c - d, c + d, c + d))
    return _merged(pool, moves, [(0.0, 0.0, 1.0, 1.0)])


def steady_turns(rng: np.random.Generator, pool: Pool) -> FloatArray:
    """Long turns left and right at one level of thrust."""
    c, d = rng.uniform(0.5, 0.65), rng.uniform(0.05, 0.2)
    signs = rng.choice([-1.0, 1.0], 40)
    moves = [(15.0, c - s * d, c - s * d, c + s * d, c + s * d) for s in signs]
    return _merged(pool, moves, [(0.0, 0.0, 1.0, 1.0)])


def circle(rng: np.random.Generator, pool: Pool) -> FloatArray:
    """One command for the whole time: a circle."""
    c, d = rng.uniform(0.5, 0.7), rng.choice([-1.0, 1.0]) * rng.uniform(0.1, 0.25)
    return _merged(pool, [(pool.duration, c - d, c - d, c + d, c + d)], [(0.0, 0.0, 1.0, 1.0)])


def straight(rng: np.random.Generator, pool: Pool) -> FloatArray:
    """Straight on at one level of thrust until a wall is near."""
    c = rng.uniform(0.5, 0.8)
    return _merged(pool, [(pool.duration, c, c, c, c)], [(0.0, 0.0, 1.0, 1.0)])


def idle(rng: np.random.Generator, pool: Pool) -> FloatArray:
    """Thrusters off; the pump holds one depth."""
    depth = rng.uniform(0.8, 1.2)
    return _merged(pool._replace(margin=0.0), [(pool.duration, 0.0, 0.0, 0.0, 0.0)], [(0.0, 0.0, depth, depth)])


MANOEUVRES: dict[str, Callable[[np.random.Generator, Pool], FloatArray]] = {
    "rich": rich, "cruise": cruise, "steady_turns": steady_turns, "circle": circle, "straight": straight, "idle": idle,
    "no_ruler": rich,
}  # fmt: skip

# What a manoeuvre cannot show: no thruster comes near zero, or runs backwards, or runs at all; the pump holds still.
# Without a ruler (pressure, IMU, speed log) thrust, drag and buoyancy take up what the camera's scale does.
CANNOT_SHOW: dict[str, tuple[str, ...]] = {
    "cruise": ("thruster_deadband", "reverse_loss"),
    "steady_turns": ("thruster_deadband", "reverse_loss"),
    "circle": ("thruster_deadband", "reverse_loss"),
    "straight": ("thruster_deadband", "reverse_loss"),
    "no_ruler": ("camera_scale",),
    "idle": (
        "thruster_deadband", "reverse_loss", "thruster_lag", "thruster_asymmetry", "advance_loss",
        "thruster_misalignment", "battery_sag",
    ),
}  # fmt: skip
