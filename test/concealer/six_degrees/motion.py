"""Six degrees of freedom of a body in water at rest: Kirchhoff's equations with damping, buoyancy and thrust.

    M dv/dt = (M v) x w + F,   I dw/dt = (I w) x w + (M v) x v + N        (Lamb, Hydrodynamics, article 124)

M and I: diagonal, with what the water adds; v, w: velocity and turn rate in body axes; attitude: a quaternion.
Integrated by the classical fourth-order rule with steps of 5 ms. Thrusters follow their levels between steps.
"""

# mypy: disable-error-code="no-any-return"

from __future__ import annotations

import math

import numpy as np

from concealer.compiled import compiled
from concealer.layout import FloatArray
from concealer.six_degrees import layout as at

PIECES = 12  # of a cable
FRICTION = 0.02  # drag along a cable over drag across it


@compiled
def turned(q: FloatArray, vector: FloatArray) -> FloatArray:
    """(3,) a vector in body axes as the world has it; q: (w, x, y, z)."""
    w, x, y, z = q
    out = np.empty(3)
    out[0] = (1 - 2 * (y * y + z * z)) * vector[0] + 2 * (x * y - w * z) * vector[1] + 2 * (x * z + w * y) * vector[2]
    out[1] = 2 * (x * y + w * z) * vector[0] + (1 - 2 * (x * x + z * z)) * vector[1] + 2 * (y * z - w * x) * vector[2]
    out[2] = 2 * (x * z - w * y) * vector[0] + 2 * (y * z + w * x) * vector[1] + (1 - 2 * (x * x + y * y)) * vector[2]
    return out


@compiled
def turned_back(q: FloatArray, vector: FloatArray) -> FloatArray:
    """(3,) a vector in world axes as the body has it."""
    return turned(np.array([q[0], -q[1], -q[2], -q[3]]), vector)


@compiled
def cross(a: FloatArray, b: FloatArray) -> FloatArray:
    """(3,) the vector product."""
    return np.array([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]])


@compiled
def level_of(p: FloatArray, command: float) -> float:
    """Thrust fraction of a steady command: none within the dead zone, weaker backwards."""
    if abs(command) <= p[at.DEAD]:
        return 0.0
    return command * (1.0 - p[at.REVERSE]) if command < 0.0 else command


@compiled
def size_of(vector: FloatArray) -> float:
    """Length of a vector."""
    return math.sqrt(np.sum(vector * vector))


@compiled
def cable_drag(p: FloatArray, s: FloatArray) -> FloatArray:
    """(3,) what a cable to the surface takes from the vehicle in still water, in world axes [N].

    It hangs in a bow to the side, here in twelve straight pieces; its places move in proportion to their share of the
    way to the vehicle, which bears that share of their drag. Each piece has drag across it, and a fiftieth along it.
    """
    out, aside = np.zeros(3), np.zeros(3)
    span = s[:3] - np.array([p[at.CABLE_X], p[at.CABLE_Y], 0.0])
    level = math.hypot(span[0], span[1])
    if level > 0.0:
        aside[0], aside[1] = -span[1], span[0]
        aside *= 4.0 * p[at.CABLE_BOW] * size_of(span) / level
    velocity = turned(s[at.QUATERNION : at.QUATERNION + 4], s[at.VELOCITY : at.VELOCITY + 3])
    for k in range(PIECES):
        begin, end = k / PIECES, (k + 1) / PIECES
        share = 0.5 * (begin + end)
        piece = (end - begin) * span + (end * (1.0 - end) - begin * (1.0 - begin)) * aside
        length = size_of(piece)
        along = np.sum(share * velocity * piece) / length**2 * piece
        across = share * velocity - along
        drag = size_of(across) * across + FRICTION * size_of(along) * along
        out -= share * 0.5 * at.RHO * p[at.CABLE] * at.CABLE_WIDTH * length * drag
    return out


