"""The recorder of everything that is not in lock-step: free-running simulations, replays, real robots.

Writes every message as it arrives and measures the shoal as soon as all robots have shown themselves at a moment
(see runs.pose_moments).
"""

from __future__ import annotations

import time

from rclpy.node import Node

from cocorosim_ros.graph.nodes.answers import COMMAND
from cocorosim_ros.graph.nodes.recorder_link import speakers_of_recorder
from cocorosim_ros.graph.nodes.wiring import Listener
from cocorosim_ros.graph.runs.pose_moments import Moment, PoseMoments
from cocorosim_ros.graph.runs.run_record import STATISTICS_TOPIC, STATUS_TOPIC, RunRecord
from cocorosim_ros.wire.cdr.stamps import stamp_ns
from cocorosim_ros.wire.cdr.status import RUN, read_status
from cocorosim_ros.wire.topics.topics import TOPICS


class ArrivalRecorder:
    """Writes and measures what it hears, for as long as it is told to.

    Its own statistics are the only ones that it records: those that a replay publishes are not listened to.
    """

    def __init__(self, node: Node, record: RunRecord, *, period: float) -> None:
        """`period` [s]: how often poses whose stamps do not coincide are measured."""
        self.record = record
        self.announced: int | None = None  # ticks of the whole run, once its last status has come
        self._node = node
        self._speakers = speakers_of_recorder(node)
        self._commands: dict[str, bytes] = {}
        self._listeners = {
            topic: Listener(node, TOPICS[row].type_name, topic, TOPICS[row].quality, keep_all=True)
            for topic, row in record.topics.items()
            if topic != STATISTICS_TOPIC
        }
        self.clock = self._listeners["/clock"]
        self._robots = {topic: index for index, topic in enumerate(record.pose_topics)}
        self._moments = PoseMoments(len(self._robots), int(period * 1e9))
        self._told_of_late_poses = False
        self._newest = 0  # [ns] of all stamps so far

    def connected(self) -> bool:
        """Whether every robot's pose has a publisher."""
        return all(self._listeners[topic].publishers for topic in self._robots)

    def drain(self) -> bool:
        """Take and write everything that has come in; False if there was nothing."""
        taken = 0
        for topic, listener in self._listeners.items():
            while (data := listener.take()) is not None:
                taken += 1
                self._keep(topic, listener.type_name, data)
        self._measure(self._moments.take(time.monotonic()))
        return taken > 0

    def finish(self) -> None:
        """Measure what is left; robots that have fallen silent are not waited for any more."""
        self.drain()
        self._measure(self._moments.take(float("inf")))

    def _keep(self, topic: str, type_name: str, data: bytes) -> None:
        stamp = stamp_ns(type_name, data)
        moment = max(0, time.time_ns() if stamp is None else stamp)  # a recording knows no times before zero
        if type_name == COMMAND.type_name and moment == 0:
            moment = self._newest  # without a stamp, as `ros2 topic pub` sends it
        self._newest = max(self._newest, moment)
        self.record.write(topic, moment, data)
        if topic == STATUS_TOPIC:
            subject, _, values = read_status(data)
            if subject == RUN:
                self.announced = int(values["ticks"])
        elif topic in self._robots:
            self._moments.add(self._robots[topic], moment, data, time.monotonic())
        elif type_name == COMMAND.type_name:
            self._commands[topic] = data

    def _measure(self, moments: list[Moment]) -> None:
        for moment, poses in moments:
            for topic, data in self.record.measure(moment, poses, self._commands).items():
                self._speakers[topic].publish(data)
        if self._moments.late and not self._told_of_late_poses:
            self._told_of_late_poses = True
            self._node.get_logger().warning(
                "poses come with stamps that were measured already (a replay in a loop, or poses that are late): "
                "they are recorded, and left out of the statistics"
            )
