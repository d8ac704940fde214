"""What steers by angles that nothing reports may turn slowly, which looks like commands that act late."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES
from cocorosim_ros.diagnosis.showing.slow_steering import slow_steering


def case_of(name: str, *, steers: bool, reported: str, compared: bool = False) -> Any:
    """A case of a vehicle with a propeller and perhaps a rudder, which names an effect; reported: a quantity."""
    track = SimpleNamespace(
        vehicle=SimpleNamespace(is_steering=np.array([False, steers])),
        log=SimpleNamespace(feedback=(SimpleNamespace(quantity=reported),)),
    )
    entry = next(each for each in ENTRIES if each.id == name)
    named = SimpleNamespace(candidate=SimpleNamespace(entry=entry, robots=("boat",), everybody=(0,)))
    found = SimpleNamespace(id=name, topic=entry.topic, robots=("boat",))
    base = None if compared else object()
    return SimpleNamespace(final=SimpleNamespace(tracks=[track]), named=[named], found=[found], base=base)


@pytest.mark.parametrize("name", ["command_delay", "thruster_lag"])
def test_a_rudder_whose_angle_is_unknown(name: str) -> None:
    """Late commands and lags are doubted, and it is said what would tell."""
    (objection,) = slow_steering(case_of(name, steers=True, reported="rotation"))
    assert objection.effect.id == name and "Record the angles" in objection.sentence


@pytest.mark.parametrize(
    "more",
    [
        {"name": "command_delay", "steers": False, "reported": "rotation"},
        {"name": "command_delay", "steers": True, "reported": "angle"},
        {"name": "torque_bias", "steers": True, "reported": "rotation"},
        {"name": "command_delay", "steers": True, "reported": "rotation", "compared": True},
    ],
    ids=["no rudder", "angle reported", "no delay", "a change, of a rudder as slow before"],
)
def test_nothing_is_said_elsewhere(more: dict[str, Any]) -> None:
    """Of vehicles without angles, of angles that are known, of other effects, of changes."""
    assert list(slow_steering(case_of(**more))) == []