@compiled
def world_force(p: FloatArray, s: FloatArray, push: FloatArray, t: float) -> FloatArray:
    """(3,) buoyancy less weight, load, tether, cable, random and swinging forces in world axes [N]."""
    out = push[:3].copy()
    if p[at.CABLE] > 0.0:
        out += cable_drag(p, s)
    out[0] += p[at.TETHER] * (p[at.TETHER_X] - s[at.X])
    out[1] += p[at.TETHER] * (p[at.TETHER_Y] - s[at.Y])
    out[0] += p[at.SWING] * math.sin(p[at.SWING_OMEGA] * t + p[at.SWING_PHASE])
    out[2] += p[at.LIFT] + (p[at.LOAD_FORCE] * min(max(t - p[at.LOAD_TIME], 0.0), 1.0))
    return out


@compiled
def hull_lift(p: FloatArray, v: FloatArray) -> FloatArray:
    """(3,) lift across a hull that drifts or climbs at speed, in body axes [N]; it stalls at large angles of attack."""
    out, squared = np.zeros(3), np.sum(v * v)
    if squared > 0.0:
        attack = (v[1] * v[1] + v[2] * v[2]) / squared
        out[1:] = -p[at.HULL_LIFT] * abs(v[0]) * (1.0 - p[at.HULL_STALL] * attack) * v[1:]
    return out


@compiled
def direction_of(p: FloatArray, k: int) -> FloatArray:
    """(3,) direction in which a thruster pushes ahead."""
    return p[at.DIRECTIONS + 3 * k : at.DIRECTIONS + 3 * k + 3]


@compiled
def washed(p: FloatArray, s: FloatArray, k: int) -> float:
    """Fraction of its thrust that a thruster loses in the jets of others that push alike.

    Of two that push as much a rear one loses what the American Bureau of Shipping reckons with, times a number; of one
    that pushes more no more than that. A jet widens by a sixth of its way, and ends at its rim.
    """
    lost, own = 0.0, s[at.LEVEL + k]
    if p[at.WASH] <= 0.0 or own == 0.0:
        return lost
    for other in range(int(p[at.COUNT])):
        push = s[at.LEVEL + other]
        along = np.sum(direction_of(p, k) * direction_of(p, other)) * math.copysign(1.0, own * push)
        if other == k or push == 0.0 or along <= 0.0:
            continue
        way = p[at.PLACES + 3 * k : at.PLACES + 3 * k + 3] - p[at.PLACES + 3 * other : at.PLACES + 3 * other + 3]
        behind = -math.copysign(1.0, push) * np.sum(way * direction_of(p, other))
        aside = math.sqrt(max(np.sum(way * way) - behind * behind, 0.0))
        if behind <= 0.0 or aside >= 0.5 * p[at.PROPELLER] + behind / 6.0:
            continue
        left = 0.75 ** ((behind / p[at.PROPELLER]) ** (2.0 / 3.0))
        lost += p[at.WASH] * left * along * min(abs(push / own), 1.0)
    return min(lost, 1.0)


