"""Probabilities of suspects: they add up to 1, follow evidence, share among rivals, and do not contradict the tiers."""

from __future__ import annotations

import math
from dataclasses import replace
from itertools import pairwise
from typing import Any

import pytest

from cocorosim_ros.diagnosis.criteria.naming import NAMING
from cocorosim_ros.diagnosis.criteria.probability import PROBABILITY
from cocorosim_ros.diagnosis.criteria.showing import ESTIMATES
from cocorosim_ros.diagnosis.findings import (
    Comparison,
    Diagnosis,
    FoundEffect,
    PassedOver,
    Rival,
    ScreenedEffect,
    Verdict,
)
from cocorosim_ros.diagnosis.showing.probability import hidden_share, probabilities_of

SHARP = tuple(ScreenedEffect(name, -3.0, {}, 0.01) for name in ("thruster_lag", "tether", "battery_sag", "pump_lag"))
"""Entries that would have shown at any size that counts."""
CONFIRMED_FROM = NAMING.threshold + ESTIMATES.beyond_threshold


def effect(name: str = "thruster_lag", nats: float = 200.0, *rivals: tuple[str, float], **more: Any) -> FoundEffect:
    """An effect as a diagnosis finds it."""
    behind = tuple(Rival(rival, nats_behind) for rival, nats_behind in rivals)
    whole: dict[str, Any] = {"tier": "confirmed", "robots": ("lily_01",)} | more
    tier, robots = whole.pop("tier"), whole.pop("robots")
    return FoundEffect(name, name, "", robots, tier, {}, nats, behind, **whole)


def diagnosis(*effects: FoundEffect, verdict: Verdict | None = None, **more: Any) -> Diagnosis:
    """A diagnosis of good recordings with these effects."""
    found: Verdict = verdict or ("mismatch" if effects else "consistent")
    return Diagnosis(found, "", (), (), effects, (), (), {}, **({"screened": SHARP} | more))


CASES = {
    "one": diagnosis(effect()),
    "rivals": diagnosis(effect("thruster_lag", 20.0, ("sensor_latency", 0.5), ("added_mass", 2.5))),
    "three": diagnosis(effect(), effect("tether", 30.0), effect("unknown:yaw~x", 12.0)),
    "twelve": diagnosis(*(effect(f"made_up_{k}", 15.0, (f"like_{k}", 1.0), because=("No.",)) for k in range(12))),
    "stopped": diagnosis(effect(because=("It stands at a bound.",), tier="suspected")),
    "law": diagnosis(effect("unknown:yaw~x", 40.0)),
    "certain": diagnosis(effect("frame_mixup", 1e4, correction="its sign is flipped")),
    "unlimited": diagnosis(effect("thruster_lag", math.inf)),
    "silent": diagnosis(),
    "near": diagnosis(screened=(ScreenedEffect("tether", 5.0, {}, 0.2), *SHARP)),
    "blind": diagnosis(verdict="insufficient", screened=()),
    "passed over": diagnosis(effect(), passed_over=(PassedOver(effect("tether"), True, (), ""),)),
    "no name": diagnosis(verdict="mismatch", against=Comparison(("good",), (), ())),
}


@pytest.mark.parametrize("name", CASES)
def test_they_add_up_to_one(name: str) -> None:
    """Over the told sets, whatever was found; something else and nothing are always told, and nothing is negative."""
    told = probabilities_of(CASES[name]).told
    assert math.isclose(sum(told.values()), 1.0, abs_tol=1e-12)
    assert {"something else", "nothing"} <= set(told) and min(told.values()) >= 0.0
    assert list(told.values()) == sorted(told.values(), reverse=True)
    assert len(told) <= PROBABILITY.most_told + 2


@pytest.mark.parametrize("name", ["one", "three", "stopped", "law", "certain"])
def test_an_effect_is_as_probable_as_the_sets_that_hold_it(name: str) -> None:
    """Where nearly all sets are told, and no other question may be answered by it."""
    found = probabilities_of(CASES[name])
    for key, share in zip([each.id for each in CASES[name].effects], found.of_effects, strict=True):
        if not key.startswith("unknown:"):
            within = sum(each for told, each in found.told.items() if key in told.split(" + "))
            assert within == pytest.approx(share, abs=0.02)


