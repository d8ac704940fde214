"""The noise of single readings, estimated from high differences of the readings themselves."""

from __future__ import annotations

import numpy as np

from cocorosim_ros.diagnosis.criteria.evidence import NOISE
from cocorosim_ros.diagnosis.evidence.streams.levels import steps_between
from cocorosim_ros.foundation.arrays import Floats

LOW_ORDER, HIGH_ORDER = 4, 6  # of differences, which vanish for polynomials of lower degree
WITHIN_ONE_SIGMA = 0.6826894921370859  # share of a normal distribution


def noise_of(time: Floats, value: Floats, turn: float = 0.0) -> float:
    """The standard deviation of a single reading [unit of value]; NaN for too few readings or a constant one.

    time (n,) [s] ascending, value (n,) with NaN where not given; turn: a full turn [unit of value] of angles, which are
    unwrapped, and 0 for what is none.

    The residual of a reading from the polynomial of degree 3 (or 5) through its neighbours, at their real stamps, is
    noise alone if the motion is smooth over five (seven) readings. The estimate is the size below which 68 % of these
    residuals stay, which jumps and spikes do not move; a reading in steps of q is uncertain by q / sqrt(12) at least.
    Where readings merely repeat the last one because the sensor is slower than its messages, each value counts once.

    Motion that bends between two readings adds to the residuals; the estimate is then an upper bound.
    """
    time, value = _informative(time, value, turn)
    step = quantum_of(value, turn)
    if not step > 0.0 and not (value.size and np.ptp(value) > 0.0):
        return float("nan")
    low = contrast_residuals(time, value, LOW_ORDER)
    high = contrast_residuals(time, value, HIGH_ORDER)
    if low.size < NOISE.fewest:
        return float("nan")
    estimate, finer = _scale(low), _scale(high) if high.size >= NOISE.fewest else np.inf
    if finer < NOISE.motion_shows * estimate:
        low, estimate = high, finer
    quiet = _quiet_scale(low)
    if quiet < NOISE.uneven * estimate:
        estimate = quiet
    return float(max(estimate, step / np.sqrt(12.0)))


def contrast_residuals(time: Floats, value: Floats, order: int) -> Floats:
    """Residuals (m,), of unit gain for white noise, of all windows of order + 1 readings without a gap.

    The weights c_j = 1 / prod_{k != j} (t_j - t_k) are the divided difference of this order (Newton), zero for every
    polynomial of lower degree.
    """
    width = order + 1
    if len(time) < width:
        return np.empty(0)
    times = np.lib.stride_tricks.sliding_window_view(time, width)
    values = np.lib.stride_tricks.sliding_window_view(value, width)
    span = times[:, -1] - times[:, 0]
    close = span <= NOISE.widest_span * np.median(span)
    times, values = times[close] / span[close, None], values[close]
    apart = times[:, :, None] - times[:, None, :]
    apart[:, np.arange(width), np.arange(width)] = 1.0
    weights = 1.0 / apart.prod(axis=2)
    weights /= np.sqrt((weights**2).sum(axis=1, keepdims=True))
    return np.asarray((weights * (values - values.mean(axis=1, keepdims=True))).sum(axis=1))


def quantum_of(value: Floats, turn: float = 0.0) -> float:
    """The step of which all readings are multiples, up to a constant; 0 if no step shows.

    value (n,), finite; turn: a full turn [unit of value] of angles, 0 for what is none.
    """
    if not value.size:
        return 0.0
    steps = steps_between(value, NOISE.rounding * max(float(np.abs(value).max()), float(np.ptp(value))), turn)
    if not steps.size:
        return 0.0
    step = float(steps.min())
    whole = np.abs(steps / step - np.rint(steps / step))
    seen_often = steps.size + 1 < NOISE.most_levels * value.size
    needed = 1.0 - NOISE.ends_of_turns if turn else 1.0
    return step if seen_often and float(np.mean(whole < NOISE.whole)) >= needed else 0.0


def hides_motion(value: Floats) -> bool:
    """Tell whether readings (n,), NaN where not given, are in steps so coarse that most of what moves them is rounded.

    They then tell of small motions that there are none, and of larger ones too much.
    """
    given = value[np.isfinite(value)]
    return bool(given.size) and float(np.std(given)) < NOISE.dithered * quantum_of(given)


def _informative(time: Floats, value: Floats, turn: float) -> tuple[Floats, Floats]:
    """Leave out missing readings, and those that repeat the one before if a slow sensor makes many of these."""
    given = np.isfinite(value)
    time, value = time[given], value[given]
    if value.size < 2:
        return time, value
    fresh = np.append(True, np.abs(np.diff(value)) > NOISE.finest_of_turn * turn)
    if np.mean(~fresh) > NOISE.repeated and quantum_of(value, turn) == 0.0:
        return time[fresh], value[fresh]
    return time, value


def _scale(residuals: Floats) -> float:
    return float(np.quantile(np.abs(residuals), WITHIN_ONE_SIGMA))


def _quiet_scale(residuals: Floats) -> float:
    """Standard deviation of the noise in `residuals` (n,), in their unit, from the quieter stretches of the recording.

    The residuals are cut into stretches, each gives a scale, and the quantile NOISE.quiet_quantile of these is taken:
    motion, which adds to the noise, shows least there.
    """
    parts: list[Floats] = np.array_split(residuals, min(NOISE.stretches, residuals.size // NOISE.fewest))
    return float(np.quantile([_scale(part) for part in parts], NOISE.quiet_quantile))
