"""Places in the one vector of numbers of a vehicle with six degrees of freedom, and in its state.

A gauge shows 9810 Pa per metre, as the contract says. Axes: body forward-left-up, world east-north-up. All units SI.
"""

from __future__ import annotations

GRAVITY, RHO, SURFACE_PRESSURE = 9.81, 1000.0, 101325.0
STEP, STEPS_PER_TICK, STEPS_PER_ROW = 0.005, 20, 1  # s; commands change every 0.1 s, and forces jump with them
TICK, ROW_TIME = STEP * STEPS_PER_TICK, STEP * STEPS_PER_ROW
MOST = 8  # thrusters

# --- state: position, quaternion (w, x, y, z), velocity and turn rate in body axes, thrust level of each thruster
X, Y, Z, QUATERNION, VELOCITY, RATE, LEVEL = 0, 1, 2, 3, 7, 10, 13
STATE = LEVEL + MOST
ROW = STATE + 3  # and the specific force of an accelerometer at the origin [m/s^2]

# --- numbers; mass and inertia with what is added along each axis
MASS, INERTIA, LINEAR, QUADRATIC = 0, 3, 6, 12
(LIFT, RIGHTING, THRUST, SPIN_UP, DURATION) = range(18, 23)
(LAG, DEAD, REVERSE, BATTERY, TETHER, TETHER_X, TETHER_Y, LOAD_TIME, LOAD_FORCE) = range(23, 32)
(SWING, SWING_YAW, SWING_OMEGA, SWING_PHASE) = range(32, 36)
(CABLE, CABLE_X, CABLE_Y, CABLE_BOW) = range(36, 40)
(SIDE_LEVER, SIDE_UNEVEN) = range(40, 42)
(HULL_LIFT, HULL_CENTRE, HULL_STALL) = range(42, 45)  # kg/m, m ahead of the origin, 1
(WASH, PROPELLER) = range(45, 47)  # 1, m
COUNT = 47  # of thrusters
# --- numbers of the pilot
(REACH, HOME, HEADING, TURN, DEPTH, CLIMB, MOST_HEAVE) = range(48, 55)

PLACES = 55  # of thrusters, three numbers each
DIRECTIONS = PLACES + 3 * MOST
ALLOCATION = DIRECTIONS + 3 * MOST  # levels of all for a demand of 1 in surge, sway, heave, yaw; of one over another
DEMANDS = 5
SIZE = ALLOCATION + DEMANDS * MOST

CABLE_WIDTH = 0.0076  # m, of the tether that ROVs of this size have
