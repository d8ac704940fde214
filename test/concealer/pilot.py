"""Who steers: reads a programme of commands at each tick, keeps the robot in the tank and at its depth.

A programme is an array (segments, COLUMNS) sorted by start time; between two starts its commands run linearly from
their first to their last value. Steering uses the true state, as somebody at the tank's edge would.
"""

# mypy: disable-error-code="no-any-return"

from __future__ import annotations

import math

import numpy as np

from concealer import layout as at
from concealer.compiled import compiled
from concealer.layout import FloatArray

(START, LEFT, LEFT_END, RIGHT, RIGHT_END, PUMP_OPEN, PUMP, PUMP_END, FOLLOW, MARGIN) = range(10)
COLUMNS = 10
RESOLUTION = 127.0  # steps of a full command
LOOK_AHEAD = 3.5  # s
CRUISE = 0.55  # thrust while steering back; no thruster gets below ABOUT - TURN
ABOUT = 0.45  # thrust while turning about
TURN = 0.3


@compiled
def segment_at(plan: FloatArray, t: float) -> tuple[int, float]:
    """Index of the segment that holds at a time, and how much of it is over (0 to 1)."""
    k = 0
    while k + 1 < plan.shape[0] and plan[k + 1, START] <= t + 1e-9:
        k += 1
    end = plan[k + 1, START] if k + 1 < plan.shape[0] else plan[k, START] + 1e9
    return k, min((t - plan[k, START]) / max(end - plan[k, START], 1e-9), 1.0)


@compiled
def steer(s: FloatArray, east: float, north: float, level: float) -> tuple[float, float]:
    """Left and right command towards a heading given as a vector, slower while it is far off.

    Both stay forward, out of reach of any dead zone, if level is CRUISE.
    """
    error = math.atan2(north, east) - s[at.YAW]
    error = math.atan2(math.sin(error), math.cos(error))
    level = min(level, ABOUT) if abs(error) > 1.2 else level
    turn = min(max(0.8 * error - 0.5 * s[at.R], -TURN), TURN)
    return level - turn, level + turn


@compiled
def outside(p: FloatArray, s: FloatArray, margin: float) -> bool:
    """Whether the robot is, or will soon be, nearer to a wall than the margin."""
    cos, sin = math.cos(s[at.YAW]), math.sin(s[at.YAW])
    x = s[at.X] + LOOK_AHEAD * (cos * s[at.U] - sin * s[at.V])
    y = s[at.Y] + LOOK_AHEAD * (sin * s[at.U] + cos * s[at.V])
    return bool(abs(x) > p[at.HALF_X] - margin or abs(y) > p[at.HALF_Y] - margin)


@compiled
def hold_depth(s: FloatArray, depth: float) -> float:
    """Pump command towards a depth [m]."""
    return min(max(0.4 * (-depth - s[at.Z]) - 1.2 * s[at.W], -0.3), 0.3)


@compiled
def pump_command(p: FloatArray, s: FloatArray, segment: FloatArray, part: float) -> float:
    """Pump command of a segment; an open command is overruled near surface and floor."""
    value = segment[PUMP] + part * (segment[PUMP_END] - segment[PUMP])
    if segment[PUMP_OPEN] == 0.0:
        return hold_depth(s, value)
    z = s[at.Z] + 2.0 * s[at.W]
    if z > -0.15 or z < p[at.FLOOR] + 0.15:
        return hold_depth(s, -0.5 * p[at.FLOOR])
    return float(value)


@compiled
def behind_leader(s: FloatArray, i: int) -> tuple[float, float]:
    """Left and right command of a robot that swims in the wake of robot 0."""
    cos, sin = math.cos(s[0, at.YAW]), math.sin(s[0, at.YAW])
    dx = s[0, at.X] - 0.2 * i * cos - s[i, at.X]
    dy = s[0, at.Y] - 0.2 * i * sin - s[i, at.Y]
    return steer(s[i], dx, dy, min(2.0 * math.sqrt(dx * dx + dy * dy), 0.7))


@compiled
def decide(p: FloatArray, s: FloatArray, plan: FloatArray, i: int, t: float) -> FloatArray:
    """(3,) left, right, pump command of robot i at a time, in steps of the drives' resolution."""
    k, part = segment_at(plan, t)
    segment = plan[k]
    left = segment[LEFT] + part * (segment[LEFT_END] - segment[LEFT])
    right = segment[RIGHT] + part * (segment[RIGHT_END] - segment[RIGHT])
    if segment[FOLLOW] > 0.0 and i > 0:
        left, right = behind_leader(s, i)
    if segment[MARGIN] > 0.0 and outside(p[i], s[i], segment[MARGIN]):
        left, right = steer(s[i], -s[i, at.X], -s[i, at.Y], CRUISE)
    out = np.zeros(3)
    out[0], out[1] = left, right
    out[2] = pump_command(p[i], s[i], segment, part)
    if segment[FOLLOW] > 0.0 and i > 0:
        out[2] = hold_depth(s[i], -s[0, at.Z])
    for n in range(3):
        out[n] = round(min(max(out[n], -1.0), 1.0) * RESOLUTION) / RESOLUTION
    return out
