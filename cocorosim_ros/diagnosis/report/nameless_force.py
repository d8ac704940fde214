"""Words for the figure beside the free runs that a force without a name leaves, where models err less than that."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from cocorosim_ros.diagnosis.findings import HeldOut
from cocorosim_ros.diagnosis.foretelling.rulers import CHANNELS

NO_BOUND = "no bound"


def channels_without_bound(table: Mapping[str, HeldOut]) -> tuple[str, ...]:
    """Channels of free runs in which a model errs less than one with a force without a name, interval and all."""
    return tuple(channel for channel, row in table.items() if channel in CHANNELS and _errs_less(row))


def _errs_less(row: HeldOut) -> bool:
    ends = [row.intervals[name][1] for name in ("recalibrated", "augmented") if name in row.intervals]
    return any(end < row.noise_floor for end in ends)


def no_bound_sentence(channels: Sequence[str]) -> str:
    """A sentence on such channels; '' if there are none."""
    if not channels:
        return ""
    *others, last = channels
    listed = f"{', '.join(others)} and {last}" if others else last
    return (
        f"In {listed} a model without such a force errs less, by more than its interval: what the force leaves is no "
        "bound there. It is a sum of a few terms, and stands for no delay, stamp or centre of mass."
    )