def test_more_nats_make_it_more_probable() -> None:
    """From the threshold on, every nat counts for an effect and against nothing; nothing is ever excluded."""
    nats = [NAMING.threshold + beyond for beyond in (0.0, 1.0, 2.0, 5.0, 10.0, 20.0)]
    found = [probabilities_of(diagnosis(effect("tether", each))).told for each in nats]
    assert all(one["tether"] < other["tether"] for one, other in pairwise(found))
    assert all(one["nothing"] > other["nothing"] for one, other in pairwise(found))
    certain = probabilities_of(diagnosis(effect("tether", 1e6))).told
    assert certain["tether"] > 0.9 and certain["nothing"] > 0.001 and certain["something else"] > 0.001


def test_rivals_share_by_their_distance() -> None:
    """One at no distance is as probable as the leader; one a nat behind less by the tempered odds of a nat."""
    equal = probabilities_of(diagnosis(effect("thruster_lag", 90.0, ("sensor_latency", 0.0)))).told
    assert equal["thruster_lag"] == pytest.approx(equal["sensor_latency"])
    near = probabilities_of(diagnosis(effect("thruster_lag", 90.0, ("sensor_latency", 1.0)))).told
    assert near["sensor_latency"] / near["thruster_lag"] == pytest.approx(math.exp(-PROBABILITY.temper))
    assert 0.25 < near["sensor_latency"] < near["thruster_lag"] < 0.75


def test_one_effect_by_hand() -> None:
    """The weights of the docstring, with a temper of a half, and no share of effects that would not show."""
    by = replace(PROBABILITY, temper=0.5, unnamed=0.02, chance=0.01)
    told = probabilities_of(diagnosis(effect("tether", NAMING.threshold + 4.0)), by).told
    weights = 1.0, 0.02, 0.01 + math.exp(-2.0)
    assert [told[name] for name in ("tether", "something else", "nothing")] == pytest.approx(
        [each / sum(weights) for each in weights]
    )


def test_two_effects_are_told_together() -> None:
    """The pair is the most probable; the stronger one alone comes before the weaker one alone."""
    found = probabilities_of(diagnosis(effect("tether", 300.0), effect("battery_sag", 40.0)))
    assert next(iter(found.told)) == "battery_sag + tether"
    assert found.told["tether"] > found.told.get("battery_sag", 0.0)
    assert found.of_effects[0] > found.of_effects[1] > 0.5


def test_nothing_is_a_rest_of_axes_that_were_put_right() -> None:
    """The first effect beside a mix-up is as probable as alone."""
    mixed_up = effect("frame_mixup", 1e4, correction="its sign is flipped")
    beside = probabilities_of(diagnosis(mixed_up, effect("tether", 300.0))).of_effects
    assert beside[1] == probabilities_of(diagnosis(effect("tether", 300.0))).of_effects[0] == beside[0]


@pytest.mark.parametrize("others", [(), (effect("battery_sag", 300.0),)])
def test_what_gets_no_name_may_well_be_there(others: tuple[FoundEffect, ...]) -> None:
    """If its evidence stands, something else is as probable as what a hard stop speaks against; else nothing moves."""
    passed, gone = (PassedOver(effect("tether"), stands, (), "") for stands in (True, False))
    plain = probabilities_of(diagnosis(*others))
    verdict: Verdict = "mismatch" if others else "recalibrate"
    stands = probabilities_of(diagnosis(*others, verdict="mismatch", passed_over=(passed,)))
    missing = sum(share for told, share in stands.told.items() if "something else" in told)
    assert missing == pytest.approx(PROBABILITY.stopped, abs=0.02)
    assert missing > 2.0 * plain.told["something else"]
    assert stands.of_effects == plain.of_effects
    assert probabilities_of(diagnosis(*others, verdict=verdict, passed_over=(gone,))) == plain


