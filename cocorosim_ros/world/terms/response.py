"""A first-order lag, exact for a target that holds: tau F' = T - F, so F = T + (F0 - T) exp(-t / tau)."""

from __future__ import annotations

import math

from cocorosim_ros.foundation.compiling.kernel import kernel


@kernel
def relaxed(target: float, begin: float, duration: float, time_constant: float) -> float:
    """What was `begin` is this after `duration` [s]; without a time constant [s] it is the target at once."""
    if time_constant <= 0.0:
        return target
    return target + (begin - target) * math.exp(-duration / time_constant)


@kernel
def delayed(target: float, begin: float, duration: float, time_constant: float) -> float:
    """The mean over `duration` [s] of what was `begin` at its beginning; `begin` itself for no duration."""
    if time_constant <= 0.0:
        return target
    if duration <= 0.0:
        return begin
    share = -math.expm1(-duration / time_constant) * time_constant / duration
    return target + (begin - target) * share
