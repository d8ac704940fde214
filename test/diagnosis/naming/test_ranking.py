"""Which of several candidates is named first, where recordings that should be alike differ too."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any, cast

import pytest

from cocorosim_ros.diagnosis.fitting.candidate import Candidate
from cocorosim_ros.diagnosis.naming.choice import Choice
from cocorosim_ros.diagnosis.naming.contest import Refined
from cocorosim_ros.diagnosis.naming.ranking import by_rank, near_rivals

STAGE: Any = SimpleNamespace(named=())


class Named(SimpleNamespace):
    """A candidate as the ranking looks at it."""

    def widens(self, other: Any) -> bool:
        """As candidates do."""
        return Candidate.widens(cast("Any", self), other)


def refined(name: str, nats: float, usual: float = 0.0, numbers: tuple[str, ...] = ()) -> Refined:
    """A candidate with evidence beyond the usual, and the usual that was taken off."""
    amplitudes = [SimpleNamespace(column=column) for column in numbers]
    entry = SimpleNamespace(id=name, law=None, channel="surge", topic=None, amplitudes=amplitudes)
    candidate: Any = Named(entry=entry, spread=(nats + usual) / nats, key=(name, None, ("a",)), robots=("a",))
    fit: Any = SimpleNamespace(unknowns=())
    return Refined(candidate, fit, nats, usual)


def names(found: list[Refined]) -> list[str]:
    """Names in their order."""
    return [each.candidate.entry.id for each in found]


def test_what_explains_the_readings_best_leads_although_alike_recordings_differ_in_it() -> None:
    """A delay with 540 nats, of which 440 are usual, before a lag with 200, of which hardly any are."""
    assert names(by_rank([refined("lag", 190.0, 10.0), refined("delay", 100.0, 440.0)], STAGE)) == ["delay", "lag"]


def test_what_is_usual_gives_way_where_both_explain_as_much() -> None:
    """A candidate of which alike recordings differ by 38 times their noise is not ahead by 40 nats of 380."""
    assert names(by_rank([refined("lever", 10.0, 370.0), refined("gain", 330.0, 10.0)], STAGE)) == ["gain", "lever"]


@pytest.mark.parametrize(("ahead", "first"), [(1.9, "offset"), (-1.0, "offset"), (3.5, "drift")])
def test_a_number_more_has_to_be_worth_it(ahead: float, first: str) -> None:
    """A drift of 100 nats more than nothing is an offset, if the offset alone explains all but 1.9 of them."""
    offset = refined("offset", 100.0, numbers=("offset",))
    drift = refined("drift", 100.0 + ahead, numbers=("rate", "offset"))
    latency = refined("latency", 99.5 + ahead, numbers=("latency",))
    order = names(by_rank([drift, latency, offset], STAGE))
    assert next(each for each in order if each != "latency") == first
    assert set(order) == {"offset", "drift", "latency"}


def test_what_is_no_more_than_usual_is_not_ranked() -> None:
    """It explains more than anything else, as it does in recordings that are alike."""
    assert names(by_rank([refined("lever", 4.0, 900.0), refined("gain", 30.0, 10.0)], STAGE)) == ["gain"]


@pytest.mark.parametrize("nats", [(9.0, 30.0, 12.0), (30.0, 29.0, 28.0), (5.0, 3.0, 40.0)])
def test_without_anything_usual_evidence_alone_ranks(nats: tuple[float, ...]) -> None:
    """As in a diagnosis of a platform's file; also of what has too little evidence, which ends the search."""
    found = by_rank([refined(str(each), each) for each in nats], STAGE)
    assert names(found) == [str(each) for each in sorted(nats, reverse=True)]


def test_a_rival_is_one_that_explains_nearly_as_much(monkeypatch: pytest.MonkeyPatch) -> None:
    """20 nats less are 2 where alike recordings differ by ten times their noise; without that they are 20."""
    for check in ("is_beyond_instrument", "is_at_its_limit"):
        monkeypatch.setattr(f"cocorosim_ros.diagnosis.naming.ranking.{check}", lambda candidate, fit: False)
    best, late = refined("delay", 100.0, 900.0), refined("latency", 98.0, 882.0)
    (rival,) = near_rivals(best, [best, late, refined("lag", 700.0)], None)
    assert rival.candidate is late.candidate
    assert rival.behind == pytest.approx(2.0)
    best = refined("delay", 1000.0)
    assert near_rivals(best, [best, refined("latency", 980.0)], None) == []


@pytest.mark.parametrize(
    ("topic", "behind", "is_rival"), [("pose", 7.0, True), ("pose", 9.0, False), ("velocity", 7.0, False)]
)
def test_another_instrument_is_a_rival_from_further_behind(
    monkeypatch: pytest.MonkeyPatch, topic: str, behind: float, is_rival: bool
) -> None:
    """Where a comparison asks for eight nats between two instruments; errors of one instrument need three."""
    for check in ("is_beyond_instrument", "is_at_its_limit"):
        monkeypatch.setattr(f"cocorosim_ros.diagnosis.naming.ranking.{check}", lambda candidate, fit: False)
    nothing: Any = None
    choice = Choice(nothing, nothing, instruments_apart=8.0)
    monkeypatch.setattr(Choice, "excludes", lambda self, best, other: False)
    best, other = refined("speed_log_scale", 100.0), refined("other", 100.0 - behind)
    best.candidate.entry.topic, other.candidate.entry.topic = "velocity", topic
    assert len(near_rivals(best, [best, other], choice)) == is_rival
    strong, other = refined("speed_log_scale", 1e5), refined("other", 1e5 - 150.0 * behind)
    strong.candidate.entry.topic, other.candidate.entry.topic = "velocity", topic
    shared = Choice(nothing, nothing, instruments_apart=8.0, instruments_share=0.012)
    assert len(near_rivals(strong, [strong, other], shared)) == is_rival  # 1.05 and 1.35 % behind
