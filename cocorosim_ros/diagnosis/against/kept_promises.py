"""Information that fits have kept: a slope may promise nats that no size of a number brings.

Sizes from which a difference would be named follow from slopes. Where a slope promised enough to fit a number, and the
fit found a share of these nats alone, the likelihood falls off sooner than its slope says. Then the rest of the
information is left out, so that no size is told as visible that was fitted and not seen.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from cocorosim_ros.diagnosis.criteria.naming import NAMING
from cocorosim_ros.diagnosis.fitting.screening import Screened
from cocorosim_ros.diagnosis.naming.contest import Begun


def as_kept(screened: Screened, begun: Sequence[Begun]) -> Screened:
    """Copy a screened candidate, its information times the share of the promised nats that its fit has found.

    begun: fits of candidates on top of the fit that was screened. Without such a fit, or with a promise below the
    threshold of evidence, all information stays; that of a delay also does, since delays are tried (`Screen.felt`).
    """
    gain = next((each.gain for each in begun if each.candidate is screened.candidate), None)
    promised = promised_gain(screened)
    if gain is None or not promised > NAMING.threshold or not math.isnan(screened.felt):
        return screened
    return replace(screened, information=min(max(gain / promised, 0.0), 1.0) * screened.information)


def promised_gain(screened: Screened) -> float:
    """Nats by which the log-likelihood would grow along the slope of a screened candidate, up to its estimate."""
    score = screened.z * np.sqrt(np.diag(screened.information))
    return float(score @ screened.q - 0.5 * screened.q @ screened.information @ screened.q)
