"""Forms of laws: what becomes of the force by which a law changes a robot's motion, and laws that a grammar draws.

A robot's numbers are followed by blocks, one for each law with a form of its own: the robot's numbers with that law in
them, and the form's numbers. The law's force F is what these numbers do beyond the robot's own; g(F) is what pushes.
The last block is a law of the grammar. Robots without blocks are as they always were.
"""

# mypy: disable-error-code="no-any-return"

from __future__ import annotations

import math

import numpy as np

from concealer import layout as at
from concealer.compiled import compiled
from concealer.drives import buoyancy, thrust
from concealer.fluid import current, oddities, resist, swell
from concealer.layout import FloatArray

# --- numbers of a form, behind the SIZE numbers of the robot with the law
(KIND, GAIN, NUMBER, SCALE_X, SCALE_Y, SCALE_Z, SCALE_YAW, ALONG_X, ALONG_Y, PHASE) = range(10)
BLOCK = at.SIZE + 10
# --- numbers of a law of the grammar: equation and coefficient, then two factors
(EQUATION, COEFFICIENT, OMEGA, FIRST, SECOND) = (0, 1, 2, 3, 7)
(REGRESSOR, FACTOR_SCALE, POWER, SIGNED) = range(4)
LAW = at.SIZE + at.FORMED * BLOCK
WIDE = LAW + 11

NONE, PLAIN, SMOOTH, SATURATING, FRACTIONAL, HYSTERETIC, PLACED = range(7)
KINDS = {
    "plain": PLAIN, "smooth": SMOOTH, "saturating": SATURATING, "fractional": FRACTIONAL, "hysteretic": HYSTERETIC,
    "placed": PLACED,
}  # fmt: skip
EQUATIONS = ("none", "surge", "sway", "heave", "yaw", "world_x", "world_y")
REGRESSORS = ("none", "u", "v", "w", "r", "x", "y", "z", "sin_yaw", "cos_yaw", "thrust", "pump", "sin_t")


@compiled
def loads(p: FloatArray, s: FloatArray, command: FloatArray, t: float) -> FloatArray:
    """(4,) surge, sway, heave [N] and yaw [N m] that a robot with these numbers (SIZE,) feels in quiet water."""
    cos, sin = math.cos(s[at.YAW]), math.sin(s[at.YAW])
    east, north = current(p, s, t)
    u, v = s[at.U] - cos * east - sin * north, s[at.V] + sin * east - cos * north
    surge, sway, yaw = thrust(p, s, command, u)
    odd = oddities(p, s, u, t)
    out = resist(p, s, u, v, s[at.W] - swell(p, s, t)[1])
    out[0] += surge + odd[0] + cos * odd[4] + sin * odd[5]
    out[1] += sway + odd[1] - sin * odd[4] + cos * odd[5]
    out[2] += buoyancy(p, s, t) + odd[2]
    out[3] += yaw + odd[3]
    return out


@compiled
def shaped(form: FloatArray, force: float, scale: float, s: FloatArray, memory: float) -> float:
    """What a form makes of a force on one axis; memory: of the play operator on this axis."""
    kind, number = form[KIND], form[NUMBER]
    if kind == SMOOTH:
        return force * abs(force) / math.sqrt(force * force + (number * scale) ** 2)
    if kind == SATURATING:
        return number * scale * math.tanh(force / (number * scale))
    if kind == FRACTIONAL:
        return math.copysign(scale * (abs(force) / scale) ** number, force)
    if kind == HYSTERETIC:
        return memory
    if kind == PLACED:
        return force * (1.0 + number * math.sin(form[ALONG_X] * s[at.X] + form[ALONG_Y] * s[at.Y] + form[PHASE]))
    return force


@compiled
def block_force(p: FloatArray, s: FloatArray, command: FloatArray, t: float, k: int) -> FloatArray:
    """(4,) the plain force of the law in block k of a robot's numbers (WIDE,)."""
    begin = at.SIZE + k * BLOCK
    own = p[: at.SIZE]
    return loads(p[begin : begin + at.SIZE], s, command, t) - loads(own, s, command, t)