def test_robots_with_the_same_effect_are_one_suspect() -> None:
    """Three robots with walls of their own are no three sets."""
    one = probabilities_of(diagnosis(effect("wall_effect", 80.0)))
    three = probabilities_of(diagnosis(*(effect("wall_effect", 80.0, robots=(f"lily_{k}",)) for k in range(3))))
    assert one.told == three.told and set(three.of_effects) == set(one.of_effects)
    stopped = effect("wall_effect", 80.0, because=("No.",), tier="suspected")
    assert probabilities_of(diagnosis(effect("wall_effect", 80.0), stopped)).of_effects[1] <= PROBABILITY.stopped


def test_silence_is_mostly_nothing() -> None:
    """Where all would have shown, nearly all; the less would have shown, the less; where nothing would, the least."""
    unsure = tuple(replace(each, seen_from=0.2) for each in SHARP)
    clear, dull, blind = (
        probabilities_of(diagnosis(screened=screened)).told["nothing"] for screened in (SHARP, unsure, ())
    )
    assert clear > 0.9 > dull > 0.5 > blind
    assert blind == pytest.approx(1.0 / (1.0 + PROBABILITY.missing + PROBABILITY.outside))


def test_what_free_runs_lack_may_well_be_there() -> None:
    """Far above the noise floor, without a name: at even odds."""
    found = probabilities_of(diagnosis(verdict="mismatch", beyond_floor=("depth",)))
    assert found.told == pytest.approx({"something else": 0.5, "nothing": 0.5})


def test_a_recalibrated_platform_lacks_nothing() -> None:
    """Numbers that have moved are no physics."""
    assert probabilities_of(diagnosis(verdict="recalibrate")) == probabilities_of(diagnosis())


def test_a_near_miss_has_its_share() -> None:
    """It grows with its nats, but those that sufficed did not stand when it was fitted; one without any is not told."""
    found = [
        probabilities_of(diagnosis(screened=(ScreenedEffect("tether", nats, {}, 0.01), *SHARP))).told
        for nats in (-1.0, 2.0, NAMING.threshold - 0.01, 12.0, 50.0)
    ]
    shares = [told.get("tether", 0.0) for told in found]
    assert all(told["nothing"] > share for told, share in zip(found, shares, strict=True))
    assert shares[0] == 0.0 < shares[3] == shares[4] < shares[1] < shares[2]


def test_the_share_that_hides() -> None:
    """Of sizes from a twentieth to one, all equally probable by their logarithm: half lies below the geometric mean."""
    by = replace(PROBABILITY, smallest=0.05)
    sizes = {0.0: 0.0, 0.05: 0.0, math.sqrt(0.05): 0.5, 1.0: 1.0, 7.0: 1.0, math.inf: 1.0}
    for seen_from, share in sizes.items():
        assert hidden_share([ScreenedEffect("tether", 0.0, {}, seen_from)], by) == pytest.approx(share)
    assert hidden_share([], by) == 1.0
    assert hidden_share([ScreenedEffect(name, 0.0, {}, size) for name, size in (("a", 0.01), ("b", 1.0))], by) == 0.5


@pytest.mark.parametrize("name", ["tether", "unknown:yaw~x"])
def test_a_hard_stop_leaves_at_most_even_odds(name: str) -> None:
    """However many nats: a name that something speaks against is no more probable than not, nor are its rivals."""
    for nats in (9.0, 100.0, 1e4, math.inf):
        found = probabilities_of(diagnosis(effect(name, nats, because=("It stands at a bound.",), tier="suspected")))
        assert found.of_effects[0] <= PROBABILITY.stopped + 1e-12
    among = diagnosis(effect("tether", 90.0, ("steady_current", 0.5), because=("No.",), tier="suspected"))
    told = probabilities_of(among).of_effects[0] + probabilities_of(among).told["steady_current"]
    assert told <= PROBABILITY.stopped + 1e-12


