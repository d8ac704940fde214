"""A difference whose size may as well be nothing is said to be in doubt, by its name, and not named as an effect."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from cocorosim_ros.diagnosis import diagnose_against
from cocorosim_ros.diagnosis.against import doubt_sentences
from cocorosim_ros.diagnosis.against.differences import _louder
from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES
from cocorosim_ros.diagnosis.findings import Estimate, FoundEffect, Recalibrated

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
    sentences = doubt_sentences.doubts(doubt_sentences.VAGUE, names)
    assert len(sentences) == len(doubted)
    assert all(f"'{name}'" in told and "cannot tell" in told for name, told in zip(doubted, sentences, strict=True))
    assert diagnose_against._verdict((*left, *names), (), (), "") == "mismatch"


@pytest.mark.parametrize(("low", "high", "is_named"), [(0.03, 0.17, True), (0.02, 0.18, False), (-0.01, 0.21, False)])
def test_the_best_of_many_needs_more_than_the_usual_sureness(low: float, high: float, is_named: bool) -> None:
    """Around 0.1: what is 2.8 standard deviations from nothing has a name, what is 2.45 or less has not."""
    (entry,) = (each for each in ENTRIES if each.id == "thruster_misalignment")
    naming: Any = SimpleNamespace(named=[SimpleNamespace(candidate=SimpleNamespace(entry=entry))])
    numbers = {"angle": Estimate(0.1, low, high, "rad")}
    askew = FoundEffect(entry.id, "", "", ("boat",), "suspected", numbers, 25.0)
    left, names = diagnose_against._beyond_doubt(naming, (askew,))
    assert (left, names) == (((askew,), ()) if is_named else ((), (entry.id,)))


def test_an_error_of_readings_that_was_passed_over_as_a_trace_is_in_doubt() -> None:
    """By effect and stream, once each; laws outside the catalogue, and what is named after all, are left out."""

    def entry(name: str, topic: str | None, law: Any = None) -> Any:
        return SimpleNamespace(entry=SimpleNamespace(id=name, topic=topic, law=law))

    late = entry("sensor_latency", "pressure")
    found = [late, late, entry("unknown:pressure~w", "pressure", "w"), entry("gyro_scale", "imu")]
    naming: Any = SimpleNamespace(named=[SimpleNamespace(candidate=entry("gyro_scale", "imu"))], traces=found)
    names = doubt_sentences.names_of(naming, naming.traces)
    assert names == ("sensor_latency:pressure",)
    (sentence,) = doubt_sentences.doubts(doubt_sentences.TRACE, names)
    assert "'sensor_latency:pressure'" in sentence and "cannot tell" in sentence


@pytest.mark.parametrize(
    ("low", "high", "is_clear"),
    [(0.7, 0.9, True), (1.1, 1.4, True), (0.4, 6.0, False), (0.5, 1.0, False), (0.7, 0.94, True), (0.6, 0.97, False)],
)
def test_a_number_whose_interval_holds_what_it_was_has_not_clearly_moved(
    low: float, high: float, is_clear: bool
) -> None:
    """It is kept apart by its name; the interval is that of 99 %, 2.576 / 1.96 times as wide as that of 95 %."""
    number = Recalibrated("drag", 1.0, Estimate(0.8, low, high, "kg/m"), ("boat",))
    clear, vague = diagnose_against._clearly_moved([number])
    assert (clear, vague) == (((number,), ()) if is_clear else ((), ("drag",)))


@pytest.mark.parametrize(
    ("nats", "spread", "is_rival"), [(8.0, 6.0, True), (8.0, 3.0, False), (2.0, 60.0, False), (4.5, 7.0, True)]
)
def test_what_the_readings_speak_louder_for_is_a_rival(nats: float, spread: float, is_rival: bool) -> None:
    """Beside 10 nats with a spread of 1.5: twice as many before they are divided, and half the threshold after it."""
    found: Any = SimpleNamespace(nats=10.0, candidate=SimpleNamespace(key="yaw_drag", spread=1.5))
    other: Any = SimpleNamespace(nats=nats, candidate=SimpleNamespace(key="thruster_gain", spread=spread))
    same: Any = SimpleNamespace(nats=90.0, candidate=found.candidate)
    assert _louder(found, [same, other]) == ([other.candidate] if is_rival else [])


def test_what_may_stand_in_for_a_rival_is_told_with_it() -> None:
    """In one sentence; without rivals there is none."""
    (sentence,) = doubt_sentences.of_unsettled(("yaw_drag", "thruster_gain:left", "added_mass"))
    assert "'yaw_drag' may differ, or stand in for 'thruster_gain:left' or 'added_mass'" in sentence
    assert "cannot tell" in sentence
    assert doubt_sentences.of_unsettled(()) == ()