@compiled
def form_force(p: FloatArray, s: FloatArray, command: FloatArray, t: float, k: int) -> FloatArray:
    """(4,) what the form of block k makes of it."""
    form = p[at.SIZE + k * BLOCK + at.SIZE : at.SIZE + (k + 1) * BLOCK]
    force = block_force(p, s, command, t, k)
    for axis in range(4):
        memory = s[at.MEMORY + 4 * k + axis]
        force[axis] = form[GAIN] * shaped(form, force[axis], form[SCALE_X + axis], s, memory)
    return force


@compiled
def regressor(k: int, s: FloatArray, command: FloatArray, through: tuple[float, float], wave: float) -> float:
    """Value of a regressor of the grammar: SI units, thrust and pump as fractions of their full commands."""
    values = (
        1.0, through[0], through[1], s[at.W], s[at.R], s[at.X], s[at.Y], s[at.Z],
        math.sin(s[at.YAW]), math.cos(s[at.YAW]),
        0.5 * (command[0] + command[1]), s[at.PLAY], wave,
    )  # fmt: skip
    return values[k]


@compiled
def product(law: FloatArray, s: FloatArray, command: FloatArray, through: tuple[float, float], t: float) -> float:
    """The factors of a law of the grammar, multiplied; through: surge and sway speed through the water [m/s]."""
    value, wave = 1.0, math.sin(law[OMEGA] * t)
    for begin in (FIRST, SECOND):
        if law[begin + REGRESSOR] > 0.0:
            x = regressor(int(law[begin + REGRESSOR]), s, command, through, wave) / law[begin + FACTOR_SCALE]
            size = abs(x) ** law[begin + POWER]
            value *= math.copysign(size, x) if law[begin + SIGNED] > 0.0 else size
    return value


@compiled
def law_force(p: FloatArray, s: FloatArray, command: FloatArray, t: float) -> FloatArray:
    """(4,) surge, sway, heave, yaw of the law of the grammar in a robot's numbers (WIDE,)."""
    out, law = np.zeros(4), p[LAW:]
    if law[EQUATION] == 0.0:
        return out
    cos, sin = math.cos(s[at.YAW]), math.sin(s[at.YAW])
    east, north = current(p, s, t)
    u, v = s[at.U] - cos * east - sin * north, s[at.V] + sin * east - cos * north
    value = law[COEFFICIENT] * product(law, s, command, (u, v), t)
    if law[EQUATION] <= 4.0:
        out[int(law[EQUATION]) - 1] = value
    elif law[EQUATION] == 5.0:
        out[0], out[1] = cos * value, -sin * value
    else:
        out[0], out[1] = sin * value, cos * value
    return out


@compiled
def formed(p: FloatArray, s: FloatArray, command: FloatArray, t: float) -> FloatArray:
    """(4,) surge, sway, heave [N] and yaw [N m] of all blocks of a robot's numbers (WIDE,)."""
    total = law_force(p, s, command, t)
    for k in range(at.FORMED):
        if p[at.SIZE + k * BLOCK + at.SIZE + KIND] != NONE:
            total += form_force(p, s, command, t, k)
    return total


@compiled
def remember(p: FloatArray, s: FloatArray, command: FloatArray, t: float) -> None:
    """Moves the play operators of all blocks of a robot: `number` scales wide, half on either side of the force."""
    for k in range(at.FORMED):
        form = p[at.SIZE + k * BLOCK + at.SIZE : at.SIZE + (k + 1) * BLOCK]
        if form[KIND] == HYSTERETIC:
            force = block_force(p, s, command, t, k)
            for axis in range(4):
                half, place = 0.5 * form[NUMBER] * form[SCALE_X + axis], at.MEMORY + 4 * k + axis
                s[place] = min(max(s[place], force[axis] - half), force[axis] + half)
