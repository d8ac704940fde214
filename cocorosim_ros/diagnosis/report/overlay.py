"""The findings on the recording's own clock, as a bag that opens beside it: ghosts, residual forces, evidence.

Of each robot, under its own name:

    by_platform/pose      free runs of the platform's model through the parts that no fit saw: a ghost
    by_model/pose         the same of the model that was found
    by_model/velocity     its velocity through the water on these free runs, u, v, w [m/s] and r [rad/s], body axes
    by_model/ground_velocity   the same over ground, where the model's water moves
    smoothed/velocity     through the water, over the whole recording: what the found model makes of all readings
    smoothed/ground_velocity   the same over ground, where the model's water moves
    residual_force        force that the recalibrated model lacks, in the axes of the body [N, N m]
    residual_force_left   the same of the model that was found
    evidence              gathered for the model that was found, over the recalibrated one [nats]

and of all of them /markers/residuals: these forces as arrows in the world.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any, NamedTuple, TypeVar

import numpy as np

from cocorosim_ros.diagnosis.criteria.report import OVERLAY
from cocorosim_ros.diagnosis.findings import (
    BodyVelocity,
    Clock,
    CourseVelocity,
    Diagnosis,
    FreeRun,
    GatheredEvidence,
    ResidualForce,
)
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.wire.bags.bag_writer import BagWriter, Channel
from cocorosim_ros.wire.cdr.packed import PackedMessage
from cocorosim_ros.wire.cdr.primitives import NANOSECONDS
from cocorosim_ros.wire.cdr.type_store import build
from cocorosim_ros.wire.topics.robot_parts import BODY
from cocorosim_ros.wire.topics.swarm_messages import WORLD_FRAME
from cocorosim_ros.world.sensors.ground_velocity import GROUND_VELOCITY
from cocorosim_ros.world.sensors.velocity import VELOCITY

POSE, WRENCH = "geometry_msgs/msg/PoseStamped", "geometry_msgs/msg/WrenchStamped"
TWIST = VELOCITY.message
NUMBER, ARROWS = "std_msgs/msg/Float64", "visualization_msgs/msg/MarkerArray"
BY_PLATFORM, BY_MODEL = "by_platform/pose", "by_model/pose"
RUN, SMOOTHED = "by_model", "smoothed"  # of velocities
LACKING, LEFT_OVER, EVIDENCE, MARKERS = "residual_force", "residual_force_left", "evidence", "/markers/residuals"
_TWIST_FIELDS = [*(f"twist.linear.{axis}" for axis in "xyz"), "twist.angular.z"]
_ARROW = 0  # visualization_msgs/msg/Marker
_RED, _GREEN = {"r": 0.9, "g": 0.25, "b": 0.2, "a": 0.9}, {"r": 0.3, "g": 0.8, "b": 0.35, "a": 0.9}

_Found = TypeVar("_Found", FreeRun, ResidualForce, GatheredEvidence, CourseVelocity)


class _Timed(NamedTuple):
    """A message: when [ns], where, and its bytes."""

    stamp_ns: int
    topic: str
    data: bytes


def has_overlay(diagnosis: Diagnosis) -> bool:
    """Tell whether there is anything to lay over a recording."""
    return bool(diagnosis.free_runs or diagnosis.residual_before or diagnosis.residual_after)


def write_overlay(diagnosis: Diagnosis, hull: float, folder: Path) -> None:
    """Write the overlay as a bag, or as a bag below the folder for each recording if there are several.

    hull: length of the robots [m], after which the arrows are scaled. Raises CocorosimError if the folder exists or
    cannot be written.
    """
    every: tuple[FreeRun | ResidualForce | GatheredEvidence | CourseVelocity, ...]
    every = (
        *diagnosis.free_runs, *diagnosis.residual_before, *diagnosis.residual_after, *diagnosis.gathered,
        *diagnosis.velocities,
    )  # fmt: skip
    clocks = list(dict.fromkeys(each.clock for each in every))
    scale = _metres_per_newton((*diagnosis.residual_before, *diagnosis.residual_after), hull)
    for number, clock in enumerate(clocks, 1):
        place = folder if len(clocks) == 1 else folder / f"{number:02d}_{_word(Path(clock.recording).stem)}"
        _write(place, clock, sorted(_messages(diagnosis, clock, scale), key=lambda each: each.stamp_ns), scale)


def _write(folder: Path, clock: Clock, messages: Sequence[_Timed], scale: float) -> None:
    kinds = {MARKERS: ARROWS, BY_PLATFORM: POSE, BY_MODEL: POSE, LACKING: WRENCH, LEFT_OVER: WRENCH, EVIDENCE: NUMBER}
    kinds |= {f"/{each.topic}": TWIST for each in (VELOCITY, GROUND_VELOCITY)}
    topics = sorted({each.topic for each in messages})
    channels = [Channel(topic, next(kind for end, kind in kinds.items() if topic.endswith(end))) for topic in topics]
    metadata = {"overlay_of": clock.recording, "arrow_metres_per_newton": f"{scale:.6g}"}
    with BagWriter(folder, channels, metadata=metadata) as writer:
        for each in messages:
            writer.write(each.topic, each.stamp_ns, each.stamp_ns, each.data)


def _messages(diagnosis: Diagnosis, clock: Clock, scale: float) -> Iterator[_Timed]:
    for run in _on(clock, diagnosis.free_runs):
        yield from _ghost(run, BY_PLATFORM, run.nominal)
        yield from _ghost(run, BY_MODEL, run.augmented)
        if run.velocity is not None:
            yield from _velocities(run, RUN, run.velocity)
    for course in _on(clock, diagnosis.velocities):
        yield from _velocities(course, SMOOTHED, course.velocity)
    for name, number, residuals in ((LACKING, 0, diagnosis.residual_before), (LEFT_OVER, 1, diagnosis.residual_after)):
        for residual in _on(clock, residuals):
            yield from _forces(residual, name)
            yield from _arrows(residual, number, scale)
    for gathered in _on(clock, diagnosis.gathered):
        yield from _evidence(gathered)


def _on(clock: Clock, found: Sequence[_Found]) -> Iterator[_Found]:
    """Findings whose times are of this clock."""
    return (each for each in found if each.clock == clock)


def _ghost(run: FreeRun, name: str, path: Floats) -> Iterator[_Timed]:
    """Poses of a free run: path (n, 4) x, y, z, yaw."""
    fields = [f"pose.position.{axis}" for axis in "xyz"] + ["pose.orientation.z", "pose.orientation.w"]
    message = PackedMessage([build(POSE, {"header": {"frame_id": WORLD_FRAME}})], fields)
    *place, yaw = path.T
    values = np.column_stack([*place, np.sin(0.5 * yaw), np.cos(0.5 * yaw)])
    yield from _each(message, f"/{_word(run.robot)}/{name}", run.clock, run.time, values)


def _velocities(of: FreeRun | CourseVelocity, name: str, velocity: BodyVelocity) -> Iterator[_Timed]:
    """Velocities through the water, and over ground where these are others."""
    robot = _word(of.robot)
    message = PackedMessage([build(TWIST, {"header": {"frame_id": f"{robot}/{BODY}"}})], _TWIST_FIELDS)
    ways = [(VELOCITY.topic, velocity.through_water)]
    if not np.array_equal(velocity.over_ground, velocity.through_water, equal_nan=True):
        ways.append((GROUND_VELOCITY.topic, velocity.over_ground))
    kept = _thinned(of.time)
    for topic, values in ways:
        yield from _each(message, f"/{robot}/{name}/{topic}", of.clock, of.time[kept], values[kept])


def _forces(residual: ResidualForce, name: str) -> Iterator[_Timed]:
    fields = [f"wrench.force.{axis}" for axis in "xyz"] + ["wrench.torque.z"]
    robot = _word(residual.robot)
    message = PackedMessage([build(WRENCH, {"header": {"frame_id": f"{robot}/{BODY}"}})], fields)
    kept = _thinned(residual.time)
    yield from _each(message, f"/{robot}/{name}", residual.clock, residual.time[kept], residual.force[kept])


def _arrows(residual: ResidualForce, number: int, scale: float) -> Iterator[_Timed]:
    """Arrows from the place of the robot along the force on it, in the world."""
    kept = _thinned(residual.time)
    place, force = residual.place[kept], residual.force[kept]
    *where, yaw = place.T
    forward, left, up, _ = force.T
    cosine, sine = np.cos(yaw), np.sin(yaw)
    push = np.column_stack([cosine * forward - sine * left, sine * forward + cosine * left, up])
    begin = np.column_stack(where)
    marker: dict[str, Any] = {
        "header": {"frame_id": WORLD_FRAME},
        "ns": _word(residual.robot),
        "id": number,
        "type": _ARROW,
        "color": (_RED, _GREEN)[number],
        "pose": {"orientation": {"w": 1.0}},
        "scale": {"x": OVERLAY.shaft, "y": 2.0 * OVERLAY.shaft},
        "points": [{}, {}],
        "lifetime": {"sec": OVERLAY.lifetime},
    }
    fields = [f"markers[#0].points[#{end}].{axis}" for end in (0, 1) for axis in "xyz"]
    message = PackedMessage([build(ARROWS, {"markers": [marker]})], fields, ["markers[#0].header.stamp"])
    values = np.column_stack([begin, begin + scale * push])
    yield from _each(message, MARKERS, residual.clock, residual.time[kept], values)


def _evidence(gathered: GatheredEvidence) -> Iterator[_Timed]:
    message = PackedMessage([build(NUMBER)], ["data"])
    kept = _thinned(gathered.time)
    topic = f"/{_word(gathered.robot)}/{EVIDENCE}"
    yield from _each(message, topic, gathered.clock, gathered.time[kept], gathered.nats[kept, None])


def _each(message: PackedMessage, topic: str, clock: Clock, time: Floats, values: Floats) -> Iterator[_Timed]:
    """A message for each row of values whose numbers are all known."""
    stamps = clock.start_ns + np.rint(time * NANOSECONDS).astype(np.int64)
    for stamp, row in zip(stamps.tolist(), values, strict=True):
        if stamp >= 0 and np.isfinite(row).all():
            yield _Timed(stamp, topic, message.encode(stamp, row[None])[0])


def _thinned(time: Floats) -> slice:
    """Rows that are enough to look at."""
    usual = float(np.median(np.diff(time))) if len(time) > 1 else OVERLAY.interval
    return slice(None, None, max(1, math.ceil(OVERLAY.interval / usual - OVERLAY.rounding)))


def _metres_per_newton(residuals: Sequence[ResidualForce], hull: float) -> float:
    """Length of an arrow by its force, so that the strongest are some hulls long."""
    sizes = [np.sqrt(x**2 + y**2 + z**2) for x, y, z, _ in (residual.force.T for residual in residuals)]
    strongest = float(np.nanquantile(np.concatenate(sizes), OVERLAY.strong)) if sizes else 0.0
    return OVERLAY.hulls * hull / strongest if strongest > 0.0 else 1.0


def _word(name: str) -> str:
    """A name as topics have them."""
    return re.sub(r"[^A-Za-z0-9_/]", "_", name.strip("/")) or "robot"
