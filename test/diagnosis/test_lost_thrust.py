"""Thrust lost against the motion and in the jet of another thruster: named with its number, or not where it is not there.

The swims are the simulator's; what an effect does is compared with closed forms in test/world/motion.
"""

from __future__ import annotations

from typing import Any

import pytest
from hidden_effects import hiding

from cocorosim_ros.diagnosis.diagnose import diagnose
from cocorosim_ros.scenario.parts.platform import load_platform

SECONDS = 150.0


def lily() -> Any:
    """A Lily as she is."""
    return load_platform("lily")


CASES = [pytest.param(lily, "crashback_loss", {"slope": 6.0}, 31, id="crashback_loss")]


@pytest.mark.parametrize(("make", "effect", "numbers", "seed"), CASES)
def test_it_is_named_with_its_number(swim: Any, make: Any, effect: str, numbers: dict[str, float], seed: int) -> None:
    """It alone; the truth lies in the 95 % interval, which is narrower than the number itself."""
    platform = make()
    found = diagnose(
        swim(hiding(platform, {effect: numbers}), SECONDS, seed=seed, base=platform), lambda words, share: None
    )
    assert [each.id for each in found.effects] == [effect]
    for name, true in numbers.items():
        estimate = found.effects[0].parameters[name]
        assert estimate.holds(true) and estimate.high - estimate.low < true, estimate


@pytest.mark.parametrize(
    ("effect", "numbers"), [("advance_loss", {"slope": 2.0}), ("reverse_loss", {"loss": 0.15})], ids=("advance", "reverse")
)
def test_other_losses_keep_their_names(swim: Any, effect: str, numbers: dict[str, float]) -> None:
    """Thrust that falls with speed on both sides of rest, or backwards at every speed, is not lost in crashback."""
    found = diagnose(swim(hiding(lily(), {effect: numbers}), SECONDS, seed=31, base=lily()), lambda words, share: None)
    assert [each.id for each in found.effects] == [effect]


@pytest.mark.parametrize(("make", "seed"), [(lily, 31)])
def test_nothing_is_named_where_nothing_is_wrong(swim: Any, make: Any, seed: int) -> None:
    """The same swims without the effects."""
    found = diagnose(swim(make(), SECONDS, seed=seed), lambda words, share: None)
    assert [each.id for each in found.effects] == []
