"""What was measured of Lily, and what the paper made of it: Read et al. 2013, section 4."""

from __future__ import annotations

import math

THRUST = 0.01  # N, both thrusters, 1 g lifted by each and rounded
MASS = 0.44  # kg
TERMINAL_SPEED = 0.075  # m/s, measured at full thrust
START_DISTANCE = 0.1  # m, from rest at full thrust ...
START_TIME = 3.03  # s, ... measured
TERMINAL_YAW_RATE = 1.48  # rad/s, measured at full torque
QUARTER_TURNS = (2.4, 3.7, 4.8, 5.9)  # s, measured: 90, 180, 270 and 360 degrees from rest at full torque
LEVER = 0.055 * math.cos(math.radians(63.0))  # m, of each thruster
TORQUE = THRUST * LEVER  # N m
NEUTRAL_VOLUME = 440e-6  # m^3
LARGEST_VOLUME = 450e-6  # m^3
WATER_DENSITY = 1000.0  # kg/m^3
GRAVITY = 9.81  # m/s^2
# What the paper concludes.
PRINTED_AREA_DRAG = 1.78  # "A * Cd", without unit
PRINTED_YAW_DRAG = 0.000114
PRINTED_INERTIA = 0.0005
PRINTED_PUMP_FORCE = 0.1  # N
