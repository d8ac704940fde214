"""A difference whose size may as well be nothing is said to be in doubt, by its name, and not named as an effect."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from cocorosim_ros.diagnosis import diagnose_against
from cocorosim_ros.diagnosis.findings import Estimate, FoundEffect

WEAK, LAG = "thruster_gain:right", "thruster_lag"


def effect(name: str) -> FoundEffect:
    """A difference of a number."""
    return FoundEffect(name, name, "", ("boat",), "suspected", {"number": Estimate(0.8, 0.6, 1.1, "1")}, 25.0)


@pytest.mark.parametrize(("doubted", "kept"), [((), (WEAK, LAG)), ((WEAK,), (LAG,)), ((WEAK, LAG), ())])
def test_what_may_be_nothing_is_kept_apart(doubted: tuple[str, ...], kept: tuple[str, ...]) -> None:
    """By name and in its order; each has a sentence of its own, and the verdict still says that something differs."""
    named = [
        SimpleNamespace(
            candidate=SimpleNamespace(
                entry=SimpleNamespace(id=name, topic=None, may_be_nothing=lambda numbers, name=name: name in doubted)
            )
        )
        for name in (WEAK, LAG)
    ]
    naming: Any = SimpleNamespace(named=named)
    left, names = diagnose_against._beyond_doubt(naming, (effect(WEAK), effect(LAG)))
    assert (tuple(each.id for each in left), names) == (kept, doubted)
    sentences = diagnose_against._of_vague(names)
    assert len(sentences) == len(doubted)
    assert all(f"'{name}'" in told and "cannot tell" in told for name, told in zip(doubted, sentences, strict=True))
    assert diagnose_against._verdict((*left, *names), (), (), "") == "mismatch"


def test_an_error_of_readings_that_was_passed_over_as_a_trace_is_in_doubt() -> None:
    """By effect and stream, once each; laws outside the catalogue, and what is named after all, are left out."""

    def entry(name: str, topic: str | None, law: Any = None) -> Any:
        return SimpleNamespace(entry=SimpleNamespace(id=name, topic=topic, law=law))

    late = entry("sensor_latency", "pressure")
    found = [late, late, entry("unknown:pressure~w", "pressure", "w"), entry("gyro_scale", "imu")]
    naming: Any = SimpleNamespace(named=[SimpleNamespace(candidate=entry("gyro_scale", "imu"))], traces=found)
    names = diagnose_against._traces(naming)
    assert names == ("sensor_latency:pressure",)
    (sentence,) = diagnose_against._of_traces(names)
    assert "'sensor_latency:pressure'" in sentence and "cannot tell" in sentence
