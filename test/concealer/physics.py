"""Surge, sway, heave and yaw of robots in water: body-frame Newton-Euler with added mass (Fossen 2011, chapter 6).

    (m + A_u) du/dt = X + m r v + A_v r v_r + A_u r v_c         u_r = u - u_c: speed through the water
    (m + A_v) dv/dt = Y - m r u - A_u r u_r - A_v r u_c
    (m + A_w) dw/dt = Z
    (I + A_r) dr/dt = N - (A_v - A_u) u_r v_r

Where the centre of mass is at (x, y) beside the origin, at which forces act and drag is felt, surge, sway and yaw are
one system (`answer`); I is the inertia about the centre. Water that the pump draws in moves the centre.

Integrated by the explicit midpoint rule with steps of 5 ms. Random forces and the wakes of neighbours are held
during a step. Assumptions: no roll or pitch; the water accelerates the robot by drag alone.
"""

# mypy: disable-error-code="no-any-return"

from __future__ import annotations

import math

import numpy as np

from concealer import layout as at
from concealer.compiled import compiled
from concealer.drives import buoyancy, charge_rate, slowed, stage_rates, thrust
from concealer.fluid import current, oddities, resist, swell
from concealer.forms import formed, remember
from concealer.layout import FloatArray
from concealer.pilot import decide


@compiled
def answer(p: FloatArray, s: FloatArray, load: FloatArray, rate: FloatArray) -> None:
    """Fills in the rates of surge, sway and yaw rate under a load (3,) that holds all terms but those of the offset."""
    x, y = p[at.CENTRE_AHEAD] + p[at.CENTRE_SHIFT] * s[at.PLAY], p[at.CENTRE_LEFT]
    m, r = p[at.MASS], s[at.R]
    along, aside, about = m + p[at.ADDED_SURGE], m + p[at.ADDED_SWAY], p[at.INERTIA] + p[at.ADDED_YAW]
    if x == 0.0 and y == 0.0:
        rate[at.U], rate[at.V], rate[at.R] = load[0] / along, load[1] / aside, load[2] / about
        return
    inertia = np.zeros((3, 3))
    inertia[0, 0], inertia[1, 1], inertia[2, 2] = along, aside, about + m * (x * x + y * y)
    inertia[0, 2], inertia[2, 0], inertia[1, 2], inertia[2, 1] = -m * y, -m * y, m * x, m * x
    felt = load.copy()
    felt[0] += m * x * r * r
    felt[1] += m * y * r * r
    felt[2] -= m * r * (x * s[at.U] + y * s[at.V])
    found = np.linalg.solve(inertia, felt)
    rate[at.U], rate[at.V], rate[at.R] = found[0], found[1], found[2]


@compiled
def derivative(p: FloatArray, s: FloatArray, command: FloatArray, push: FloatArray, t: float) -> FloatArray:
    """(STATE,) rate of the state, under a command (3,) and a push (4,): world x, y, z [N] and yaw [N m]."""
    rate = np.zeros(at.STATE)
    cos, sin = math.cos(s[at.YAW]), math.sin(s[at.YAW])
    east, north = current(p, s, t)
    u_c, v_c = cos * east + sin * north, -sin * east + cos * north
    u_r, v_r, r = s[at.U] - u_c, s[at.V] - v_c, s[at.R]
    stage_rates(p, s, command, rate)
    rate[at.CHARGE] = charge_rate(command)
    surge, sway, yaw = thrust(p, s, command, u_r)
    heave = buoyancy(p, s, t)
    drag = resist(p, s, u_r, v_r, s[at.W] - swell(p, s, t)[1])
    odd = oddities(p, s, u_r, t)
    fx, fy = push[0] + odd[4], push[1] + odd[5]
    surge += drag[0] + odd[0] + cos * fx + sin * fy
    sway += drag[1] + odd[1] - sin * fx + cos * fy
    heave += drag[2] + odd[2] + push[2]
    yaw += drag[3] + odd[3] + push[3]
    if p.shape[0] > at.SIZE:
        more = formed(p, s, command, t)
        surge, sway, heave, yaw = surge + more[0], sway + more[1], heave + more[2], yaw + more[3]
    m, a_u, a_v = p[at.MASS], p[at.ADDED_SURGE], p[at.ADDED_SWAY]
    load = np.zeros(3)
    load[0] = surge + m * r * s[at.V] + a_v * r * v_r + a_u * r * v_c
    load[1] = sway - m * r * s[at.U] - a_u * r * u_r - a_v * r * u_c
    load[2] = yaw - (a_v - a_u) * u_r * v_r
    answer(p, s, load, rate)
    rate[at.W] = heave / (m + p[at.ADDED_HEAVE])
    rate[at.X] = cos * s[at.U] - sin * s[at.V]
    rate[at.Y] = sin * s[at.U] + cos * s[at.V]
    rate[at.Z] = s[at.W]
    rate[at.YAW] = r
    return rate


