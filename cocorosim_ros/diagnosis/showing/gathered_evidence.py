"""Evidence over time: how much better one model foretold the readings than another, reading by reading."""

from __future__ import annotations

import math

import numpy as np

from cocorosim_ros.diagnosis.findings import GatheredEvidence
from cocorosim_ros.diagnosis.fitting.fit import Fit
from cocorosim_ros.diagnosis.tracks.passes import Pass
from cocorosim_ros.foundation.arrays import Floats


def gathered_evidence(base: Fit, final: Fit) -> tuple[GatheredEvidence, ...]:
    """Log-likelihood of the readings up to each grid point under `final`, less that under `base`, of every track.

    Both are from the passes that the fits have: nothing is run for it. A track whose readings differ between the two
    fits is left out. Priors and the number of numbers, which a Bayes factor counts as well, are not in it.
    """
    found = []
    for track, before, after in zip(base.tracks, base.passes, final.passes, strict=True):
        if len(before.innovation) != len(after.innovation):
            continue
        order = np.argsort(track.timeline.stamp, kind="stable")
        gained = np.cumsum((_log_densities(after) - _log_densities(before))[order])
        time = track.timeline.grid.moments
        counted = np.searchsorted(track.timeline.stamp[order], time, side="right")
        found.append(GatheredEvidence(track.name, time, np.append(0.0, gained)[counted], track.log.clock))
    return tuple(found)


def _log_densities(passed: Pass) -> Floats:
    """Log density (m,) of each reading given those before it [nats]."""
    return np.asarray(-0.5 * (passed.innovation**2 / passed.variance + np.log(2.0 * math.pi * passed.variance)))
