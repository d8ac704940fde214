"""Fewer points that tell no lies."""

from __future__ import annotations

import numpy as np

from cocorosim_ros.study.pictures.decimation import envelope, every_nth, with_breaks

SECOND = 1_000_000_000


def test_envelope_keeps_every_extreme() -> None:
    """One spike among 25 000 values is still there, at its place, and the groups are as few as asked for."""
    time, values = np.arange(25_000.0), np.zeros(25_000)
    values[12_345] = 7.0
    groups = envelope(time, values, 600)
    assert groups.time.size <= 600
    assert groups.per_group == 42
    assert groups.high.max() == 7.0
    assert abs(groups.time[groups.high.argmax()] - 12_345) <= 21
    assert groups.mean.max() == 7.0 / 42


def test_envelope_of_few_values_is_the_values() -> None:
    """Nothing is grouped that fits."""
    values = np.array([3.0, 1.0, np.nan, 2.0])
    groups = envelope(np.arange(4.0), values, 4)
    for part in (groups.low, groups.mean, groups.high):
        np.testing.assert_array_equal(part, values)


def test_envelope_leaves_out_the_undefined() -> None:
    """A group counts its known values alone; a group without any is a gap."""
    groups = envelope(np.arange(6.0), np.array([1.0, np.nan, np.nan, np.nan, 4.0, 8.0]), 3)
    np.testing.assert_array_equal(groups.mean, [1.0, np.nan, 6.0])
    np.testing.assert_array_equal(groups.low, [1.0, np.nan, 4.0])


def test_every_nth_keeps_the_ends() -> None:
    """First and last moment stay, in between every n-th."""
    kept, step = every_nth(np.arange(11), 4)
    np.testing.assert_array_equal(kept, [0, 3, 6, 9, 10])
    assert step == 3


def test_lines_break_at_gaps() -> None:
    """At 10 Hz a gap of 2 s breaks the line once, one of 0.9 s does not."""
    stamps = np.cumsum([0, *[SECOND // 10] * 5, SECOND * 9 // 10, *[SECOND // 10] * 3, 2 * SECOND, SECOND // 10])
    points = np.column_stack([stamps, stamps]).astype(float)
    broken = with_breaks(stamps, points)
    np.testing.assert_array_equal(np.flatnonzero(np.isnan(broken[:, 0])), [10])
    np.testing.assert_array_equal(broken[~np.isnan(broken[:, 0])], points)
