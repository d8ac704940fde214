"""How strongly the water pushes at random, and how far readings scatter, as the fit has them."""

from __future__ import annotations

import numpy as np

from cocorosim_ros.diagnosis.filter.layout import KIND_NAMES
from cocorosim_ros.diagnosis.findings import Estimate
from cocorosim_ros.diagnosis.fitting.fit import Fit, noise_covariance
from cocorosim_ros.diagnosis.showing.estimates import Z95
from cocorosim_ros.diagnosis.tracks.columns import READING_NOISE_OF_KIND
from cocorosim_ros.world.laws.readings import READING

UNITS = {
    "random.force": "N", "random.heave_force": "N", "random.moment": "N m", "random.correlation": "s",
    "random.smoothness": "1",
    **{f"reading.{name}": READING[kind].unit for name, kind in zip(READING_NOISE_OF_KIND, KIND_NAMES, strict=True)},
}  # fmt: skip


def noise_levels(fit: Fit) -> dict[str, Estimate]:
    """By name: standard deviations, and the correlation time of the random forces; of the first robot."""
    spread = np.sqrt(np.diag(noise_covariance(fit)))
    found: dict[str, Estimate] = {}
    for unknown, q, width in zip(fit.noise, fit.q_noise, spread, strict=True):
        low, value, high = np.exp(unknown.value(float(q)) + Z95 * float(width) * np.array([-1.0, 0.0, 1.0])).tolist()
        found.setdefault(unknown.column, Estimate(value, low, high, UNITS[unknown.column]))
    return found
