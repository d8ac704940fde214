"""Exact agreement with the platform as given: where it foretells motion as the filter can, no number has moved.

Where readings have no noise, as in clean simulations, they tell numbers to many digits, and the filter's steps move
these digits: a gain of 1.0026 for 1 at four standard deviations, though the model with 1 is off by micrometres after
twenty seconds. Such a shift is that of the steps. Where a hole begins in the middle of a turn, they err by a little
more; then no number has moved either, if the model with the numbers that were fitted foretells no better.
"""

from __future__ import annotations

from collections.abc import Mapping

from cocorosim_ros.diagnosis.criteria.showing import VERDICT
from cocorosim_ros.diagnosis.findings import HeldOut
from cocorosim_ros.world.sensors import KINDS

EXACT = {"position": "pose_x", "heading": "pose_yaw", "depth": "pose_z"}
"""Kinds of readings, by the channel of free runs, whose least noise, which is what steps err by, counts as exact."""


def is_beyond_steps(channel: str, error: float) -> bool:
    """Tell whether an error is more than the filter's steps make; True for streams, which have no steps."""
    return channel not in EXACT or error >= KINDS[EXACT[channel]].least_noise


def is_exact(table: Mapping[str, HeldOut]) -> bool:
    """Tell whether free runs of the platform as given err by no more than the filter's steps, on all channels shown."""
    shown = {channel: row for channel, row in table.items() if channel in EXACT}
    return bool(shown) and all(_is_of_steps(channel, row) for channel, row in shown.items())


def _is_of_steps(channel: str, row: HeldOut) -> bool:
    if not is_beyond_steps(channel, row.nominal):
        return True
    return row.recalibrated >= row.nominal and not is_beyond_steps(channel, row.nominal / VERDICT.nearly_exact)