@compiled
def wake(p: FloatArray, s: FloatArray, i: int) -> FloatArray:
    """(3,) force on robot i by the jets of its neighbours: 1/d along the jet, a Gaussian across it [N, world]."""
    force = np.zeros(3)
    for j in range(s.shape[0]):
        if j == i or p[i, at.WAKE] == 0.0:
            continue
        level = slowed(p[j], s[j], at.LEFT_SLOW) + slowed(p[j], s[j], at.RIGHT_SLOW)
        jet = p[j, at.THRUST] * level
        side = 1.0 if jet >= 0.0 else -1.0
        cos, sin = math.cos(s[j, at.YAW]), math.sin(s[j, at.YAW])
        dx, dy = s[i, at.X] - s[j, at.X], s[i, at.Y] - s[j, at.Y]
        behind = -side * (cos * dx + sin * dy)
        if behind < 0.03:
            continue
        across = (-sin * dx + cos * dy) ** 2 + (s[i, at.Z] - s[j, at.Z]) ** 2
        strength = p[i, at.WAKE] * abs(jet) * 0.1 / max(behind, 0.1)
        strength *= math.exp(-across / (0.05 + 0.2 * behind) ** 2)
        force[0] -= side * strength * cos
        force[1] -= side * strength * sin
    return force


@compiled
def play(p: FloatArray, s: FloatArray, command: FloatArray) -> None:
    """Moves the pump's linkage: backlash, of whose full width half is idle on either side."""
    half = 0.5 * p[at.PUMP_PLAY]
    s[at.PLAY] = min(max(s[at.PLAY], command[2] - half), command[2] + half)


@compiled
def advance(p: FloatArray, s: FloatArray, command: FloatArray, push: FloatArray, time: float) -> None:
    """Moves every robot by one step, in place: midpoint rule."""
    pushed = push.copy()
    for i in range(s.shape[0]):
        pushed[i, :3] += wake(p, s, i)
    for i in range(s.shape[0]):
        play(p[i], s[i], command[i])
        if p.shape[1] > at.SIZE:
            remember(p[i], s[i], command[i], time)
        half = s[i] + 0.5 * at.STEP * derivative(p[i], s[i], command[i], pushed[i], time)
        s[i] += at.STEP * derivative(p[i], half, command[i], pushed[i], time + 0.5 * at.STEP)
        s[i, at.Z] = min(max(s[i, at.Z], p[i, at.FLOOR]), 0.0)


