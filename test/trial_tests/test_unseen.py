"""The platform's file and a found model on recordings that neither was fitted to."""

from __future__ import annotations

from pathlib import Path

import pytest
from trial.unseen import SETTLING, OnUnseen, on_unseen

from cocorosim_ros.wire.bags.bag_reader import read_bag

FIVE = Path(__file__).parents[2] / "bags" / "five_lilys" / "bag"
ROBOTS = 5


def by_model(name: str) -> dict[str, OnUnseen]:
    """The recording of five Lilys, run by a Lily's file and by another one."""
    return on_unseen("lily", Path(name), [FIVE])


@pytest.fixture(scope="module")
def by_itself() -> dict[str, OnUnseen]:
    """A Lily's file beside itself."""
    return by_model("lily")


def test_a_file_beside_itself(by_itself: dict[str, OnUnseen]) -> None:
    """Both run alike, so that none is worse in any window."""
    for told in by_itself.values():
        assert told.found == told.nominal
        assert told.worse == 0.0


def test_a_vehicle_with_a_fault_errs_more(by_itself: dict[str, OnUnseen]) -> None:
    """The recording is of sound Lilys: a file with a weak thruster turns where they do not."""
    told = by_model("lily_weak_thruster")["heading"]
    assert told.nominal == by_itself["heading"].nominal
    assert told.found > 2.0 * told.nominal
    assert told.worse > 0.5


def test_windows_fill_the_recordings(by_itself: dict[str, OnUnseen]) -> None:
    """As many free runs as have room behind the first tenth; each robot may lose less than one of them."""
    begin, end = read_bag(FIVE).summary.start_ns, read_bag(FIVE).summary.end_ns
    told = by_itself["position"]
    room = ROBOTS * (1.0 - SETTLING) * (end - begin) * 1e-9 / told.seconds
    assert room - ROBOTS - 1 < told.windows <= room + 1
