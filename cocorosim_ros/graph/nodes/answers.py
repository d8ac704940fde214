"""The ear of the physics node: one robot's commands and radio messages, checked as they come in."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
from rclpy.node import Node

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.graph.nodes.wiring import Listener
from cocorosim_ros.wire.cdr.radio_messages import RadioMessage, read_message
from cocorosim_ros.wire.cdr.stamps import stamp_ns
from cocorosim_ros.wire.topics.body import BodyDescription
from cocorosim_ros.wire.topics.command_check import CommandReader
from cocorosim_ros.wire.topics.topics import ROBOT_TOPICS, robot_topic
from cocorosim_ros.world.state.radio import PAYLOAD_LIMIT

COMMAND = ROBOT_TOPICS["thruster_command"]


class Answers:
    """What the controller of one robot sends."""

    def __init__(self, node: Node, body: BodyDescription, complain: Callable[[str, str], None]) -> None:
        """`complain(robot, sentence)` is called for every unusable message."""
        self._body = body
        self._complain = complain
        self._reader = CommandReader(body)
        self.commands = Listener(node, COMMAND.type_name, robot_topic(body.name, COMMAND.name), COMMAND.quality)
        self.radio: Listener | None = None
        if body.talk:
            talk = ROBOT_TOPICS[body.talk]
            self.radio = Listener(node, talk.type_name, robot_topic(body.name, talk.name), talk.quality)

    def take_command(self) -> tuple[int, np.ndarray[tuple[int], np.dtype[np.float64]]] | None:
        """Stamp [ns] and fractions (actuators,) of the next command; None if there is none."""
        data = self.commands.take()
        if data is None:
            return None
        fractions, complaint = self._reader.read(data)
        if complaint:
            self._complain(self._body.name, complaint)
        return stamp_ns(COMMAND.type_name, data) or 0, fractions

    def take_radio(self) -> RadioMessage | None:
        """The next usable radio message; None if there is none. Others are complained of and skipped."""
        while self.radio is not None and (data := self.radio.take()) is not None:
            try:
                message = read_message(data)
            except CocorosimError as error:
                self._complain(self._body.name, f"its radio message is not sent: {error}")
                continue
            if len(message.payload) > PAYLOAD_LIMIT:
                self._complain(self._body.name, f"its radio messages are not sent: at most {PAYLOAD_LIMIT} numbers fit")
            elif not all(map(math.isfinite, message.payload)):
                self._complain(self._body.name, "its radio message is not sent: it holds numbers that are not finite")
            else:
                return message
        return None

    def listeners(self) -> list[Listener]:
        """What to wait for when this robot's answer is missing."""
        return [self.commands] if self.radio is None else [self.commands, self.radio]
