"""Positions whose axes are mirrored, as a velocity stream shows them.

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
from cocorosim_ros.diagnosis.evidence.frames.turned import ALL_TURNED, matrix_of, position_words, turned_by
from cocorosim_ros.diagnosis.evidence.frames.velocity_axes import changes, missed, unexplained
from cocorosim_ros.diagnosis.evidence.streams.stream_columns import OVER_GROUND, PLANE, THROUGH_WATER


def mirrored_poses(motion: ShownMotion) -> FrameCorrection | None:
    """The correction of positions that agree with the velocity stream as a mirror image alone; None if they need none.

    They have to agree clearly better than by any change of the axes of that stream: that over ground where there is
    one, since currents that change with place are no part of it.
    """
    by_body = motion.moved[OVER_GROUND if np.isfinite(motion.moved[OVER_GROUND]).any() else THROUGH_WATER]
    moved = by_body * np.exp(1j * motion.yaw)
    count = independent(moved, motion.course, noise_weight(motion))
    if count < KINEMATICS.fewest or not is_smooth(motion.course):
        return None
    mirrors = [turned for turned in ALL_TURNED if turned.mirrored]
    left = [missed(moved, turned_by(turned, motion.course)) for turned in mirrors]
    best = int(np.argmin(left))
    behind = nats_behind(1.0 - unexplained(motion, by_body, changes(worlds=(False, True))), 1.0 - left[best], count)
    if behind.min() < AXES.margin:
        return None
    matrix = np.eye(4)
    matrix[PLANE, PLANE] = matrix_of(mirrors[best])
    because = "only so they agree with the velocities, whichever way the vehicle heads"
    return affine("pose", Fault(position_words(mirrors[best]), because), float(behind[0]), matrix)
