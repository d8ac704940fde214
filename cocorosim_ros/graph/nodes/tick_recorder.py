"""The recorder of lock-step runs: writes whole ticks, in order, and measures the shoal at each."""

from __future__ import annotations

import time
from collections.abc import Iterable, Sequence

from rclpy.node import Node

from cocorosim_ros.graph.nodes.answers import COMMAND
from cocorosim_ros.graph.nodes.recorder_link import RecorderMouth, speakers_of_recorder
from cocorosim_ros.graph.nodes.wiring import Listener
from cocorosim_ros.graph.runs.run_record import ANSWERS, STATISTICS_TOPIC, STATUS_TOPIC, RunRecord
from cocorosim_ros.wire.cdr.stamps import stamp_ns
from cocorosim_ros.wire.cdr.status import RUN, read_status, robot_status
from cocorosim_ros.wire.topics.topics import TOPICS, robot_topic, split_topic

MISSING = "missing"  # key of the status that names the robots without an answer
PATIENCE = 5.0  # s of wall clock that controllers get to appear when all else is there


class TickRecorder:
    """Gathers the messages of every tick until the tick is whole, then writes it.

    A tick is whole when every topic that owes it a message has one of its stamp, less the answers that the physics
    node has declared missing. An external controller owes nothing: whether its messages come with their tick, after
    it or with stamps of their own, they are written as they come.
    """

    def __init__(self, nodes: Sequence[Node], record: RunRecord, external: Iterable[str] = ()) -> None:
        """`nodes`: the first speaks, all of them listen. `external`: robots that somebody else controls."""
        self.record = record
        self.ticks = 0
        self.announced: int | None = None  # ticks of the whole run, once the physics node has said so
        self._mouth = RecorderMouth(nodes[0])
        self._speakers = speakers_of_recorder(nodes[0])
        heard = {topic: TOPICS[row] for topic, row in record.topics.items() if topic != STATISTICS_TOPIC}
        self._listeners = {}
        for place, (topic, row) in enumerate(heard.items()):
            node = nodes[place * len(nodes) // len(heard)]
            name = topic if node is nodes[0] else nodes[0].resolve_topic_name(topic)  # whose remappings hold for all
            self._listeners[topic] = Listener(node, row.type_name, name, row.quality)
        self.clock = self._listeners["/clock"]
        self._owed = record.owed - {robot_topic(robot, answer) for robot in external for answer in ANSWERS}
        self._commands = {robot_topic(robot, COMMAND.name) for robot in external} & self._listeners.keys()
        self._unheard: dict[str, set[int]] = {topic: set() for topic in sorted(self._commands)}  # stamps of ticks [ns]
        self._pending: dict[int, dict[str, bytes]] = {}
        self._excused: dict[int, set[str]] = {}
        self._newest_tick = -1
        self._last_written = -1
        self._last_words: tuple[int, bytes] | None = None
        self._said_ready = False
        self._bodies_since: float | None = None

    def announce_when_connected(self) -> bool:
        """Tell the physics node, once, that all topics that somebody owes have their publisher; True once told.

        Controllers may fail to come: they are waited for no longer than PATIENCE.
        """
        if not self._said_ready and self._mouth.is_heard:
            absent = {topic for topic in {*self._owed, STATUS_TOPIC} if not self._listeners[topic].publishers}
            if all(split_topic(topic)[1] in ANSWERS for topic in absent):
                self._bodies_since = self._bodies_since or time.monotonic()
                self._said_ready = not absent or time.monotonic() - self._bodies_since > PATIENCE
            if self._said_ready:
                self._mouth.say(0)
        return self._said_ready

    def drain(self) -> bool:
        """Take everything that has come in and write the ticks that are whole; False if there was nothing."""
        taken = 0
        for topic, listener in self._listeners.items():
            while (data := listener.take()) is not None:
                taken += 1
                self._keep(topic, listener.type_name, data)
        if taken:
            self._write_whole_ticks()
        return taken > 0

    @property
    def is_complete(self) -> bool:
        """Whether the run has ended and all its ticks are written."""
        return self.announced is not None and self.ticks >= self.announced

    def unheard_commands(self) -> dict[str, int]:
        """How many answers of each external robot counted for the physics node and have not come here.

        DDS brings a publisher that joins late to one listener before the other.
        """
        return {split_topic(topic)[0]: len(stamps) for topic, stamps in self._unheard.items() if stamps}

    def write_rest(self) -> None:
        """Write what belongs to no whole tick, without statistics, and last how the run has ended."""
        for robot, count in self.unheard_commands().items():
            words = f"{count} of the commands that it obeyed are not in the recording"
            self.record.write(STATUS_TOPIC, self._last_written, robot_status(self._last_written, robot, words))
        for stamp in sorted(self._pending):
            for topic, data in self._pending[stamp].items():
                self.record.write(topic, stamp, data)
        self._pending.clear()
        if self._last_words is not None:
            self.record.write(STATUS_TOPIC, *self._last_words)
            self._last_words = None

    def _keep(self, topic: str, type_name: str, data: bytes) -> None:
        stamp = max(0, stamp_ns(type_name, data) or 0)  # a recording knows no times before zero
        if stamp == 0 and topic in self._commands and not self._may_answer_the_first_tick(topic):
            self._unheard.pop(topic, None)  # which tick it has answered is not known
            self.record.write(topic, self._newest_tick, data)
        elif topic == STATUS_TOPIC:
            self._read_status(stamp, data)
        elif stamp <= self._last_written or topic in self._pending.get(stamp, ()):
            self.record.write(topic, stamp, data)  # its tick is written, or has a message of this topic already
            self._unheard.get(topic, set()).discard(stamp)
        else:
            self._pending.setdefault(stamp, {})[topic] = data
            if topic == "/clock":
                self._newest_tick = stamp

    def _may_answer_the_first_tick(self, topic: str) -> bool:
        """Whether a command stamped zero may be meant for tick zero; a command without a stamp reads the same.

        The recorder may be some ticks behind: what the physics node has heard at tick zero may come here later.
        """
        if self._newest_tick <= 0:
            return True
        if self._last_written < 0:
            return topic not in self._pending.get(0, ()) and topic not in self._excused.get(0, ())
        return 0 in self._unheard.get(topic, ())

    def _read_status(self, stamp: int, data: bytes) -> None:
        subject, _, values = read_status(data)
        if subject == RUN:
            self.announced = int(values["ticks"])
            self._last_words = stamp, data  # written last, whenever it comes: the file depends on the scenario alone
            return
        for name in values.get(MISSING, "").split():
            self._excused.setdefault(stamp, set()).update(robot_topic(name, answer) for answer in ANSWERS)
            self._unheard.get(robot_topic(name, COMMAND.name), set()).discard(stamp)
        self.record.write(STATUS_TOPIC, stamp, data)

    def _write_whole_ticks(self) -> None:
        before = self.ticks
        for stamp in sorted(self._pending):
            messages = self._pending[stamp]
            if "/clock" not in messages and stamp < self._newest_tick:  # no tick has this stamp
                for topic, data in self._pending.pop(stamp).items():
                    self.record.write(topic, stamp, data)
                continue
            if self._owed - messages.keys() - self._excused.get(stamp, set()):
                break
            excused = self._excused.pop(stamp, set())
            for topic in self._unheard.keys() - messages.keys() - excused:
                self._unheard[topic].add(stamp)
            for topic, data in self.record.write_tick(stamp, self._pending.pop(stamp)).items():
                self._speakers[topic].publish(data)
            self._last_written = stamp
            self.ticks += 1
        if self.ticks != before:
            self._mouth.say(self.ticks)
