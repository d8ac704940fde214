"""A recording as arrays: the robots' tracks, their readings and commands, and what made it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from cocorosim_ros.foundation.arrays import Floats, Integers
from cocorosim_ros.foundation.card import Card, Shown
from cocorosim_ros.foundation.data_frame import data_frame
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.foundation.output_file import check_file
from cocorosim_ros.foundation.read_only import read_only
from cocorosim_ros.library.shoal_statistics import ShoalStatistics, statistics_of
from cocorosim_ros.scenario.reading.arguments import Place, Time, nanoseconds, one_of, place_text, refused
from cocorosim_ros.scenario.scenario import Scenario
from cocorosim_ros.study.metrics.from_tracks import plan_samples
from cocorosim_ros.study.pictures.sketch import tracks_sketch
from cocorosim_ros.wire.bags.bag_reader import Bag, read_bag
from cocorosim_ros.wire.bags.kept_poses import keep_poses
from cocorosim_ros.wire.bags.readings import READABLE, TopicReadings, read_readings, readable_topics
from cocorosim_ros.wire.bags.tracks import RecordedTrack, is_pose, read_poses_and_source
from cocorosim_ros.wire.cdr.primitives import NANOSECONDS
from cocorosim_ros.wire.topics.topics import robot_topic, split_topic
from cocorosim_ros.world.checks.loading import parse_scenario
from cocorosim_ros.world.state.pose_track import Poses

if TYPE_CHECKING:
    import pandas as pd

MADE_FROM = "cocorosim"  # the record of a bag's metadata that says what made it


@dataclass(frozen=True, eq=False, repr=False)
class Recording(Shown):
    """What a recording holds of its robots. Its messages are read when something of them is asked for first."""

    bag: Bag
    """The open recording, for its raw messages."""

    @property
    def path(self) -> Path:
        """Where it lies."""
        return self.bag.path

    @property
    def damage(self) -> str:
        """What is missing or broken, in a sentence; empty if nothing is."""
        return self.bag.summary.damage

    @property
    def metadata(self) -> Mapping[str, str]:
        """What made it, as written: digest, seed, versions, the scenario's text; empty for recordings of others."""
        return self.bag.summary.metadata.get(MADE_FROM, {})

    @property
    def digest(self) -> str | None:
        """The digest that it was closed with; None where it has none."""
        return self.metadata.get("digest")

    @property
    def robots(self) -> tuple[str, ...]:
        """The namespaces of all robots that have topics of poses or readings, sorted.

        Messages are read for it only where there is no topic NAMESPACE/pose.
        """
        named = {split_topic(topic)[0] for topic in (*self._pose_topics(), *readable_topics(self.bag)[0])}
        return tuple(sorted(named if self._pose_topics() else named | self.tracks.keys()))

    @cached_property
    def tracks(self) -> Mapping[str, RecordedTrack]:
        """The poses of each robot by its namespace, each stamp once, sorted by stamp.

        Of a track: `stamp_ns` (n,) [ns], `time` (n,) [s] since its first pose, `position` (n, 3) [m; world], `yaw` (n,)
        [rad; world, -pi..pi], and how many poses were left out. Robots are the topics NAMESPACE/pose of type
        geometry_msgs/msg/PoseStamped; without any, topics of type nav_msgs/msg/Odometry, poses under other names, or
        frames that move in /tf, as `source_of_poses` says.
        """
        return {
            name: replace(
                track,
                stamp_ns=read_only(track.stamp_ns),
                position=read_only(track.position),
                yaw=read_only(track.yaw),
            )
            for name, track in self._poses[0].items()
        }

    @property
    def source_of_poses(self) -> str:
        """A sentence on where the poses are from if there is no topic NAMESPACE/pose; empty where there is."""
        return "" if self._pose_topics() else self._poses[1]

    @cached_property
    def poses(self) -> Mapping[str, Poses]:
        """The poses of `tracks` in little memory, for recordings of days: of each robot `stamp_ns` (n,) [ns].

        Position (k, 3) [m; world] and yaw (k,) [rad; world] of the poses `rows` (k,) are looked up by `at(rows)`; those
        of topics NAMESPACE/pose lie in a temporary file, unless `tracks` have been asked for.
        """
        in_memory = "_poses" in vars(self) or not self._pose_topics()
        return self.tracks if in_memory else keep_poses(self.bag)

    @cached_property
    def _poses(self) -> tuple[Mapping[str, RecordedTrack], str]:
        return read_poses_and_source(self.bag)

    @property
    def readings(self) -> Mapping[str, Mapping[str, TopicReadings]]:
        """By robot and topic what was measured and commanded, as it was recorded.

        Topics: compass, pressure, imu, velocity, blss, illuminance, concentration, thruster_command, actuator_feedback.
        Of each: `stamp_ns` (n,) [ns], `time` (n,) [s], `columns`, their `units`, and `values` (n, columns).
        """
        return self._readings[0]

    @cached_property
    def scenario(self) -> Scenario | None:
        """The scenario that the recording was made from; None where it tells none.

        Raises CocorosimError if this version cannot read it.
        """
        text = self.metadata.get("scenario")
        return None if text is None else parse_scenario(text, str(self.path))

    @property
    def findings(self) -> tuple[str, ...]:
        """Damage, a scenario or messages that cannot be read, topics of another type than the contract's; sentences."""
        from cocorosim_ros.graph.runs.results import readable_scenario

        remarks = (self.damage, self.source_of_poses, readable_scenario(self.bag)[1])
        return (*(remark for remark in remarks if remark), *self._readings[1])

    def measure(self, interval: Time | None = None) -> ShoalStatistics:
        """The shoaling statistics, as `cocorosim metrics` gives them.

        interval: measure every so often, such as '0.5 s' or 0.5 [s], by interpolation; left out, at the robots' own
        stamps if they share them, else at the median interval of their poses. Raises CocorosimError if the recording
        has no poses, or the interval is no time.
        """
        every = None if interval is None else nanoseconds(interval, "interval")
        tracks = self.poses
        if not any(track.stamp_ns.size for track in tracks.values()):
            from cocorosim_ros.graph.runs.results import no_poses

            raise CocorosimError(no_poses(self.bag, list(tracks)))
        found = [remark for remark in (self.damage, self.source_of_poses) if remark]
        return statistics_of(plan_samples(tracks, every), self.path.resolve().name, self.digest, found)

    def draw(self, out: Place, statistics: ShoalStatistics | None = None, *, force: bool = False) -> Path:
        """Draw tracks and statistics into a PNG file; returns its path.

        statistics: what `measure` gave, if it has been asked already. Raises CocorosimError if there are no poses, or
        if the file exists (without `force`) or cannot be written.
        """
        from cocorosim_ros.graph.runs.results import scenario_facts
        from cocorosim_ros.study.pictures.facts import MetricSeries
        from cocorosim_ros.study.pictures.shoal_picture import draw_shoal

        file = Path(place_text(out, "out"))
        if statistics is not None:
            one_of(statistics, "statistics", ShoalStatistics)
        check_file(file, force=force)
        measured = statistics or self.measure()
        series = MetricSeries(measured.stamp_ns, measured.series)
        draw_shoal(file, self.poses, series, scenario_facts(self.bag), force=True)
        return file

    def to_frame(self, topic: str = "pose") -> pd.DataFrame:
        """One row a message of `topic`: stamp_ns [ns], time [s], robot, then its columns in their units.

        topic: 'pose' (x, y, z [m], yaw [rad]; world) or one of `readings`. Rows of a robot that lacks a column have NaN
        there. Raises CocorosimError for a topic that is none of these.
        """
        if topic not in ("pose", *READABLE):
            raise refused(topic, "topic", f"which is no topic of numbers; choose from pose, {', '.join(READABLE)}")
        parts = [self._columns(robot, topic) for robot in self.robots]
        names = tuple(dict.fromkeys(name for _, columns in parts for name in columns))
        stamps = [stamp_ns for stamp_ns, _ in parts]
        robots = np.repeat(np.array(self.robots, dtype=object), [len(stamp_ns) for stamp_ns in stamps])
        missing = [np.full(len(stamp_ns), np.nan) for stamp_ns in stamps]
        all_stamps = np.concatenate([np.empty(0, np.int64), *stamps])
        rows = {
            name: np.concatenate(
                [np.empty(0), *(part[1].get(name, blank) for part, blank in zip(parts, missing, strict=True))]
            )
            for name in names
        }
        return data_frame({"stamp_ns": all_stamps, "time": all_stamps / NANOSECONDS, "robot": robots, **rows})

    def card(self) -> Card:
        """What the recording holds, robot by robot, as its own summary says; no message is read for it."""
        summary = self.bag.summary
        facts = {
            "robots": str(len(self.robots)),
            "messages": str(summary.message_count),
            "length": f"{(summary.end_ns - summary.start_ns) / NANOSECONDS:.3f} s",
            "digest": self.digest or "-",
        }
        topics, unread = readable_topics(self.bag)
        rows = []
        for robot in self.robots:
            names = [split_topic(topic)[1] for topic in topics if split_topic(topic)[0] == robot]
            rows.append((robot, str(summary.counts.get(robot_topic(robot, "pose"), 0)), ", ".join(names)))
        remarks = [*([self.damage] if self.damage else []), *unread]
        return Card(f"recording {self.path.name}", facts, ("robot", "poses", "readings"), rows, remarks)

    def sketch(self) -> str:
        """The ways of all robots from above, once their poses have been asked for; to look at it reads no message."""
        known = self.tracks if "_poses" in vars(self) else {}
        return tracks_sketch({name: track.position for name, track in known.items()})

    def _pose_topics(self) -> list[str]:
        return [each.topic for each in self.bag.summary.topics if is_pose(each.topic, each.type_name)]

    @cached_property
    def _readings(self) -> tuple[dict[str, dict[str, TopicReadings]], tuple[str, ...]]:
        read, findings = read_readings(self.bag)
        readings = {robot: {name: _fixed(each) for name, each in topics.items()} for robot, topics in read.items()}
        return readings, tuple(findings)

    def _columns(self, robot: str, topic: str) -> tuple[Integers, dict[str, Floats]]:
        """Stamps (n,) [ns] and columns (n,) of one topic of one robot."""
        if topic == "pose":
            track = self.tracks.get(robot)
            if track is None:
                return np.empty(0, np.int64), {}
            places = {name: track.position[:, place] for place, name in enumerate("xyz")}
            return track.stamp_ns, {**places, "yaw": track.yaw}
        found = self.readings.get(robot, {}).get(topic)
        if found is None:
            return np.empty(0, np.int64), {}
        return found.stamp_ns, {name: found.column(name) for name in found.columns}


def _fixed(readings: TopicReadings) -> TopicReadings:
    """The same readings, which cannot be written to."""
    return replace(readings, stamp_ns=read_only(readings.stamp_ns), values=read_only(readings.values))


def read_recording(path: Place) -> Recording:
    """Open a recording: a rosbag2 folder with MCAP files, one .mcap file, or the folder of a run.

    Damaged and unfinished ones are read as far as they go; `damage` says what is missing. Recordings of others in MCAP
    do as well, as far as their topics are those of the contract; `convert` brings in the rest.

    Returns a record whose messages are read when they are asked for. Raises CocorosimError if there is no recording at
    the path, or nothing of it can be read.

    Example: `read_recording("runs/demo").tracks["lily_01"].position` is (n, 3) [m; world].
    """
    return Recording(read_bag(Path(place_text(path, "path"))))
