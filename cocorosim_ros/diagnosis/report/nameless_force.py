"""Words for the figure beside the free runs that a force without a name leaves, where models err less than that."""

from __future__ import annotations

from collections.abc import Sequence

from cocorosim_ros.diagnosis.findings import HeldOut
from cocorosim_ros.diagnosis.foretelling.rulers import CHANNELS
from cocorosim_ros.scenario.reading.entry import listed

NO_BOUND = "no bound"


def is_no_bound(channel: str, row: HeldOut) -> bool:
    """Tell whether free runs of a model err less in a channel, interval and all, than with a force without a name."""
    ends = [row.intervals[name][1] for name in ("recalibrated", "augmented") if name in row.intervals]
    return channel in CHANNELS and any(end < row.noise_floor for end in ends)


def no_bound_sentence(channels: Sequence[str]) -> str:
    """A sentence on such channels; '' if there are none."""
    if not channels:
        return ""
    return (
        f"In {listed(channels, 'and')} a model without such a force errs less, by more than its interval: what the "
        "force leaves is no bound there. It is a sum of a few terms, and stands for no delay, stamp or centre of mass."
    )
