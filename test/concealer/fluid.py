"""What the water does to a hull: how it moves, how it resists, and the oddities that no catalogue has."""

# mypy: disable-error-code="no-any-return"

from __future__ import annotations

import math

import numpy as np

from concealer import layout as at
from concealer.compiled import compiled
from concealer.layout import FloatArray

# Five Gauss-Legendre points on (-1, 1): the hull is cut into strips across its length.
STRIP_PLACE = np.array([-0.9061798459386640, -0.5384693101056831, 0.0, 0.5384693101056831, 0.9061798459386640])
STRIP_SHARE = 0.5 * np.array(
    [0.2369268850561891, 0.4786286704993665, 0.5688888888888889, 0.4786286704993665, 0.2369268850561891]
)

AIR = 1.225  # kg/m^3
GUST = 0.2  # of the wind, by which it swings


@compiled
def swell(p: FloatArray, s: FloatArray, t: float) -> tuple[float, float]:
    """Velocity of the water under waves, along their way and upwards [m/s]: Stokes, to second order, above the floor.

    The wave number is that of the dispersion relation omega^2 = g k tanh(k h), by Newton's method.
    """
    speed, omega, h = p[at.SWELL], p[at.SWELL_OMEGA], -p[at.FLOOR]
    if speed == 0.0:
        return 0.0, 0.0
    k = omega * omega / 9.81
    for _ in range(30):
        bent = math.tanh(k * h)
        k -= (9.81 * k * bent - omega * omega) / (9.81 * (bent + k * h * (1.0 - bent * bent)))
    angle = p[at.SWELL_DIRECTION]
    theta = k * (math.cos(angle) * s[at.X] + math.sin(angle) * s[at.Y]) - omega * t + p[at.SWELL_PHASE]
    up = k * (s[at.Z] + h)
    height, sharp = speed * math.tanh(k * h) / omega, math.sinh(k * h)  # `speed` is the water's at the surface
    first, second = height * omega / sharp, 0.75 * height * height * omega * k / sharp**4
    along = first * math.cosh(up) * math.cos(theta) + second * math.cosh(2.0 * up) * math.cos(2.0 * theta)
    return along, first * math.sinh(up) * math.sin(theta) + second * math.sinh(2.0 * up) * math.sin(2.0 * theta)


@compiled
def current(p: FloatArray, s: FloatArray, t: float) -> tuple[float, float]:
    """World velocity of the water [m/s]: steady, sheared (tanh profile), tidal, waves, one vortex (Lamb-Oseen)."""
    width, depth = p[at.SHEAR_WIDTH], p[at.SHEAR_DEPTH]
    tide = math.sin(2.0 * math.pi * t / p[at.TIDE_PERIOD] + p[at.TIDE_PHASE])
    down = depth * math.tanh(s[at.Z] / depth)
    east = p[at.CURRENT_X] + p[at.SHEAR_XY] * width * math.tanh(s[at.Y] / width) + p[at.SHEAR_XZ] * down
    north = p[at.CURRENT_Y] + p[at.SHEAR_YX] * width * math.tanh(s[at.X] / width) + p[at.SHEAR_YZ] * down
    east += p[at.TIDE_X] * tide
    north += p[at.TIDE_Y] * tide
    along, _ = swell(p, s, t)
    east += along * math.cos(p[at.SWELL_DIRECTION])
    north += along * math.sin(p[at.SWELL_DIRECTION])
    if p[at.VORTEX] != 0.0:
        dx, dy = s[at.X] - p[at.VORTEX_X], s[at.Y] - p[at.VORTEX_Y]
        square = dx * dx + dy * dy + 1e-9
        swirl = p[at.VORTEX] * (1.0 - math.exp(-square / p[at.VORTEX_CORE] ** 2)) / (2.0 * math.pi * square)
        east -= swirl * dy
        north += swirl * dx
    return east, north


@compiled
def nearness(p: FloatArray, s: FloatArray) -> float:
    """Added fraction of drag by the nearest wall, floor or surface at h: gain (1 + h/scale)^-power."""
    if p[at.WALL_GAIN] == 0.0:
        return 0.0
    h = min(p[at.HALF_X] - abs(s[at.X]), p[at.HALF_Y] - abs(s[at.Y]))
    h = max(min(h, -s[at.Z], s[at.Z] - p[at.FLOOR]), 0.0)
    return p[at.WALL_GAIN] * (1.0 + h / p[at.WALL_SCALE]) ** -p[at.WALL_POWER]


@compiled
def strips(v: float, r: float, length: float) -> tuple[float, float]:
    """Mean of |v + x r|(v + x r), and of x times that, along the hull (Hoerner's cross-flow principle)."""
    force, moment = 0.0, 0.0
    for k in range(STRIP_PLACE.size):
        x = 0.5 * length * STRIP_PLACE[k]
        flow = v + x * r
        force += STRIP_SHARE[k] * abs(flow) * flow
        moment += STRIP_SHARE[k] * x * abs(flow) * flow
    return force, moment


