"""Noise of a fit with intervals: strength of the water's random forces, scatter of the readings."""

from __future__ import annotations

import numpy as np

from cocorosim_ros.diagnosis.findings import Estimate
from cocorosim_ros.diagnosis.fitting.fit import Fit
from cocorosim_ros.diagnosis.fitting.noise_information import noise_covariance
from cocorosim_ros.diagnosis.fitting.unknowns import Z95


def noise_levels(fit: Fit) -> dict[str, Estimate]:
    """Estimates by column of the noise, for the first robot: standard deviations, correlation time and smoothness."""
    spread = np.sqrt(np.diag(noise_covariance(fit)))
    found: dict[str, Estimate] = {}
    for unknown, q, width in zip(fit.noise, fit.q_noise, spread, strict=True):
        low, value, high = np.exp(unknown.value(float(q)) + Z95 * float(width) * np.array([-1.0, 0.0, 1.0])).tolist()
        found.setdefault(unknown.column, Estimate(value, low, high, unknown.owner.unit))
    return found
