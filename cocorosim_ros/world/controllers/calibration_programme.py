"""The programme of a calibration run: straight ahead and back, turns on the spot, pump steps, with rests between.

The robot starts at rest and commands its actuators directly: first left thruster, second right thruster, third
pump. A phase lasts `straight_time`, `turn_time` or `pump_time`, each is followed by `rest_time` with all actuators
off, and after the last phase all stay off. What the phases show: speed gained from rest and terminal speed (thrust
and drag over mass), yaw rate gained and terminal yaw rate (yaw inertia and yaw drag), rise and sink (pump and trim).
Source: the measurements of Read et al. 2013, section 4.
"""

from __future__ import annotations

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.controllers.controller import Controller
from cocorosim_ros.world.controllers.functions import set_actuator
from cocorosim_ros.world.state.observation import Observation

SETTINGS = ("straight_time", "turn_time", "pump_time", "rest_time", "thrust", "turn_thrust", "pump")
STRAIGHT_TIME, TURN_TIME, PUMP_TIME, REST_TIME = 0, 1, 2, 3
THRUST, TURN_THRUST, PUMP = 4, 5, 6
# Per phase: which time it lasts, which amplitude it has, and the signs of left, right, pump.
PHASES = np.array(
    [
        [STRAIGHT_TIME, THRUST, 1.0, 1.0, 0.0],
        [STRAIGHT_TIME, THRUST, -1.0, -1.0, 0.0],
        [TURN_TIME, TURN_THRUST, -1.0, 1.0, 0.0],
        [TURN_TIME, TURN_THRUST, 1.0, -1.0, 0.0],
        [PUMP_TIME, PUMP, 0.0, 0.0, -1.0],
        [PUMP_TIME, PUMP, 0.0, 0.0, 1.0],
    ]
)
CLOCK_TOLERANCE = 1e-6  # s


@kernel
def decide(observation: Observation, sensor_axis: Floats, settings: Floats, request: Floats) -> None:
    """Ask for the actuators of the phase that the time belongs to."""
    elapsed = observation.time + CLOCK_TOLERANCE
    for actuator in range(3):
        set_actuator(request, actuator, 0.0)
    for phase in range(PHASES.shape[0]):
        lasts, amplitude = settings[int(PHASES[phase, 0])], settings[int(PHASES[phase, 1])]
        if 0.0 <= elapsed < lasts:
            for actuator in range(3):
                set_actuator(request, actuator, amplitude * PHASES[phase, 2 + actuator])
        elapsed -= lasts + settings[REST_TIME]


CALIBRATION_PROGRAMME = Controller(
    summary="straight runs, turns and pump steps for calibration",
    settings=SETTINGS,
    decide=decide,
)
