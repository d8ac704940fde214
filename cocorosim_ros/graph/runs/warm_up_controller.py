"""The part of a warm-up that a controller node does, on a real robot too; it knows no simulator."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from cocorosim_ros.foundation.compiling.once import compile_once
from cocorosim_ros.scenario.scenario import RobotDescription
from cocorosim_ros.wire.cdr.radio_messages import RadioEncoder
from cocorosim_ros.wire.topics.body import describe_body
from cocorosim_ros.wire.topics.observations import ObservationDecoder
from cocorosim_ros.world.controllers.conduct import blank_memory, conduct_one
from cocorosim_ros.world.controllers.crew_assembly import build_crew
from cocorosim_ros.world.state.radio import HEARING_LIMIT, MESSAGE_SIZE

Tell = Callable[[str], None]


def nobody(sentence: str) -> None:
    """Tell nobody."""


def compile_controller(robot: RobotDescription, tell: Tell = nobody) -> None:
    """All that a controller node calls; every behaviour is one and the same function."""
    compile_once("controllers", "", lambda: _answer(robot), tell)


def _answer(robot: RobotDescription) -> None:
    """One decision of a controller by itself, which has heard nothing in its inbox."""
    body = describe_body(robot)
    inbox = {"radio_rx": RadioEncoder().inbox(0, body.frame, [])}
    blank = ObservationDecoder(body, HEARING_LIMIT).observation(0.0, inbox)
    command = np.zeros(len(robot.platform.actuators))
    conduct_one(build_crew([robot]), 0, blank, blank_memory(1, 1)[0, 0], command, np.zeros(MESSAGE_SIZE))
