"""Covariances that are none: negative variances, not symmetric, not positive semi-definite, not numbers."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from cocorosim_ros.diagnosis.checking.finding import Oddity
from cocorosim_ros.diagnosis.checking.topic_log import TopicLog
from cocorosim_ros.diagnosis.criteria.checking import CHECKING
from cocorosim_ros.foundation.arrays import Flags, Floats


def check_covariances(topic: TopicLog) -> Iterator[Oddity]:
    """Look at each covariance; -1 in the first place says by convention that nothing was measured, zero that nothing
    is known (sensor_msgs/Imu).
    """
    for path, matrices in topic.covariances.items():
        given = matrices[first_variances(matrices) != -1.0]
        for words, bad in _tests(given):
            if bad.any():
                share = "every message" if bad.all() else f"{np.count_nonzero(bad)} of {len(bad)} messages"
                yield Oddity("covariance", topic.name, f"{topic.name}: {path} {words} in {share}.")
                break


def first_variances(matrices: Floats) -> Floats:
    """(n,) first elements of covariances (n, rows, rows), which say by convention whether there is a reading."""
    return np.asarray(matrices.reshape(len(matrices), -1).T[0])


def _tests(matrices: Floats) -> Iterator[tuple[str, Flags]]:
    """Words for each thing that can be wrong, and with which (n,) it is; the first hides the others."""
    numbers: Flags = np.asarray(np.isfinite(matrices).all(axis=(1, 2)))
    yield "holds what is no number", ~numbers
    sound = np.where(numbers[:, None, None], matrices, 0.0)
    variances = np.diagonal(sound, axis1=1, axis2=2)
    yield "has a negative variance", np.asarray((variances < 0.0).any(axis=1))
    limit = CHECKING.covariance_off * np.abs(sound).max(axis=(1, 2))
    lopsided = np.abs(sound - sound.transpose(0, 2, 1)).max(axis=(1, 2))
    yield "is not symmetric", np.asarray(lopsided > limit)
    least = np.linalg.eigvalsh(0.5 * (sound + sound.transpose(0, 2, 1))).min(axis=1)
    yield "is not positive semi-definite, so it is no covariance,", np.asarray(least < -limit)
