"""How much of its pull a reading keeps that is far off: angles less and less beyond a quarter turn."""

from __future__ import annotations

import math

import pytest

from cocorosim_ros.diagnosis.filter.layout import KIND_NAMES
from cocorosim_ros.diagnosis.filter.reading import certainty_of_turn

HEADINGS = [name for name in KIND_NAMES if "yaw" in name or "heading" in name]
OTHERS = [name for name in KIND_NAMES if name.startswith(("pose_x", "gyro", "pressure"))]


@pytest.mark.parametrize("name", HEADINGS)
def test_an_angle_within_a_quarter_turn_keeps_its_pull_and_half_a_turn_off_has_none(name: str) -> None:
    """To both sides, and continuously."""
    kind = KIND_NAMES.index(name)
    for side in (-1.0, 1.0):
        kept = [certainty_of_turn(kind, side * share * math.pi) for share in (0.0, 0.3, 0.5, 0.6, 0.8, 1.0)]
        assert kept == pytest.approx([1.0, 1.0, 1.0, 0.8, 0.4, 0.0])


@pytest.mark.parametrize("name", OTHERS)
def test_what_is_no_angle_keeps_its_pull(name: str) -> None:
    """However far off it is; the gate alone bounds it."""
    kind = KIND_NAMES.index(name)
    assert [certainty_of_turn(kind, off) for off in (0.1, 2.0, 3.0, 1e5)] == [1.0] * 4


def test_there_are_angles_and_others() -> None:
    """Else the two tests above ask nothing."""
    assert HEADINGS and OTHERS
