"""What a robot and its water are made of: places in one vector of numbers, and Lily's nominal values.

All units are SI, axes as in the interface: world east-north-up, body forward-left-up, yaw counter-clockwise.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]

# --- places in the vector of one robot
(
    MASS, INERTIA, DRAG, YAW_DRAG, THRUST, LEVER, STERN, PUMP, DURATION, HALF_X, HALF_Y, FLOOR,
    # hydrodynamics
    LINEAR_SURGE, LINEAR_SWAY, LINEAR_HEAVE, LINEAR_YAW, CROSS_SWAY, CROSS_HEAVE, STRIP_LENGTH,
    ADDED_SURGE, ADDED_SWAY, ADDED_HEAVE, ADDED_YAW, WALL_GAIN, WALL_SCALE, WALL_POWER, WAKE,
    # water that moves
    CURRENT_X, CURRENT_Y, SHEAR_XY, SHEAR_XZ, SHEAR_YX, SHEAR_YZ, SHEAR_WIDTH, SHEAR_DEPTH,
    TIDE_X, TIDE_Y, TIDE_PERIOD, TIDE_PHASE, VORTEX, VORTEX_X, VORTEX_Y, VORTEX_CORE,
    # actuators
    LAG_SLOW, LAG_FAST, DEAD_CONTINUOUS, DEAD_JUMP, ASYMMETRY, TORQUE_BIAS, REVERSE_LOSS, ADVANCE, ADVANCE_CURVE,
    BATTERY, MISALIGNMENT, PUMP_LAG, PUMP_PLAY,
    # vertical
    TRIM, SHRINK, SHRINK_SCALE, LAYER_DEPTH, LAYER_FORCE, LAYER_WIDTH, PAYLOAD_TIME, PAYLOAD_FORCE, PAYLOAD_RISE,
    # place
    TETHER, TETHER_X, TETHER_Y, TETHER_SOFT,
    # outside every catalogue
    OSC_X, OSC_Y, OSC_Z, OSC_YAW, OSC_OMEGA, OSC_PHASE, TORQUE_AT_X, TORQUE_AT_Y, FRICTION_YAW, FRICTION_RATE,
    POWER_THREE_HALVES, CUBIC, RATE_SURGE, RATE_HEAVE, RATE_YAW, FIN, LIFT, VANE, PUMP_YAW, ROLL_SWAY,
    # later: water that grows denser, thrust lost near the surface
    DENSER, DENSER_SCALE, BUBBLES, BUBBLES_REACH,
    # still later: waves on the surface
    SWELL, SWELL_OMEGA, SWELL_DIRECTION, SWELL_PHASE,
    # then: what stands above the water, which wind pushes and which loses its buoyancy
    WIND, WIND_DIRECTION, GUST_OMEGA, GUST_PHASE, WIND_TURN, EMERGE,
    # last: thrust lost against the motion
    CRASHBACK, CRASHBACK_PEAK,
    # and a centre of mass off the origin
    CENTRE_AHEAD, CENTRE_LEFT, CENTRE_SHIFT,
    # and thrust that is a square law in part
    THRUST_BEND,
) = range(109)  # fmt: skip
SIZE = 109

# --- places in the state of one robot
(X, Y, Z, YAW, U, V, W, R, LEFT_SLOW, LEFT_FAST, RIGHT_SLOW, RIGHT_FAST, PUMP_STATE, PUMP_SLEW, CHARGE, PLAY) = range(
    16
)
FORMED = 3  # laws with a form of their own that a robot may have (forms.py); the state remembers each on four axes
MEMORY = 16
STATE = MEMORY + 4 * FORMED
ACCEL = STATE  # three more columns in a trajectory: specific force without gravity [m/s^2]
THROUGH_U, THROUGH_V = STATE + 3, STATE + 4  # and two: speeds through the water [m/s]
ROW = STATE + 5

STEP = 0.005  # s
STEPS_PER_TICK = 20  # commands change every 0.1 s
STEPS_PER_ROW = 4  # the trajectory is kept every 0.02 s
TICK = STEP * STEPS_PER_TICK
ROW_TIME = STEP * STEPS_PER_ROW

RHO = 1000.0
GRAVITY = 9.81
SURFACE_PRESSURE = 101325.0

FULL_THRUST = 0.01  # N, both thrusters
FULL_TORQUE = 0.01 * 0.055 * math.cos(math.radians(63.0))  # N m, one forward and one backward
FULL_PUMP = RHO * GRAVITY * 10e-6  # N
TOP_SPEED = 0.075  # m/s
# Of a Lily with a mast, where wind or a hull that leaves the water is asked for; its platform file has to say so.
ABOVE_FRONT, ABOVE_SIDE, TALL = 0.005, 0.009, 0.7  # m^2, m^2, m
PUMP_SLEW_TIME = 0.5  # s, over which the rate of the pump is measured


def nominal_robot() -> FloatArray:
    """(SIZE,) Lily by the interface, nothing hidden, in a tank of 5 m x 5 m x 2 m."""
    p = np.zeros(SIZE)
    p[MASS], p[INERTIA], p[DRAG], p[YAW_DRAG] = 0.44, 4.05e-4, 1.7778, 1.140e-4
    p[THRUST], p[PUMP] = 0.005, FULL_PUMP
    p[LEVER] = 0.055 * math.cos(math.radians(63.0))
    p[STERN] = -0.055 * math.sin(math.radians(63.0))
    p[DURATION], p[HALF_X], p[HALF_Y], p[FLOOR] = 600.0, 2.5, 2.5, -2.0
    # Scales that divide: harmless while what they scale is zero.
    for place in (STRIP_LENGTH, WALL_SCALE, WALL_POWER, SHEAR_WIDTH, SHEAR_DEPTH, TIDE_PERIOD, VORTEX_CORE):
        p[place] = 1.0
    for place in (
        SHRINK_SCALE,
        DENSER_SCALE,
        BUBBLES_REACH,
        LAYER_WIDTH,
        PAYLOAD_RISE,
        TETHER_SOFT,
        OSC_OMEGA,
        FRICTION_RATE,
        SWELL_OMEGA,
        CRASHBACK_PEAK,
    ):
        p[place] = 1.0
    return p
