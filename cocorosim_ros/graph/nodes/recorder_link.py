"""How the recorder tells the physics node how far it is, so that nothing is ever lost.

DDS keeps only so many messages for a reader that is behind; in lock-step the physics node therefore never runs
more ticks ahead of the recorder than fit. The topic is hidden (its name begins with an underscore) and is not
recorded.
"""

from __future__ import annotations

from rclpy.node import Node

from cocorosim_ros.graph.nodes.wiring import Listener, Speaker
from cocorosim_ros.graph.runs.run_record import MADE_BY_RECORDER
from cocorosim_ros.wire.cdr.primitives import ENCAPSULATION, Reader, pack_counter
from cocorosim_ros.wire.topics.service_quality import STREAM
from cocorosim_ros.wire.topics.topics import TOPICS

TOPIC, TYPE = "/_cocorosim/recorded", "std_msgs/msg/UInt64"
RECORDED_AHEAD = 40  # ticks; well below the depth of the topics


class RecorderEar:
    """The physics node's side."""

    def __init__(self, node: Node) -> None:
        self.listener = Listener(node, TYPE, TOPIC, STREAM)
        self._recorded: int | None = None

    def recorded(self) -> int:
        """How many whole ticks are in the recording."""
        while (data := self.listener.take()) is not None:
            self._recorded = Reader(data).counter()
        return self._recorded or 0

    def is_ready(self) -> bool:
        """Whether the recorder has said that it is connected to all topics."""
        self.recorded()
        return self._recorded is not None


class RecorderMouth:
    """The recorder's side."""

    def __init__(self, node: Node) -> None:
        self._speaker = Speaker(node, TYPE, TOPIC, STREAM)

    def say(self, ticks: int) -> None:
        """Tell how many whole ticks are in the recording; zero: connected and ready."""
        self._speaker.publish(ENCAPSULATION + pack_counter(ticks))

    @property
    def is_heard(self) -> bool:
        """Whether a physics node listens."""
        return self._speaker.subscribers > 0


def speakers_of_recorder(node: Node) -> dict[str, Speaker]:
    """What the recorder publishes of its own: statistics, and markers of what moves."""
    rows = {topic: TOPICS[topic] for topic in MADE_BY_RECORDER}
    return {topic: Speaker(node, row.type_name, topic, row.quality) for topic, row in rows.items()}