@compiled
def keep(p: FloatArray, s: FloatArray, command: FloatArray, push: FloatArray, time: float) -> FloatArray:
    """(robots, ROW) the states, what an accelerometer would feel beside gravity, speeds through the water."""
    row = np.zeros((s.shape[0], at.ROW))
    for i in range(s.shape[0]):
        pushed = push[i].copy()
        pushed[:3] += wake(p, s, i)
        play(p[i], s[i], command[i])  # the linkage moves with the command, before anybody feels it
        if p.shape[1] > at.SIZE:
            remember(p[i], s[i], command[i], time)
        rate = derivative(p[i], s[i], command[i], pushed, time)
        row[i, : at.STATE] = s[i]
        row[i, at.ACCEL] = rate[at.U] - s[i, at.R] * s[i, at.V]
        row[i, at.ACCEL + 1] = rate[at.V] + s[i, at.R] * s[i, at.U]
        row[i, at.ACCEL + 2] = rate[at.W]
        cos, sin = math.cos(s[i, at.YAW]), math.sin(s[i, at.YAW])
        east, north = current(p[i], s[i], time)
        row[i, at.THROUGH_U] = s[i, at.U] - cos * east - sin * north
        row[i, at.THROUGH_V] = s[i, at.V] + sin * east - cos * north
    return row


@compiled
def pushes(knots: FloatArray, index: int, push: FloatArray) -> None:
    """Random force at a step by linear interpolation of knots (n, robots, 4), one per tick / 2, into `push`."""
    per = at.STEPS_PER_TICK // 2
    k, part = index // per, (index % per) / per
    push[:] = (1.0 - part) * knots[k] + part * knots[k + 1]


@compiled
def drive(
    p: FloatArray, start: FloatArray, plans: FloatArray, knots: FloatArray, ticks: int
) -> tuple[FloatArray, FloatArray]:
    """Trajectory (rows, robots, ROW) and commands (ticks, robots, 3) of a run by programme.

    Plans (robots, segments, columns) as pilot.py reads them; knots: random forces.
    """
    robots = p.shape[0]
    rows_per_tick = at.STEPS_PER_TICK // at.STEPS_PER_ROW
    rows = np.zeros((ticks * rows_per_tick + 1, robots, at.ROW))
    commands = np.zeros((ticks, robots, 3))
    s, push = start.copy(), np.zeros((robots, 4))
    for tick in range(ticks):
        for i in range(robots):
            commands[tick, i] = decide(p, s, plans[i], i, tick * at.TICK)
        for step in range(at.STEPS_PER_TICK):
            index = tick * at.STEPS_PER_TICK + step
            pushes(knots, index, push)
            if step % at.STEPS_PER_ROW == 0:
                rows[index // at.STEPS_PER_ROW] = keep(p, s, commands[tick], push, index * at.STEP)
            advance(p, s, commands[tick], push, index * at.STEP)
    rows[-1] = keep(p, s, commands[-1], push, ticks * at.TICK)
    return rows, commands


@compiled
def replay(p: FloatArray, start: FloatArray, commands: FloatArray, knots: FloatArray, first: int) -> FloatArray:
    """Trajectory (rows, robots, ROW) of a run by recorded commands (ticks, robots, 3) from tick `first` on."""
    ticks, robots = commands.shape[0], p.shape[0]
    rows_per_tick = at.STEPS_PER_TICK // at.STEPS_PER_ROW
    rows = np.zeros((ticks * rows_per_tick + 1, robots, at.ROW))
    s, push = start.copy(), np.zeros((robots, 4))
    begin = first * at.STEPS_PER_TICK
    for index in range(ticks * at.STEPS_PER_TICK):
        command = commands[index // at.STEPS_PER_TICK]
        pushes(knots, index, push)
        if index % at.STEPS_PER_ROW == 0:
            rows[index // at.STEPS_PER_ROW] = keep(p, s, command, push, (begin + index) * at.STEP)
        advance(p, s, command, push, (begin + index) * at.STEP)
    rows[-1] = keep(p, s, commands[-1], push, (begin + ticks * at.STEPS_PER_TICK) * at.STEP)
    return rows


def still(robots: int, ticks: int) -> FloatArray:
    """Knots (2 ticks + 2, robots, 4) of water that does not push."""
    return np.zeros((2 * ticks + 2, robots, 4))
