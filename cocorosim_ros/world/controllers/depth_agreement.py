"""Robots agree on a depth by sound: each says its depth, and moves what it asks for towards every depth that it hears.

target <- target + gain (heard - target) for every message from within `reach`: consensus with the gain of one link.
Source: Olfati-Saber, Fax and Murray (2007), Consensus and Cooperation in Networked Multi-Agent Systems, equation (9).
"""

from __future__ import annotations

import math

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.world.controllers.controller import Controller
from cocorosim_ros.world.controllers.request import DIVE, DIVE_MODE, DIVE_TO_DEPTH, NOTES, SPEED, TURN_GAIN
from cocorosim_ros.world.state.observation import Observation
from cocorosim_ros.world.state.pressure import PASCAL_PER_METRE, SURFACE_PRESSURE
from cocorosim_ros.world.state.radio import MESSAGE_LENGTH
from cocorosim_ros.world.state.sound import RANGE

_TARGET, _HAS_TARGET = NOTES, NOTES + 1  # m of depth; 1 once it is set


@kernel
def depth_of(pressure: float) -> float:
    """Depth [m] by an absolute pressure [Pa] in fresh water."""
    return (pressure - SURFACE_PRESSURE) / PASCAL_PER_METRE


@kernel
def decide(observation: Observation, sensor_axis: Floats, settings: Floats, request: Floats) -> None:
    """Ask for the depth that robots within `reach` [m] agree on, ahead at `speed`; at first for the own depth."""
    speed, gain, reach, turn_gain = settings[0], settings[1], settings[2], settings[3]
    if request[_HAS_TARGET] == 0.0 and math.isfinite(observation.pressure):
        request[_TARGET], request[_HAS_TARGET] = depth_of(observation.pressure), 1.0
    if request[_HAS_TARGET] == 1.0:
        for index in range(observation.sound_count):
            heard = observation.sound[index]
            if heard[MESSAGE_LENGTH] == 1.0 and heard[RANGE] <= reach:
                request[_TARGET] += gain * (heard[1] - request[_TARGET])
        request[DIVE_MODE], request[DIVE] = DIVE_TO_DEPTH, request[_TARGET]
    request[SPEED], request[TURN_GAIN] = speed, turn_gain


@kernel
def speak(observation: Observation, settings: Floats, message: Floats) -> None:
    """Say the own depth [m]; nothing while it is not known."""
    known = math.isfinite(observation.pressure)
    message[MESSAGE_LENGTH] = 1.0 if known else 0.0
    message[1] = depth_of(observation.pressure) if known else 0.0


DEPTH_AGREEMENT = Controller(
    summary="agreement on a depth by sound",
    settings=("speed", "gain", "reach", "turn_gain"),
    decide=decide,
    speak=speak,
    payload_length=1,
    medium="acoustic",
    needs=("acoustic_rx",),
)
