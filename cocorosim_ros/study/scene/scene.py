"""What is to be seen of one recording: bodies, what they see, hear and do, shoals, water, metrics."""

from __future__ import annotations

from dataclasses import dataclass

from cocorosim_ros.foundation.arrays import Floats, Integers
from cocorosim_ros.scenario.parts.platform import Platform
from cocorosim_ros.scenario.parts.vehicle_parts import Vector3
from cocorosim_ros.study.pictures.facts import MetricSeries, ScenarioFacts
from cocorosim_ros.wire.bags.readings import TopicReadings
from cocorosim_ros.world.state.pose_track import PoseTrack


@dataclass(frozen=True)
class SceneRobot:
    """One robot; None where the recording does not tell."""

    name: str
    track: PoseTrack
    platform: Platform | None
    """Hull, thrusters and cones; of recordings that know their scenario."""
    commands: TopicReadings | None
    """Fractions of the actuators' maxima, a column for each."""
    sight: TopicReadings | None
    """Ranges [m] of the blue-light sensors, columns SENSOR.neighbour_range and SENSOR.obstacle_range."""


@dataclass(frozen=True)
class Hearing:
    """Who hears whom: at each moment the robots that have heard another since their last inbox."""

    stamp_ns: Integers
    """(t,) moments of delivery [ns]."""
    count: Integers
    """(t,) how many of the links below belong to each moment."""
    links: Floats
    """(links, 2, 3) where the sender and the listener are [m; world]."""


@dataclass(frozen=True)
class ShoalMembers:
    """Which robots belong together at each moment."""

    stamp_ns: Integers
    """(t,) moments [ns]."""
    shoal: Integers
    """(t, n) number of the first robot of the robot's shoal in alphabetical order, -1 for absent robots."""


@dataclass(frozen=True)
class MovingWater:
    """The velocity of the water on a grid of places."""

    stamp_ns: Integers
    """(t,) moments [ns]."""
    place: Floats
    """(p, 3) [m; world]."""
    velocity: Floats
    """(t, p, 3) [m/s; world]."""


@dataclass(frozen=True)
class DriftingPlume:
    """A source and the puffs that it has released, moment after moment."""

    source: Vector3
    """[m; world]."""
    stamp_ns: Integers
    """(t,) moments [ns]."""
    count: Integers
    """(t,) puffs at each moment."""
    centre: Floats
    """(all puffs of all moments, 3) [m; world]."""
    narrowness: Floats
    """(the same) standard deviation of a new puff as a share of its own."""


@dataclass(frozen=True)
class Scene:
    """One recording; robots in alphabetical order."""

    facts: ScenarioFacts
    start_ns: int
    """Stamp of the first pose of all robots, from which the time line counts [ns]."""
    robots: tuple[SceneRobot, ...]
    hearing: Hearing
    shoals: ShoalMembers
    metrics: MetricSeries
    water: MovingWater | None
    """None where no current is known; forces on patches are no velocities, and no recording holds them."""
    plume: DriftingPlume | None
    findings: tuple[str, ...]
