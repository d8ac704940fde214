"""A scene from a recording."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from cocorosim_ros.scenario.scenario import Scenario
from cocorosim_ros.study.metrics.from_tracks import measure_samples, sample_tracks
from cocorosim_ros.study.metrics.sampling import SampledTracks
from cocorosim_ros.study.metrics.shoal_members import shoal_members
from cocorosim_ros.study.pictures.facts import MetricSeries, ScenarioFacts
from cocorosim_ros.study.scene.drifting_plume import drifting_plume
from cocorosim_ros.study.scene.hearing import read_hearing
from cocorosim_ros.study.scene.moving_water import moving_water
from cocorosim_ros.study.scene.scene import Scene, SceneRobot, ShoalMembers
from cocorosim_ros.wire.bags.bag_reader import Bag
from cocorosim_ros.wire.bags.readings import TopicReadings, read_readings
from cocorosim_ros.world.state.pose_track import PoseTrack


def gather_scene(
    bag: Bag, tracks: Mapping[str, PoseTrack], facts: ScenarioFacts, scenario: Scenario | None = None
) -> Scene:
    """All that is to be seen of a recording.

    tracks: its poses, of one robot at least. scenario: what it was made from, if it tells. Raises CocorosimError if no
    robot has a usable pose.
    """
    seen = {name: track for name, track in sorted(tracks.items()) if track.stamp_ns.size}
    samples = sample_tracks(seen)
    readings, unread = read_readings(bag)
    platforms = {} if scenario is None else {robot.name: robot.platform for robot in scenario.robots}
    robots = tuple(
        SceneRobot(name, track, platforms.get(name), *_shown(readings.get(name, {}))) for name, track in seen.items()
    )
    damage = (bag.summary.damage,) if bag.summary.damage else ()
    return Scene(
        facts,
        min(int(track.stamp_ns[0]) for track in seen.values()),
        robots,
        read_hearing(bag, seen),
        ShoalMembers(samples.stamp_ns, shoal_members(samples)),
        _measured(samples),
        moving_water(scenario, samples.stamp_ns),
        drifting_plume(scenario, samples.stamp_ns),
        (*damage, *unread, *samples.findings),
    )


def _shown(readings: Mapping[str, TopicReadings]) -> tuple[TopicReadings | None, TopicReadings | None]:
    """What is drawn of a robot's readings: commands and ranges."""
    return _sorted(readings.get("thruster_command")), _sorted(readings.get("blss"))


def _sorted(readings: TopicReadings | None) -> TopicReadings | None:
    """The same messages by their stamps."""
    if readings is None or not readings.stamp_ns.size:
        return None
    order = np.argsort(readings.stamp_ns, kind="stable")
    return TopicReadings(
        readings.robot,
        readings.topic,
        readings.stamp_ns[order],
        readings.columns,
        readings.units,
        readings.values[order],
        readings.unreadable,
    )


def _measured(samples: SampledTracks) -> MetricSeries:
    monitor = measure_samples(samples)
    return MetricSeries(monitor.stamps_ns, monitor.series)
