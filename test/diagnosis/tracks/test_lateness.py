"""Lateness that all readings share."""

from __future__ import annotations

from typing import Any

import pytest

from cocorosim_ros.diagnosis.tracks.columns import COLUMN, NEUTRAL
from cocorosim_ros.diagnosis.tracks.lateness import common_lateness


def late(**streams: float) -> Any:
    """Numbers of a model in which streams are late by these times [s]."""
    row = NEUTRAL.copy()
    for name, latency in streams.items():
        row[COLUMN[f"sensor_latency.{name}"]] = latency
    return row


@pytest.mark.parametrize(
    ("row", "clocks", "common"),
    [
        (late(pose=0.4), ("pose",), 0.4),
        (late(pose=-0.4), ("pose",), -0.4),
        (late(pose=0.4), ("pose", "imu"), 0.0),
        (late(pose=0.4, imu=0.1), ("pose", "imu"), 0.1),
        (late(pose=-0.4, imu=-0.1), ("pose", "imu"), -0.1),
        (late(pose=0.4, imu=-0.1), ("pose", "imu"), 0.0),
        (late(pose=0.4), (), 0.0),
    ],
)
def test_the_common_lateness_is_what_no_stream_is_without(row: Any, clocks: tuple[str, ...], common: float) -> None:
    """The smallest of latencies of one sign; nothing where a stream is right, or where signs differ."""
    assert common_lateness(row, clocks) == pytest.approx(common)
