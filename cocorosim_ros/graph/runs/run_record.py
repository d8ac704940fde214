"""Writes a run into a bag, tick by tick, and measures the shoal as it goes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, Literal

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.graph.runs.scenery import SWARM, Scenery
from cocorosim_ros.study.metrics import METRICS
from cocorosim_ros.study.metrics.shoal_monitor import ShoalMonitor
from cocorosim_ros.wire.bags.bag_writer import BagWriter, Channel
from cocorosim_ros.wire.bags.tracks import decode_poses
from cocorosim_ros.wire.cdr import type_store
from cocorosim_ros.wire.cdr.packed import PackedMessage
from cocorosim_ros.wire.live.viewers import Viewers
from cocorosim_ros.wire.topics.body import BodyDescription
from cocorosim_ros.wire.topics.topics import TOPICS, robot_topic

STATISTICS_TOPIC = "/shoal_statistics"
STATUS_TOPIC = "/diagnostics"
MADE_BY_RECORDER = (STATISTICS_TOPIC, SWARM)
ANSWERS = (
    "thruster_command",
    "radio_tx",
    "blue_light_tx",
    "acoustic_tx",
)  # what controllers publish; the rest is from the bodies
Selection = Literal["all"] | tuple[str, ...]  # topics to record: their names in the table of topics, or in full


def run_topics(bodies: Sequence[BodyDescription]) -> dict[str, str]:
    """Every topic of a run and the row of the topics table that it belongs to, in the order of recording."""
    topics = {"/clock": "/clock", "/tf": "/tf"}
    for body in bodies:
        talk = ("thruster_command", body.talk) if body.talk else ("thruster_command",)
        for name in ("pose", *body.topics, *talk):
            topics[robot_topic(body.name, name)] = name
    return {**topics, STATISTICS_TOPIC: STATISTICS_TOPIC, STATUS_TOPIC: STATUS_TOPIC}


def owed_topics(bodies: Sequence[BodyDescription]) -> set[str]:
    """The topics that have a message at every tick of a lock-step run, beside the statistics."""
    owed = {robot_topic(body.name, name) for body in bodies for name in ("pose", *body.topics, *body.answers)}
    return owed | {"/clock", "/tf"}


def selected_topics(topics: Mapping[str, str], selection: Selection) -> dict[str, str]:
    """Those of `topics` (see run_topics) that `selection` names.

    Raises CocorosimError for a name that fits none of them, and if no poses are left to measure.
    """
    if selection == "all":
        return dict(topics)
    known = {*topics, *topics.values()}
    for name in selection:
        if name not in known:
            raise CocorosimError(
                f"The scenario's 'recording.topics' has '{name}', which is no topic of this run; give 'all', or names "
                f"out of {', '.join(dict.fromkeys(topics.values()))}."
            )
    chosen = {topic: row for topic, row in topics.items() if topic in selection or row in selection}
    if {topic for topic, row in topics.items() if row == "pose"} - chosen.keys():
        raise CocorosimError(
            "The scenario's 'recording.topics' has no poses, which statistics and picture are made from; add 'pose'."
        )
    return chosen


def statistics_message() -> PackedMessage:
    """`/shoal_statistics`: one value per metric of the table."""
    values = {
        "name": list(METRICS),
        "unit": [metric.unit for metric in METRICS.values()],
        "value": [0.0] * len(METRICS),
    }
    template = type_store.build("cocorosim_msgs/msg/ShoalStatistics", values)
    return PackedMessage([template], [f"value[{name}]" for name in METRICS])


class RunRecord:
    """The bag and the statistics of one run. Not for several threads at once."""

    def __init__(
        self,
        folder: Path,
        bodies: Sequence[BodyDescription],
        metadata: Mapping[str, str],
        *,
        selection: Selection = "all",
        scenery: Scenery | None = None,
        force: bool = False,
    ) -> None:
        """`selection`: which topics are recorded; `scenery`: what is drawn for viewers.

        Raises CocorosimError if the folder exists or cannot be written.
        """
        self.topics = run_topics(bodies)
        self.owed = owed_topics(bodies)
        self.monitor = ShoalMonitor(len(bodies))
        # In the order of the names, as in the statistics of a finished recording.
        self.pose_topics = [robot_topic(name, "pose") for name in sorted(body.name for body in bodies)]
        self._statistics = statistics_message()
        self._begun = False
        self._scenery = scenery
        everything = {**self.topics, **(scenery.topics if scenery else {})}
        self._selected = selected_topics(everything, selection)
        self._offered = everything
        self._viewers: list[Viewers] = []
        rows = {topic: TOPICS[row] for topic, row in self._selected.items()}
        channels = [Channel(topic, row.type_name, row.quality) for topic, row in rows.items()]
        self.writer = BagWriter(folder, channels, metadata=metadata, force=force)

    def show_to(self, viewers: Viewers) -> None:
        """Send them every message from now on, also of topics that are not recorded."""
        self._viewers.append(viewers)
        for topic, row in self._offered.items():
            viewers.add(topic, TOPICS[row].type_name)

    def write_tick(self, stamp_ns: int, messages: Mapping[str, bytes]) -> dict[str, bytes]:
        """Record the messages of one tick, and what is made of them; return the latter, by topic.

        Messages are written in the order of the topics, whatever the order in which they came.
        """
        self._begin(stamp_ns)
        write = self.writer.write
        for topic in self._selected:
            if topic in messages:
                write(topic, stamp_ns, stamp_ns, messages[topic])
        for viewers in self._viewers:
            for topic, data in messages.items():
                viewers.send(topic, stamp_ns, data)
        return self.measure(stamp_ns, [messages[topic] for topic in self.pose_topics], messages)

    def write(self, topic: str, stamp_ns: int, data: bytes) -> None:
        """Record one message, if its topic is to be recorded."""
        self._begin(stamp_ns)
        if topic in self._selected:
            self.writer.write(topic, stamp_ns, stamp_ns, data)
        for viewers in self._viewers:
            latched = self._scenery is not None and topic in self._scenery.standing
            viewers.send(topic, stamp_ns, data, latched=latched)

    def measure(self, stamp_ns: int, poses: Sequence[bytes | None], messages: Mapping[str, bytes]) -> dict[str, bytes]:
        """Record what is made of the poses of all robots at one moment, and return it by topic.

        poses: None for a robot that is absent. messages: others of that moment, of which commands are drawn.
        """
        position, yaw = decode_poses([pose or b"" for pose in poses])
        values = self.monitor.update(stamp_ns, position, yaw, [pose is not None for pose in poses])
        made = {STATISTICS_TOPIC: self._statistics.encode(stamp_ns, values[None])[0]}
        markers = None if self._scenery is None else self._scenery.swarm(stamp_ns, position, yaw, messages)
        if markers is not None:
            made[SWARM] = markers
        for topic, data in made.items():
            self.write(topic, stamp_ns, data)
        return made

    def _begin(self, stamp_ns: int) -> None:
        """Record what holds during the whole run, before anything else."""
        if self._begun:
            return
        self._begun = True
        for topic, data in self._scenery.standing.items() if self._scenery else ():
            self.write(topic, stamp_ns, data)

    def close(self, extra: Mapping[str, str] | None = None) -> str:
        """Complete the bag; return its digest."""
        return self.writer.close(extra)

    def summary(self) -> dict[str, Any]:
        """The statistics of the whole run, ready for JSON."""
        return self.monitor.summary()
