"""What the ROV is asked to do: a programme of demands, kept near its place and at its depth by the one who steers.

A programme is an array (segments, 5): start [s], demand of surge, sway and yaw (-1 to 1), depth to hold [m].
"""

# mypy: disable-error-code="no-any-return"

from __future__ import annotations

import math

import numpy as np

from concealer.compiled import compiled
from concealer.layout import FloatArray
from concealer.six_degrees import layout as at
from concealer.six_degrees.motion import advance, felt, turned_back

REACH = 4.0  # m from the origin, beyond which it is steered back


def drawn(rng: np.random.Generator, duration: float) -> FloatArray:
    """Single axes, mixtures, coasts and spins of 1.5 to 7 s; depths between 1 and 4 m for 12 to 30 s."""
    rows, t, until, depth = [], 0.0, 0.0, 2.0
    while t < duration:
        if t >= until:
            depth, until = rng.uniform(1.0, 4.0), t + rng.uniform(12.0, 30.0)
        demand = rng.uniform(-1.0, 1.0, 3) * np.array([0.15, 0.15, 0.05])
        kind = rng.random()
        if kind < 0.5:
            demand *= np.eye(3)[rng.integers(3)]
        elif kind < 0.7:
            demand *= 0.0
        rows.append([t, *demand, depth])
        t += rng.uniform(1.5, 7.0)
    return np.array(rows)


@compiled
def decide(s: FloatArray, segment: FloatArray) -> FloatArray:
    """(8,) commands of the thrusters, in steps of 1/400."""
    demand = np.array([segment[1], segment[2], 0.0, segment[3]])
    if math.hypot(s[at.X], s[at.Y]) > REACH:
        home = turned_back(s[at.QUATERNION : at.QUATERNION + 4], np.array([-s[at.X], -s[at.Y], 0.0]))
        demand[0], demand[1] = 0.02 * home[0], 0.02 * home[1]
    demand[2] = min(max(0.1 * (-segment[4] - s[at.Z]) - 0.1 * s[at.VELOCITY + 2], -0.06), 0.06)
    out = np.zeros(8)
    for k in range(8):
        for axis in range(4):
            out[k] += demand[axis] * at.ALLOCATION[axis, k]
        out[k] = round(400.0 * min(max(out[k], -1.0), 1.0)) / 400.0
    return out


@compiled
def drive(p: FloatArray, plan: FloatArray, knots: FloatArray, ticks: int) -> tuple[FloatArray, FloatArray]:
    """Trajectory (rows, ROW) and commands (ticks, 8), from rest 2 m deep; knots (ticks + 1, 4) of random forces."""
    per = at.STEPS_PER_TICK // at.STEPS_PER_ROW
    rows, commands = np.zeros((ticks * per + 1, at.ROW)), np.zeros((ticks, 8))
    s, k = np.zeros(at.STATE), 0
    s[at.Z], s[at.QUATERNION] = -2.0, 1.0
    push = knots[0].copy()
    for tick in range(ticks):
        while k + 1 < plan.shape[0] and plan[k + 1, 0] <= tick * at.TICK + 1e-9:
            k += 1
        commands[tick] = decide(s, plan[k])
        for step in range(at.STEPS_PER_TICK):
            index, part = tick * at.STEPS_PER_TICK + step, step / at.STEPS_PER_TICK
            push[:] = (1.0 - part) * knots[tick] + part * knots[tick + 1]
            if step % at.STEPS_PER_ROW == 0:
                rows[index // at.STEPS_PER_ROW, : at.STATE] = s
                rows[index // at.STEPS_PER_ROW, at.STATE :] = felt(p, s, push, index * at.STEP)
            advance(p, s, commands[tick], push, index * at.STEP)
    rows[-1, : at.STATE], rows[-1, at.STATE :] = s, felt(p, s, push, ticks * at.TICK)
    return rows, commands


@compiled
def replay(p: FloatArray, start: FloatArray, commands: FloatArray, first: int) -> FloatArray:
    """Trajectory (rows, STATE) by logged commands (ticks, 8) from tick `first` on, in water that does not push."""
    per, ticks = at.STEPS_PER_TICK // at.STEPS_PER_ROW, commands.shape[0]
    rows, s, push = np.zeros((ticks * per + 1, at.STATE)), start.copy(), np.zeros(4)
    for index in range(ticks * at.STEPS_PER_TICK):
        if index % at.STEPS_PER_ROW == 0:
            rows[index // at.STEPS_PER_ROW] = s
        advance(p, s, commands[index // at.STEPS_PER_TICK], push, (first * at.STEPS_PER_TICK + index) * at.STEP)
    rows[-1] = s
    return rows
