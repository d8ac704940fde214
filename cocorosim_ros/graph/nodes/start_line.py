"""Who must be there before the first tick, so that nobody misses a message."""

from __future__ import annotations

import time
from collections.abc import Mapping, Sequence

from rclpy.node import Node

from cocorosim_ros.graph.nodes.answers import Answers
from cocorosim_ros.graph.nodes.greeting import Greeting
from cocorosim_ros.graph.nodes.recorder_link import RecorderEar
from cocorosim_ros.graph.nodes.wiring import Speaker
from cocorosim_ros.graph.runs.run_error import RunError
from cocorosim_ros.scenario.scenario import Scenario
from cocorosim_ros.wire.topics.body import BodyDescription
from cocorosim_ros.wire.topics.topics import robot_topic

# s of wall clock during which the ears of external controllers must not change any more
SETTLING = 0.3  # of those that have answered a greeting, and so are heard
UNASKED = 3.0  # of those that have not: a node may have no services, or never look at them


class StartLine:
    """Looks at who is connected to the physics node.

    Our own controllers must hear all topics of their robot, and the recorder must have said that it hears
    everything. How much an external controller wants to hear is its own business: it must be able to command, hear
    something of its robot, and not be about to hear more. That its commands come here is known once it has answered
    a greeting; where it answers none, more time has to do.
    """

    def __init__(
        self,
        node: Node,
        scenario: Scenario,
        bodies: Sequence[BodyDescription],
        speakers: Mapping[str, Speaker],
        answers: Sequence[Answers],
        recorder: RecorderEar | None,
    ) -> None:
        self._speakers = speakers
        self._answers = answers
        self._recorder = recorder
        self._bodies = bodies
        self._external = [robot for robot, described in enumerate(scenario.robots) if described.external]
        self._greetings = [Greeting(node, answers[robot].commands) for robot in self._external]
        self._ears: tuple[int, ...] = ()
        self._ears_since = 0.0

    def everybody_is_there(self, dead: Sequence[int]) -> bool:
        """Whether the run can start; `dead`: robots whose controller will not come.

        Raises RunError if a robot has two controllers.
        """
        if self._recorder is not None and not self._recorder.is_ready():
            return False
        self.refuse_second_controllers()
        living = [robot for robot in range(len(self._bodies)) if robot not in dead]
        return all(self._is_connected(robot) for robot in living) and self._have_settled()

    def absent(self) -> list[int]:
        """The robots that nobody commands."""
        return [robot for robot, answers in enumerate(self._answers) if answers.commands.publishers == 0]

    def refuse_second_controllers(self) -> None:
        """Raise RunError if a robot has more than one controller."""
        for body, answers in zip(self._bodies, self._answers, strict=True):
            count = answers.commands.publishers
            if count > 1:
                raise RunError(f"{body.name} has {count} controllers, so the run ends; start only one, and run again.")

    def _is_connected(self, robot: int) -> bool:
        if self._answers[robot].commands.publishers == 0:
            return False
        pose = self._speakers[robot_topic(self._bodies[robot].name, "pose")]
        if self._recorder is not None and pose.subscribers == 0:
            return False
        wanted = 1 if self._recorder is None else 2
        heard = [speaker.subscribers >= wanted for speaker in self._ears_of(robot)]
        return any(heard) if robot in self._external else all(heard)

    def _ears_of(self, robot: int) -> list[Speaker]:
        body = self._bodies[robot]
        return [self._speakers[robot_topic(body.name, name)] for name in body.topics]

    def _have_settled(self) -> bool:
        if not self._external:
            return True
        ears = tuple(speaker.subscribers for robot in self._external for speaker in self._ears_of(robot))
        if ears != self._ears:
            self._ears, self._ears_since = ears, time.monotonic()
        answered = [greeting.is_answered() for greeting in self._greetings]
        return time.monotonic() - self._ears_since >= (SETTLING if all(answered) else UNASKED)
