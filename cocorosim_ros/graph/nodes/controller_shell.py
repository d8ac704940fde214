"""The controller node's doings: gather one robot's readings, decide, answer."""

from __future__ import annotations

import time
from dataclasses import replace

import numpy as np
from rclpy.node import Node

from cocorosim_ros.graph.nodes.complaints import tell_on_terminal
from cocorosim_ros.graph.nodes.wiring import Listener, Speaker
from cocorosim_ros.graph.runs.run_error import RunError
from cocorosim_ros.scenario.parts.controller_choice import AnyController
from cocorosim_ros.scenario.scenario import RobotDescription
from cocorosim_ros.wire.cdr.stamps import stamp_ns
from cocorosim_ros.wire.topics.body import describe_body
from cocorosim_ros.wire.topics.observations import AnswerEncoder, ObservationDecoder
from cocorosim_ros.wire.topics.topics import ROBOT_TOPICS, robot_topic
from cocorosim_ros.world.controllers.conduct import blank_memory, conduct_one
from cocorosim_ros.world.controllers.crew_assembly import build_crew
from cocorosim_ros.world.controllers.plain.faults import ControllerError
from cocorosim_ros.world.controllers.plain.plain_controller import PlainController, plain_of
from cocorosim_ros.world.controllers.request import REQUEST_SIZE
from cocorosim_ros.world.state.radio import HEARING_LIMIT, MESSAGE_SIZE

SILENCE = 5.0  # s of waiting without a word


class ControllerShell:
    """One robot's controller on its topics."""

    def __init__(self, node: Node, robot: RobotDescription, seed: int = 0) -> None:
        """`seed` is that of the run. Raises CocorosimError; RunError if a plain Python controller cannot be made."""
        self.body = describe_body(robot)
        self._robot, self._seed = robot, seed
        self._crew = build_crew([robot])
        self._command = np.zeros(len(self.body.actuators))
        self._said = np.zeros(MESSAGE_SIZE)
        self._decoder = ObservationDecoder(self.body, HEARING_LIMIT)
        self._encoder = AnswerEncoder(self.body)
        self._listeners = {
            name: Listener(
                node,
                ROBOT_TOPICS[name].type_name,
                robot_topic(self.body.name, name),
                ROBOT_TOPICS[name].quality,
            )
            for name in self.body.topics
        }
        self._speakers = {
            name: Speaker(
                node,
                ROBOT_TOPICS[name].type_name,
                robot_topic(self.body.name, name),
                ROBOT_TOPICS[name].quality,
            )
            for name in self.body.answers
        }
        self._latest: dict[str, bytes] = {}
        self._stamps: dict[str, int] = dict.fromkeys(self.body.topics, -1)
        self.stop = False
        self._begin_anew()

    def _begin_anew(self) -> None:
        """Remember nothing, as before the first answer."""
        self._plain = plain_controller(self._robot, self._seed)
        self._memory = blank_memory(1, 1)[0, 0]
        self._answered = -1  # [ns]

    def use(self, controller: AnyController) -> None:
        """Decide by these settings from the next answer on; what the behaviour remembers stays."""
        self._crew = build_crew([replace(self._robot, controller=controller)])

    def wait_until_heard(self, listeners: int) -> None:
        """Return when every publisher has that many subscriptions, or when told to stop."""
        start, told = time.monotonic(), False
        while not self.stop and any(speaker.subscribers < listeners for speaker in self._speakers.values()):
            if not told and time.monotonic() - start > SILENCE:
                told = True
                tell_on_terminal(f"{self.body.name}: nobody, or not everybody, hears its commands yet; waiting")
            time.sleep(0.005)

    def take(self) -> None:
        """Take everything that has come in; of each topic the newest is kept."""
        for name, listener in self._listeners.items():
            while (data := listener.take()) is not None:
                self._latest[name] = data
                self._stamps[name] = stamp_ns(listener.type_name, data) or 0

    def answer_what_came(self) -> bool:
        """Take everything that has come in, and answer if it makes a set complete; True if it did."""
        self.take()
        return self.answer_complete_set()

    def answer_complete_set(self) -> bool:
        """Answer if all topics show one and the same moment that is not answered yet; True if it did.

        A moment before the last one is that of a simulation that has begun anew: what was remembered is forgotten.
        """
        stamps = set(self._stamps.values())
        if len(stamps) != 1 or (stamp := stamps.pop()) == self._answered or stamp < 0:
            return False
        if stamp < self._answered:
            self._begin_anew()
        self._answered = stamp
        self.answer(stamp, stamp * 1e-9)
        return True

    def awaited(self) -> Listener:
        """The topic to wait for: one that is behind the newest, or that which is published last."""
        newest = max(self._stamps.values())
        behind = (name for name, stamp in self._stamps.items() if stamp < newest)
        return self._listeners[next(behind, self.body.topics[-1])]

    def forget_stale(self, oldest_ns: int) -> list[str]:
        """Drop what was measured before `oldest_ns`; return the topics that show nothing now."""
        for name, stamp in self._stamps.items():
            if stamp < oldest_ns:
                self._latest.pop(name, None)
        return [name for name in self.body.topics if name not in self._latest]

    def answer(self, stamp: int, moment: float) -> None:
        """Run one control cycle on the latest readings and publish command and message, stamped `stamp` [ns].

        Raises RunError if a plain Python controller fails.
        """
        observation = self._decoder.observation(moment, self._latest)
        if self._plain is not None:
            try:
                self._plain.ask(observation, self._memory[:REQUEST_SIZE], self._said)
            except ControllerError as error:
                raise RunError(str(error)) from error
        conduct_one(self._crew, 0, observation, self._memory, self._command, self._said)
        if self.body.speaks:
            self._speakers[self.body.talk].publish(self._encoder.said(stamp, self._said))
        self._speakers["thruster_command"].publish(self._encoder.command(stamp, self._command))


def plain_controller(robot: RobotDescription, seed: int) -> PlainController | None:
    """The robot's controller if it is one in plain Python. Raises CocorosimError, or RunError if it cannot be made."""
    named = plain_of(robot)
    if named is None:
        return None
    try:
        return PlainController(robot, named, seed)
    except ControllerError as error:
        raise RunError(str(error)) from error
