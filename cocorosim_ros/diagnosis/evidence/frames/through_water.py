"""Axes of the velocity stream: body or world, right or mirrored."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from cocorosim_ros.diagnosis.criteria.frames import AXES
from cocorosim_ros.diagnosis.evidence.frames.agreement import correlation, independent, nats_behind
from cocorosim_ros.diagnosis.evidence.frames.correction import FrameCorrection
from cocorosim_ros.diagnosis.evidence.frames.expected import Complex
from cocorosim_ros.diagnosis.evidence.frames.motion import ShownMotion
from cocorosim_ros.diagnosis.evidence.frames.turned import ALL_TURNED, SAME, Turned, matrix_of, position_words
from cocorosim_ros.diagnosis.evidence.streams.stream_columns import PLANE, W

TOPIC = "velocity"


@dataclass(frozen=True)
class Change:
    """A change of a velocity stream: turned out of world axes into those of the body, and turned or mirrored there."""

    from_world: bool
    turned: Turned


UNCHANGED = Change(from_world=False, turned=SAME)


def velocity_axes(motion: ShownMotion, lift_nats: float) -> FrameCorrection | None:
    """The correction of a velocity stream whose axes are not forward-left-up; None if they are.

    lift_nats: nats by which the third component fits better with the opposite sign.
    """
    upside_down = lift_nats > AXES.margin
    change, nats = _best(motion)
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
        TOPIC, ", and ".join(words), because, total, matrix, np.zeros(3), changed and change.from_world
    )


def _best(motion: ShownMotion) -> tuple[Change, float]:
    """The best change, and its lead [nats] over leaving the stream as it is.

    Deviations from the mean are compared, in world axes, because a current adds a constant there.
    """
    seen_from_body = np.isfinite(motion.course * motion.yaw).any()
    shown, into_world = (motion.course, np.exp(1j * motion.yaw)) if seen_from_body else (motion.advance, 1.0 + 0.0j)
    worlds = (False, True) if seen_from_body else (False,)
    candidates = [Change(world, turned) for world in worlds for turned in ALL_TURNED]  # the simplest first
    scores = [_score(motion.through, shown, into_world, candidate) for candidate in candidates]
    count = independent(motion.through, shown, motion.weight)
    behind = nats_behind(np.array(scores), max(scores), count)
    simplest = int(np.flatnonzero(behind < AXES.tied)[0])
    return candidates[simplest], float(behind[0])


def _score(read: Complex, shown: Complex, into_world: Complex | complex, change: Change) -> float:
    """Share of the motion that the readings explain; 0 if they point the opposite way."""
    body = read * np.conj(into_world) if change.from_world else read
    turned = 1j**change.turned.quarters * (np.conj(body) if change.turned.mirrored else body)
    found = correlation(turned * into_world, shown)
    return float(max(found.real, 0.0) ** 2)
