"""What the ROV is made of: places in one vector of numbers, and the values of a BlueROV2 Heavy as published.

Numbers: Wu, "6-DoF modelling and control of a remotely operated vehicle", Flinders University 2018 (mass, buoyancy,
added mass, drag); places of the thrusters from the manufacturer's drawing. Ballast puts buoyancy 4 cm above the mass,
so that it stays upright in all of its programmes. A gauge shows 9810 Pa per metre, as the contract says. Axes: body
forward-left-up, world east-north-up. All units SI.
"""

from __future__ import annotations

import math

import numpy as np

from concealer.layout import FloatArray

GRAVITY, RHO, SURFACE_PRESSURE = 9.81, 1000.0, 101325.0
STEP, STEPS_PER_TICK, STEPS_PER_ROW = 0.005, 20, 1  # s; commands change every 0.1 s, and forces jump with them
TICK, ROW_TIME = STEP * STEPS_PER_TICK, STEP * STEPS_PER_ROW

# --- state: position, quaternion (w, x, y, z), velocity and turn rate in body axes, thrust level of each thruster
X, Y, Z, QUATERNION, VELOCITY, RATE, LEVEL = 0, 1, 2, 3, 7, 10, 13
STATE = LEVEL + 8
ROW = STATE + 3  # and the specific force of an accelerometer at the origin [m/s^2]

# --- numbers; mass and inertia with what is added along each axis
MASS, INERTIA, LINEAR, QUADRATIC = 0, 3, 6, 12
(LIFT, RIGHTING, THRUST, SPIN_UP, DURATION) = range(18, 23)
(LAG, DEAD, REVERSE, BATTERY, TETHER, TETHER_X, TETHER_Y, LOAD_TIME, LOAD_FORCE) = range(23, 32)
(SWING, SWING_YAW, SWING_OMEGA, SWING_PHASE) = range(32, 36)
(CABLE, CABLE_X, CABLE_Y, CABLE_BOW) = range(36, 40)
(SIDE_LEVER, SIDE_UNEVEN) = range(40, 42)
SIZE = 42

CABLE_WIDTH = 0.0076  # m, of the manufacturer's tether

FULL_THRUST = 113.0  # N, four thrusters at 45 degrees
FULL_TORQUE = 30.2  # N m

_H = math.sqrt(0.5)
PLACES = np.array([
    [0.156, -0.111, 0.005], [0.156, 0.111, 0.005], [-0.156, -0.111, 0.005], [-0.156, 0.111, 0.005],
    [0.12, -0.218, 0.0], [0.12, 0.218, 0.0], [-0.12, -0.218, 0.0], [-0.12, 0.218, 0.0],
])  # fmt: skip
DIRECTIONS = np.array([
    [_H, _H, 0.0], [_H, -_H, 0.0], [_H, -_H, 0.0], [_H, _H, 0.0],
    [0.0, 0.0, 1.0], [0.0, 0.0, 1.0], [0.0, 0.0, 1.0], [0.0, 0.0, 1.0],
])  # fmt: skip
NAMES = [
    "front_right", "front_left", "rear_right", "rear_left",
    "up_front_right", "up_front_left", "up_rear_right", "up_rear_left",
]  # fmt: skip
# Levels of the thrusters (8,) for a demand of 1 in surge, sway, heave, yaw.
ALLOCATION = np.array([
    [1.0, 1.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.0], [1.0, -1.0, -1.0, 1.0, 0.0, 0.0, 0.0, 0.0],
    [0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0], [1.0, -1.0, 1.0, -1.0, 0.0, 0.0, 0.0, 0.0],
])  # fmt: skip


def nominal() -> FloatArray:
    """(SIZE,) the vehicle as its platform file has it."""
    p = np.zeros(SIZE)
    p[MASS : MASS + 3] = 11.5 + np.array([5.5, 12.7, 14.57])
    p[INERTIA : INERTIA + 3] = 0.16 + 0.12
    p[LINEAR : LINEAR + 6] = 4.03, 6.22, 5.18, 0.07, 0.07, 0.07
    p[QUADRATIC : QUADRATIC + 6] = 18.18, 21.66, 36.99, 1.55, 1.55, 1.55
    p[LIFT], p[RIGHTING], p[THRUST] = 2.0, 0.04 * 114.8, 40.0
    p[DURATION] = 300.0
    return p
