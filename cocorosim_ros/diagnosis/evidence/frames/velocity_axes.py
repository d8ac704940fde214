"""Axes of a velocity stream, through the water or over ground: body or world, right or mirrored."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from cocorosim_ros.diagnosis.criteria.frames import AXES, KINEMATICS
from cocorosim_ros.diagnosis.evidence.frames.agreement import correlation, independent, nats_behind
from cocorosim_ros.diagnosis.evidence.frames.correction import FrameCorrection
from cocorosim_ros.diagnosis.evidence.frames.expected import Complex
from cocorosim_ros.diagnosis.evidence.frames.kinematics import is_smooth, noise_weight
from cocorosim_ros.diagnosis.evidence.frames.motion import ShownMotion
from cocorosim_ros.diagnosis.evidence.frames.turned import (
    ALL_TURNED,
    SAME,
    Turned,
    matrix_of,
    position_words,
    turned_by,
)
from cocorosim_ros.diagnosis.evidence.streams.stream_columns import PLANE, THROUGH_WATER, W
from cocorosim_ros.foundation.arrays import Floats


@dataclass(frozen=True)
class Change:
    """A change of a velocity stream: turned out of world axes into those of the body, and turned or mirrored there."""

    from_world: bool
    turned: Turned


UNCHANGED = Change(from_world=False, turned=SAME)


def velocity_axes(motion: ShownMotion, topic: str, lift_nats: float) -> FrameCorrection | None:
    """The correction of a velocity stream whose axes are not forward-left-up; None if they are.

    topic: of the stream, one of VELOCITIES. lift_nats: nats by which the third component fits better with the opposite
    sign.
    """
    upside_down = lift_nats > AXES.margin
    change, nats = _best(motion, topic)
    changed = nats > AXES.margin and change != UNCHANGED
    if not changed and not upside_down:
        return None
    matrix = np.eye(3)
    words = []
    if changed:
        matrix[PLANE, PLANE] = matrix_of(change.turned)
        words += ["it is in world axes instead of body axes"] if change.from_world else []
        words += [position_words(change.turned)] if change.turned != SAME else []
    if upside_down:
        matrix[W, W] = -1.0
        words.append("the sign of z is flipped")
    because = "only so it agrees with the motion that the poses show"
    total = (nats if changed else 0.0) + (lift_nats if upside_down else 0.0)
    return FrameCorrection(
        topic, ", and ".join(words), because, total, matrix, np.zeros(3), changed and change.from_world
    )


def _best(motion: ShownMotion, topic: str) -> tuple[Change, float]:
    """The best change of a velocity stream, and its lead [nats] over leaving the stream as it is.

    Deviations from the mean are compared, in world axes, because a current adds a constant there. Where the
    vehicle is so slow that its motions are few, readings decide, by what a change foretells of the poses' velocity.
    """
    moved = motion.moved[topic]
    seen_from_body = np.isfinite(motion.course * motion.yaw).any()
    shown, into_world = (motion.course, np.exp(1j * motion.yaw)) if seen_from_body else _commanded(motion, topic)
    worlds = (False, True) if seen_from_body else (False,)
    candidates = changes(worlds)
    scores = [_score(moved, shown, into_world, candidate) for candidate in candidates]
    count = independent(moved, shown, motion.weight)
    behind = nats_behind(np.array(scores), max(scores), count)
    simplest = int(np.flatnonzero(behind < AXES.tied)[0])
    if candidates[simplest] == UNCHANGED and seen_from_body:
        return _exact(motion, moved, candidates)
    return candidates[simplest], float(behind[0])


def _commanded(motion: ShownMotion, topic: str) -> tuple[Complex, Complex | complex]:
    """Velocity (n,) under the commands, and the turn from body axes into those in which it is compared.

    A velocity over ground is compared in world axes, where a current is a constant; without a compass in none.
    """
    if topic == THROUGH_WATER:
        return motion.advance, 1.0 + 0.0j
    into_world = np.exp(1j * motion.heading)
    return motion.advance * into_world, into_world


def changes(worlds: Sequence[bool]) -> list[Change]:
    """List all changes, none and then the simplest first; worlds: whether out of world axes."""
    return [Change(world, turned) for world in worlds for turned in ALL_TURNED]


def _exact(motion: ShownMotion, moved: Complex, candidates: Sequence[Change]) -> tuple[Change, float]:
    """The change that foretells the velocity of the poses nearly to their noise where the stream as it is does not."""
    count = independent(moved, motion.course, noise_weight(motion))
    if count < KINEMATICS.fewest or not is_smooth(motion.course):
        return UNCHANGED, 0.0
    left = unexplained(motion, moved, candidates)
    best = int(left.argmin())
    if left[best] > 1.0 - KINEMATICS.explains or left[0] < KINEMATICS.better * left[best]:
        return UNCHANGED, 0.0
    return candidates[best], float(nats_behind(1.0 - left, 1.0 - left[best], count)[0])


def unexplained(motion: ShownMotion, moved: Complex, candidates: Sequence[Change]) -> Floats:
    """Shares (candidates,) of the poses' velocity, its mean left out, by which `moved` (n,), changed, misses it."""
    into_world = np.exp(1j * motion.yaw)
    return np.array([missed(_in_world(moved, into_world, each), motion.course) for each in candidates])


def missed(moved: Complex, course: Complex) -> float:
    """Share of a course (n,), its mean left out, by which a velocity (n,) in world axes misses it."""
    left = moved - course
    given = np.isfinite(left)
    return float(np.var(left[given]) / np.var(course[given]))


def _score(read: Complex, shown: Complex, into_world: Complex | complex, change: Change) -> float:
    """Share of the motion that the readings explain; 0 if they point the opposite way."""
    found = correlation(_in_world(read, into_world, change), shown)
    return float(max(found.real, 0.0) ** 2)


def _in_world(read: Complex, into_world: Complex | complex, change: Change) -> Complex:
    """The changed readings in world axes."""
    body = read * np.conj(into_world) if change.from_world else read
    return np.asarray(turned_by(change.turned, body) * into_world)
