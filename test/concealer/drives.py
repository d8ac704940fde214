"""What thrusters, pump and battery make of commands."""

# mypy: disable-error-code="no-any-return"

from __future__ import annotations

import math

from concealer import layout as at
from concealer.compiled import compiled
from concealer.layout import FloatArray


@compiled
def shaped(p: FloatArray, command: FloatArray) -> float:
    """Thrust fraction of a steady command: dead zone with a ramp (Bessa et al. 2005) or with a jump behind it.

    What is beyond it may follow a square law in part.
    """
    size = abs(command)
    if size <= max(p[at.DEAD_CONTINUOUS], p[at.DEAD_JUMP]):
        return 0.0
    beyond = size - p[at.DEAD_CONTINUOUS]
    if p[at.THRUST_BEND] != 0.0:
        beyond *= 1.0 + p[at.THRUST_BEND] * (beyond - 1.0)
    return math.copysign(beyond, command)


@compiled
def stage_rates(p: FloatArray, s: FloatArray, command: FloatArray, rate: FloatArray) -> None:
    """Fills in the rates of the drives' states: two stages in series per thruster, one for the pump."""
    for place, value in ((at.LEFT_SLOW, command[0]), (at.RIGHT_SLOW, command[1])):
        if p[at.LAG_SLOW] > 0.0:
            rate[place] = (shaped(p, value) - s[place]) / p[at.LAG_SLOW]
            rate[place + 1] = (s[place] - s[place + 1]) / p[at.LAG_FAST]
        else:
            # Followed closely only so that a neighbour's wake has a level to read.
            rate[place] = (shaped(p, value) - s[place]) / 0.02
    if p[at.PUMP_LAG] > 0.0:
        rate[at.PUMP_STATE] = (s[at.PLAY] - s[at.PUMP_STATE]) / p[at.PUMP_LAG]
    rate[at.PUMP_SLEW] = (s[at.PLAY] - s[at.PUMP_SLEW]) / at.PUMP_SLEW_TIME


@compiled
def slowed(p: FloatArray, s: FloatArray, place: int) -> float:
    """Thrust fraction behind the lag of the thruster whose first stage is at `place`."""
    return s[place + 1] if p[at.LAG_SLOW] > 0.0 else s[place]


@compiled
def left_in_battery(p: FloatArray, charge: float) -> float:
    """Fraction of the thrust that is left: a discharge curve with a steep start, a plateau and a knee."""
    q = min(charge / p[at.DURATION], 1.0)
    return 1.0 - p[at.BATTERY] * (0.2 * (1.0 - math.exp(-12.0 * q)) + 0.65 * q + 0.15 * q**6)


@compiled
def charge_rate(command: FloatArray) -> float:
    """Discharge per second, 1 for the usual mixture of commands: electronics and motors."""
    return 0.7 + 0.3 * (abs(command[0]) + abs(command[1]))


@compiled
def lost_against(p: FloatArray, against: float) -> float:
    """Share of a thrust that water takes which comes against its jet at a speed [m/s]: most at the peak."""
    if against <= 0.0:
        return 0.0
    return p[at.CRASHBACK] * against / (1.0 + (against / p[at.CRASHBACK_PEAK]) ** 2)


@compiled
def one_thrust(p: FloatArray, s: FloatArray, level: float, gain: float, speed: float) -> float:
    """Force of one thruster [N] at a level (fraction) in water that comes at `speed`."""
    force = p[at.THRUST] * gain * level * left_in_battery(p, s[at.CHARGE])
    force *= 1.0 - p[at.BUBBLES] * (1.0 - math.tanh(-s[at.Z] / p[at.BUBBLES_REACH]))
    if level < 0.0:
        force *= 1.0 - p[at.REVERSE_LOSS]
    ahead = math.copysign(speed, speed * level)
    force *= 1.0 - lost_against(p, -ahead)
    return force * (1.0 - p[at.ADVANCE] * ahead * (1.0 + p[at.ADVANCE_CURVE] * abs(ahead)))


@compiled
def thrust(p: FloatArray, s: FloatArray, command: FloatArray, speed: float) -> tuple[float, float, float]:
    """Surge, sway [N] and yaw [N m] of both thrusters."""
    left, right = shaped(p, command[0]), shaped(p, command[1])
    if p[at.LAG_SLOW] > 0.0:
        left, right = s[at.LEFT_FAST], s[at.RIGHT_FAST]
    left = one_thrust(p, s, left, 1.0 - 0.5 * p[at.ASYMMETRY], speed)
    right = one_thrust(p, s, right, 1.0 + 0.5 * p[at.ASYMMETRY], speed)
    cos, sin = math.cos(p[at.MISALIGNMENT]), math.sin(p[at.MISALIGNMENT])
    both = left + right
    return both * cos, both * sin, p[at.LEVER] * cos * (right - left) + p[at.STERN] * sin * both + p[at.TORQUE_BIAS]


@compiled
def emerged(z: float) -> float:
    """Share of a spheroid of height TALL that is above the surface when its middle is at z [m]."""
    out = min(max(0.5 + z / at.TALL, 0.0), 1.0)
    return out * out * (3.0 - 2.0 * out)


@compiled
def buoyancy(p: FloatArray, s: FloatArray, t: float) -> float:
    """Force upward [N]: pump, trim, hull that gives way (Boyle) or comes out, denser water below, payload."""
    depth = -s[at.Z]
    pump = s[at.PUMP_STATE] if p[at.PUMP_LAG] > 0.0 else s[at.PLAY]
    force = p[at.PUMP] * pump + p[at.TRIM]
    force -= p[at.SHRINK] * depth / (1.0 + depth / p[at.SHRINK_SCALE])
    force += p[at.DENSER] * p[at.DENSER_SCALE] * (1.0 - math.exp(-depth / p[at.DENSER_SCALE]))
    force += 0.5 * p[at.LAYER_FORCE] * (1.0 + math.tanh((depth - p[at.LAYER_DEPTH]) / p[at.LAYER_WIDTH]))
    force -= p[at.EMERGE] * p[at.MASS] * at.GRAVITY * emerged(s[at.Z])
    since = (t - p[at.PAYLOAD_TIME]) / p[at.PAYLOAD_RISE]
    return force + p[at.PAYLOAD_FORCE] * min(max(since, 0.0), 1.0)
