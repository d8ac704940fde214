"""Positions whose axes are mirrored, as the velocity stream shows them.

A mirrored position cannot be told from a velocity with a flipped sign while the vehicle heads one way: the flip of a
course along x is that of a vehicle which swims backwards. Over all headings it can, since the one is mirrored in the
world and the other in the body.
"""

from __future__ import annotations

import numpy as np

from cocorosim_ros.diagnosis.criteria.frames import AXES, KINEMATICS
from cocorosim_ros.diagnosis.evidence.frames.agreement import independent, nats_behind
from cocorosim_ros.diagnosis.evidence.frames.correction import Fault, FrameCorrection, affine
from cocorosim_ros.diagnosis.evidence.frames.kinematics import is_smooth, noise_weight
from cocorosim_ros.diagnosis.evidence.frames.motion import ShownMotion
from cocorosim_ros.diagnosis.evidence.frames.through_water import UNCHANGED, least_unexplained, unexplained
from cocorosim_ros.diagnosis.evidence.frames.turned import ALL_TURNED, Turned, matrix_of, position_words, turned_by
from cocorosim_ros.diagnosis.evidence.streams.stream_columns import PLANE


def mirrored_poses(motion: ShownMotion) -> FrameCorrection | None:
    """The correction of positions that agree with the velocity stream as a mirror image alone; None if they need none.

    They have to agree clearly better than by any change of the axes of that stream.
    """
    count = independent(motion.through * np.exp(1j * motion.yaw), motion.course, noise_weight(motion))
    if count < KINEMATICS.fewest or not is_smooth(motion.course):
        return None
    mirrors = [turned for turned in ALL_TURNED if turned.mirrored]
    left = [_left(motion, turned) for turned in mirrors]
    best = int(np.argmin(left))
    others = np.array([least_unexplained(motion), unexplained(motion, UNCHANGED)])
    over_velocity, over_nothing = nats_behind(1.0 - others, 1.0 - left[best], count).tolist()
    if over_velocity < AXES.margin:
        return None
    matrix = np.eye(4)
    matrix[PLANE, PLANE] = matrix_of(mirrors[best])
    because = "only so they agree with the velocities, whichever way the vehicle heads"
    return affine("pose", Fault(position_words(mirrors[best]), because), over_nothing, matrix)


def _left(motion: ShownMotion, turned: Turned) -> float:
    """Share of a turned course, its mean left out, by which the velocity stream misses it."""
    course = turned_by(turned, motion.course)
    missed = motion.through * np.exp(1j * motion.yaw) - course
    given = np.isfinite(missed)
    return float(np.var(missed[given]) / np.var(course[given]))
