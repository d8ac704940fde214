"""What a vehicle is asked to do: a programme of demands; its pilot keeps it near its place and at its depth.

A programme is an array (segments, 6): start [s]; demand of surge, sway and yaw (-1 to 1), or a heading [rad] where the
pilot holds one; depth to hold [m]; share by which the first of two propellers does more than the second.
"""

# mypy: disable-error-code="no-any-return"

from __future__ import annotations

import math

import numpy as np

from concealer.compiled import compiled
from concealer.layout import FloatArray
from concealer.six_degrees import layout as at
from concealer.six_degrees.makes import Pilot
from concealer.six_degrees.motion import advance, felt, turned_back


def drawn(rng: np.random.Generator, duration: float, pilot: Pilot) -> FloatArray:
    """Single axes, mixtures and coasts; a heading that is held, and the use of two propellers, in every segment."""
    rows, t, until, depth = [], 0.0, 0.0, 2.0
    while t < duration:
        if t >= until:
            depth, until = rng.uniform(*pilot.depths), t + rng.uniform(*pilot.depth_time)
        demand = rng.uniform(-1.0, 1.0, 3) * np.array(pilot.demands)
        kind, turn = rng.random(), demand[2]
        if kind < 0.5:
            demand *= np.eye(3)[rng.integers(3)]
        elif kind < 0.7:
            demand *= 0.0
        split = 0.0
        if pilot.splits:
            demand[2], split = turn, rng.choice(pilot.splits)
        rows.append([t, *demand, depth, split])
        t += rng.uniform(*pilot.segment)
    return np.array(rows)


@compiled
def heading_of(s: FloatArray) -> float:
    """Angle of the bow over the ground from east [rad]."""
    w, x, y, z = s[at.QUATERNION : at.QUATERNION + 4]
    return math.atan2(2.0 * (w * z + x * y), 1.0 - 2.0 * (y * y + z * z))


@compiled
def decide(p: FloatArray, s: FloatArray, segment: FloatArray) -> FloatArray:
    """(COUNT,) commands of the thrusters, in steps of 1/400."""
    demand = np.array([segment[1], segment[2], 0.0, segment[3], segment[1] * segment[5]])
    wanted = segment[3]
    if math.hypot(s[at.X], s[at.Y]) > p[at.REACH]:
        home = turned_back(s[at.QUATERNION : at.QUATERNION + 4], np.array([-s[at.X], -s[at.Y], 0.0]))
        demand[0], demand[1], demand[4] = p[at.HOME] * home[0], p[at.HOME] * home[1], 0.0
        wanted = math.atan2(-s[at.Y], -s[at.X])
    if p[at.HEADING] > 0.0:
        off = wanted - heading_of(s)
        turn = p[at.HEADING] * math.atan2(math.sin(off), math.cos(off)) - p[at.TURN] * s[at.RATE + 2]
        demand[3] = min(max(turn, -0.6), 0.6)
    climb = p[at.DEPTH] * (-segment[4] - s[at.Z]) - p[at.CLIMB] * s[at.VELOCITY + 2]
    demand[2] = min(max(climb, -p[at.MOST_HEAVE]), p[at.MOST_HEAVE])
    out = np.zeros(int(p[at.COUNT]))
    for k in range(out.size):
        for axis in range(at.DEMANDS):
            out[k] += demand[axis] * p[at.ALLOCATION + axis * at.MOST + k]
        out[k] = round(400.0 * min(max(out[k], -1.0), 1.0)) / 400.0
    return out


@compiled
def drive(p: FloatArray, plan: FloatArray, knots: FloatArray, ticks: int) -> tuple[FloatArray, FloatArray]:
    """Trajectory (rows, ROW) and commands (ticks, COUNT), from rest 2 m deep; knots (ticks + 1, 4) of random forces."""
    per = at.STEPS_PER_TICK // at.STEPS_PER_ROW
    rows, commands = np.zeros((ticks * per + 1, at.ROW)), np.zeros((ticks, int(p[at.COUNT])))
    s, k = np.zeros(at.STATE), 0
    s[at.Z], s[at.QUATERNION] = -2.0, 1.0
    push = knots[0].copy()
    for tick in range(ticks):
        while k + 1 < plan.shape[0] and plan[k + 1, 0] <= tick * at.TICK + 1e-9:
            k += 1
        commands[tick] = decide(p, s, plan[k])
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
    """Trajectory (rows, STATE) by logged commands (ticks, COUNT) from tick `first` on, in water that does not push."""
    per, ticks = at.STEPS_PER_TICK // at.STEPS_PER_ROW, commands.shape[0]
    rows, s, push = np.zeros((ticks * per + 1, at.STATE)), start.copy(), np.zeros(4)
    for index in range(ticks * at.STEPS_PER_TICK):
        if index % at.STEPS_PER_ROW == 0:
            rows[index // at.STEPS_PER_ROW] = s
        advance(p, s, commands[index // at.STEPS_PER_TICK], push, (first * at.STEPS_PER_TICK + index) * at.STEP)
    rows[-1] = s
    return rows
