"""Axes of the velocity stream: body or world, right or mirrored."""

from __future__ import annotations

import numpy as np

from cocorosim_ros.diagnosis.criteria.frames import AXES
from cocorosim_ros.diagnosis.evidence.frames.agreement import correlation, independent, nats_behind
from cocorosim_ros.diagnosis.evidence.frames.correction import FrameCorrection
from cocorosim_ros.diagnosis.evidence.frames.expected import Complex
from cocorosim_ros.diagnosis.evidence.frames.motion import Motion
from cocorosim_ros.diagnosis.evidence.frames.turned import ALL_TURNED, SAME, Turned, matrix_of, position_words

TOPIC = "velocity"


def velocity_axes(motion: Motion, lift_nats: float) -> FrameCorrection | None:
    """The correction of a velocity stream whose axes are not forward-left-up; None if they are.

    lift_nats: nats by which the third component fits better with the opposite sign.
    """
    upside_down = lift_nats > AXES.margin
    (world, turned), nats = _best(motion)
    changed = nats > AXES.margin and (world, turned) != (False, SAME)
    if not changed and not upside_down:
        return None
    matrix = np.eye(3)
    words = []
    if changed:
        matrix[:2, :2] = matrix_of(turned)
        words += ["it is in world axes instead of body axes"] if world else []
        words += [position_words(turned)] if turned != SAME else []
    if upside_down:
        matrix[2, 2] = -1.0
        words.append("the sign of z is flipped")
    because = "only so it agrees with the motion that the poses show"
    total = (nats if changed else 0.0) + (lift_nats if upside_down else 0.0)
    return FrameCorrection(TOPIC, ", and ".join(words), because, total, matrix, np.zeros(3), changed and world)


def _best(motion: Motion) -> tuple[tuple[bool, Turned], float]:
    """The best change, as (from world into body axes?, turn), and its lead [nats] over leaving the stream as it is.

    Deviations from the mean are compared, in world axes, because a current adds a constant there.
    """
    seen_from_body = np.isfinite(motion.course * motion.yaw).any()
    shown, into_world = (motion.course, np.exp(1j * motion.yaw)) if seen_from_body else (motion.advance, 1.0 + 0.0j)
    worlds = (False, True) if seen_from_body else (False,)
    candidates = [(world, turned) for world in worlds for turned in ALL_TURNED]  # the simplest first
    scores = [_score(motion.through, shown, into_world, candidate) for candidate in candidates]
    count = independent(motion.through, shown, motion.weight)
    behind = nats_behind(np.array(scores), max(scores), count)
    simplest = int(np.flatnonzero(behind < AXES.tied)[0])
    return candidates[simplest], float(behind[0])


def _score(read: Complex, shown: Complex, into_world: Complex | complex, candidate: tuple[bool, Turned]) -> float:
    """Share of the motion that the readings explain; 0 if they point the opposite way."""
    world, (mirrored, quarters) = candidate
    body = read * np.conj(into_world) if world else read
    turned = 1j**quarters * (np.conj(body) if mirrored else body)
    found = correlation(turned * into_world, shown)
    return float(max(found.real, 0.0) ** 2)