@compiled
def resist(p: FloatArray, s: FloatArray, u: float, v: float, w: float) -> FloatArray:
    """(4,) surge, sway, heave [N] and yaw [N m] of the drag at speeds u, v, w through the water."""
    r, k = s[at.R], p[at.DRAG]
    more = 1.0 + nearness(p, s)
    common = -k * more * math.sqrt(u * u + v * v + w * w)
    out = np.zeros(4)
    out[0] = common * u - p[at.LINEAR_SURGE] * u
    out[1] = common * v - p[at.LINEAR_SWAY] * v
    out[2] = common * w - p[at.LINEAR_HEAVE] * w - p[at.CROSS_HEAVE] * k * more * abs(w) * w
    out[3] = -more * p[at.YAW_DRAG] * abs(r) * r - p[at.LINEAR_YAW] * r
    if p[at.CROSS_SWAY] != 0.0:
        force, moment = strips(v, r, p[at.STRIP_LENGTH])
        # Turning on the spot is in the yaw drag already.
        moment -= strips(0.0, r, p[at.STRIP_LENGTH])[1]
        out[1] -= p[at.CROSS_SWAY] * k * more * force
        out[3] -= p[at.CROSS_SWAY] * k * more * moment
    return out


@compiled
def wind(p: FloatArray, s: FloatArray, t: float) -> tuple[float, float, float]:
    """Surge, sway [N] and yaw [N m] of gusts on what stands above the water; yaw by the sine of twice the angle.

    Coefficients 0.7 ahead and 0.85 to the side; Fossen, Handbook of Marine Craft Hydrodynamics (2011), section 8.1.
    """
    if p[at.WIND] == 0.0:
        return 0.0, 0.0, 0.0
    speed = p[at.WIND] * (1.0 + GUST * math.sin(p[at.GUST_OMEGA] * t + p[at.GUST_PHASE]))
    angle = p[at.WIND_DIRECTION] - s[at.YAW]
    ahead, aside = speed * math.cos(angle) - s[at.U], speed * math.sin(angle) - s[at.V]
    size = math.sqrt(ahead * ahead + aside * aside)
    pressed = 0.5 * AIR * size
    turn = p[at.WIND_TURN] * at.ABOVE_SIDE * pressed * 2.0 * ahead * aside / max(size, 1e-9)
    return 0.7 * at.ABOVE_FRONT * pressed * ahead, 0.85 * at.ABOVE_SIDE * pressed * aside, turn


@compiled
def tether(p: FloatArray, s: FloatArray) -> tuple[float, float]:
    """World force towards the tether's end, which yields a little when it is far [N]."""
    dx, dy = p[at.TETHER_X] - s[at.X], p[at.TETHER_Y] - s[at.Y]
    pull = p[at.TETHER] / math.sqrt(1.0 + (dx * dx + dy * dy) / p[at.TETHER_SOFT] ** 2)
    return pull * dx, pull * dy


@compiled
def oddities(p: FloatArray, s: FloatArray, u: float, t: float) -> FloatArray:
    """(6,) surge, sway, heave [N], yaw [N m], world x, world y [N]: tether, wind, what no catalogue has."""
    out = np.zeros(6)
    wave = math.sin(p[at.OSC_OMEGA] * t + p[at.OSC_PHASE])
    rate = (s[at.PLAY] - s[at.PUMP_SLEW]) / at.PUMP_SLEW_TIME
    r = s[at.R]
    out[0] = -p[at.POWER_THREE_HALVES] * math.sqrt(abs(u)) * u - p[at.CUBIC] * u**3 + p[at.RATE_SURGE] * rate
    out[1] = p[at.ROLL_SWAY] * r * abs(r)
    out[2] = p[at.LIFT] * u * u + p[at.RATE_HEAVE] * rate + p[at.OSC_Z] * wave
    out[3] = p[at.OSC_YAW] * wave + p[at.TORQUE_AT_X] * s[at.X] + p[at.TORQUE_AT_Y] * s[at.Y]
    out[3] += p[at.RATE_YAW] * rate + p[at.FIN] * abs(u) * u + p[at.VANE] * math.sin(s[at.YAW])
    out[3] += p[at.PUMP_YAW] * s[at.PLAY] - p[at.FRICTION_YAW] * math.tanh(r / p[at.FRICTION_RATE])
    blown = wind(p, s, t)
    out[0] += blown[0]
    out[1] += blown[1]
    out[3] += blown[2]
    east, north = tether(p, s)
    out[4] = east + p[at.OSC_X] * wave
    out[5] = north + p[at.OSC_Y] * wave
    return out