@compiled
def loads(p: FloatArray, s: FloatArray, push: FloatArray, t: float) -> tuple[FloatArray, FloatArray]:
    """Force (3,) [N] and moment (3,) [N m] on the body, in its axes."""
    q, v, w = s[at.QUATERNION : at.QUATERNION + 4], s[at.VELOCITY : at.VELOCITY + 3], s[at.RATE : at.RATE + 3]
    force = turned_back(q, world_force(p, s, push, t))
    up = turned_back(q, np.array([0.0, 0.0, 1.0]))
    # Buoyancy acts above the origin, where the mass is.
    moment = cross(np.array([0.0, 0.0, p[at.RIGHTING]]), up)
    moment[2] += push[3] + p[at.SWING_YAW] * math.sin(p[at.SWING_OMEGA] * t + p[at.SWING_PHASE])
    for axis in range(3):
        force[axis] -= (p[at.LINEAR + axis] + p[at.QUADRATIC + axis] * abs(v[axis])) * v[axis]
        moment[axis] -= (p[at.LINEAR + 3 + axis] + p[at.QUADRATIC + 3 + axis] * abs(w[axis])) * w[axis]
    aside = 0.0
    left = p[at.THRUST] * (1.0 - p[at.BATTERY] * t / p[at.DURATION])
    for k in range(int(p[at.COUNT])):
        thrust = left * (1.0 - washed(p, s, k)) * s[at.LEVEL + k] * direction_of(p, k)
        force += thrust
        moment += cross(p[at.PLACES + 3 * k : at.PLACES + 3 * k + 3], thrust)
        aside += thrust[1]
    if p[at.HULL_LIFT] > 0.0:
        lift = hull_lift(p, v)
        force += lift
        moment += cross(np.array([p[at.HULL_CENTRE], 0.0, 0.0]), lift)
    moment[2] += p[at.SIDE_LEVER] * (aside + p[at.SIDE_UNEVEN] * abs(aside))
    return force, moment


@compiled
def rate_of(p: FloatArray, s: FloatArray, push: FloatArray, t: float) -> FloatArray:
    """(STATE,) rate of the state; levels of thrusters are held."""
    q, v, w = s[at.QUATERNION : at.QUATERNION + 4], s[at.VELOCITY : at.VELOCITY + 3], s[at.RATE : at.RATE + 3]
    mass, inertia = p[at.MASS : at.MASS + 3], p[at.INERTIA : at.INERTIA + 3]
    force, moment = loads(p, s, push, t)
    out = np.zeros(at.STATE)
    out[:3] = turned(q, v)
    out[at.QUATERNION] = -0.5 * (q[1] * w[0] + q[2] * w[1] + q[3] * w[2])
    out[at.QUATERNION + 1 : at.QUATERNION + 4] = 0.5 * (q[0] * w + cross(q[1:], w))
    out[at.VELOCITY : at.VELOCITY + 3] = (cross(mass * v, w) + force) / mass
    out[at.RATE : at.RATE + 3] = (cross(inertia * w, w) + cross(mass * v, v) + moment) / inertia
    return out


@compiled
def advance(p: FloatArray, s: FloatArray, command: FloatArray, push: FloatArray, t: float) -> None:
    """Moves the state by one step, in place; thrusters follow with the exact decay of a first-order lag."""
    keep = math.exp(-at.STEP / p[at.LAG]) if p[at.LAG] > 0.0 else 0.0
    for k in range(int(p[at.COUNT])):
        wanted = level_of(p, command[k])
        s[at.LEVEL + k] = wanted + keep * (s[at.LEVEL + k] - wanted)
    h = at.STEP
    one = rate_of(p, s, push, t)
    two = rate_of(p, s + 0.5 * h * one, push, t + 0.5 * h)
    three = rate_of(p, s + 0.5 * h * two, push, t + 0.5 * h)
    s += h / 6.0 * (one + 2.0 * two + 2.0 * three + rate_of(p, s + h * three, push, t + h))
    s[at.QUATERNION : at.QUATERNION + 4] /= math.sqrt(np.sum(s[at.QUATERNION : at.QUATERNION + 4] ** 2))


@compiled
def felt(p: FloatArray, s: FloatArray, push: FloatArray, t: float) -> FloatArray:
    """(3,) what an accelerometer at the origin shows [m/s^2], body axes."""
    rate, v, w = rate_of(p, s, push, t), s[at.VELOCITY : at.VELOCITY + 3], s[at.RATE : at.RATE + 3]
    up = turned_back(s[at.QUATERNION : at.QUATERNION + 4], np.array([0.0, 0.0, at.GRAVITY]))
    return rate[at.VELOCITY : at.VELOCITY + 3] + cross(w, v) + up