def test_what_differs_is_as_probable_as_such_names_were_right() -> None:
    """Recordings that differ among themselves say little about others."""
    alike, differing = (Comparison(("good",), (), control) for control in ((), ("battery_sag",)))
    assert probabilities_of(diagnosis(effect(), against=alike)).of_effects[0] > 0.9
    doubted = probabilities_of(diagnosis(effect(), against=differing)).of_effects[0]
    assert doubted == pytest.approx(PROBABILITY.stopped_difference)
    stopped = effect(because=("It stands at a bound.",), tier="suspected")
    (difference,), (found,) = (
        probabilities_of(diagnosis(stopped, against=other)).of_effects for other in (alike, None)
    )
    assert difference == pytest.approx(PROBABILITY.stopped_difference) and found <= PROBABILITY.stopped + 1e-12


@pytest.mark.parametrize("name", ["tether", "unknown:yaw~x"])
@pytest.mark.parametrize("beside", [(), (effect("battery_sag", 1e4),)], ids=["first", "further"])
@pytest.mark.parametrize("nats", [CONFIRMED_FROM, 100.0, 1e5])
def test_what_is_confirmed_is_more_probable_than_not(name: str, beside: tuple[FoundEffect, ...], nats: float) -> None:
    """A confirmed effect has no rivals, no stops, and 4 nats beyond the threshold at least."""
    assert probabilities_of(diagnosis(*beside, effect(name, nats))).of_effects[-1] > 0.5


@pytest.mark.parametrize("name", CASES)
def test_grouped_sets_are_the_told_ones(name: str) -> None:
    """In all 1 too; what is told there is told so, but for what SOMETHING_ELSE has taken in."""
    found = probabilities_of(CASES[name])
    assert math.isclose(sum(found.grouped.values()), 1.0, abs_tol=1e-12)
    assert found.grouped["something else"] <= found.told["something else"] + 1e-12
    if name != "twelve":  # whose sets are too many to be kept all
        same = {told: share for told, share in found.grouped.items() if not told.endswith(" + more")}
        assert {told: found.told[told] for told in same if told != "something else"} == pytest.approx(
            {told: share for told, share in same.items() if told != "something else"}
        )


def test_something_else_does_not_hold_what_is_named() -> None:
    """A confirmed effect beside six doubtful ones: hardly a set is without it, though few sets are told."""
    sure = effect("offset_centre", 300.0)
    names = ("thruster_lag", "linear_drag", "sensor_latency", "pose_lever", "battery_sag", "unknown:yaw~v")
    doubtful = (effect(name, 90.0, because=("No.",), tier="suspected") for name in names)
    found = probabilities_of(diagnosis(sure, *doubtful))
    assert found.told["something else"] > 0.5
    assert found.grouped["something else"] < 0.01
    within = sum(share for told, share in found.grouped.items() if "offset_centre" in told.split(" + "))
    assert within == pytest.approx(found.of_effects[0], abs=0.001)
    assert found.grouped["offset_centre + more"] > 0.5


def test_a_law_is_something_else() -> None:
    """What follows a law outside the catalogue has no name: a first one, and one beside an effect."""
    alone = probabilities_of(diagnosis(effect("unknown:yaw~x", 60.0)))
    assert set(alone.told) == {"something else", "nothing"} and alone.told["something else"] > 0.8
    assert alone.of_effects[0] == pytest.approx(alone.told["something else"], abs=0.01)
    both = probabilities_of(diagnosis(effect("tether", 300.0), effect("unknown:yaw~x", 60.0))).told
    assert both["tether"] > 0.0 and both["tether + something else"] > 0.0


def test_a_difference_without_a_name_is_something_else() -> None:
    """A comparison that says that something differs, and not what."""
    told = probabilities_of(CASES["no name"]).told
    assert told == {"something else": PROBABILITY.stopped, "nothing": 1.0 - PROBABILITY.stopped}


def test_the_fit_of_twelve_doubtful_effects_ends() -> None:
    """Of very many sets the least probable are something else, and each effect still has its own probability."""
    found = probabilities_of(CASES["twelve"])
    assert found.told["something else"] > 0.5
    assert all(0.1 < share < PROBABILITY.stopped + 1e-12 for share in found.of_effects)
