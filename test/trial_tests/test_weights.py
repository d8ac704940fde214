"""Weights of probabilities, fitted to diagnoses and truths that are made by hand."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np


def tree(verdict: str, *effects: tuple[str, float], seen_from: float = 0.01) -> dict[str, Any]:
    """What a fit looks at in the file of a diagnosis."""
    rest = {"name": "", "robots": ["lily_01"], "tier": "confirmed", "ambiguous_with": [], "because": []}
    return {
        "verdict": verdict,
        "effects": [{"id": name, "nats": nats} | rest for name, nats in effects],
        "screened": {"tether": {"nats": -2.0, "seen_from": seen_from}, "pump_lag": {"nats": None, "seen_from": None}},
    }


def opened(hidden: list[str], found: dict[str, Any]) -> Any:
    """A diagnosis beside its truth."""
    from concealer.cases import Case
    from trial.weights import Opened, _found

    secrets = [{"id": name, "topic": None, "twins": []} for name in hidden]
    return Opened(_found(found), Case({"recording": "r", "effects": secrets}, found))


def test_the_file_tells_all_that_probabilities_need() -> None:
    """What is made of the file of a diagnosis is what the diagnosis itself told."""
    from trial.weights import _found

    from cocorosim_ros.diagnosis.findings import Diagnosis, FoundEffect, Rival, ScreenedEffect
    from cocorosim_ros.diagnosis.report.json_file import diagnosis_tree

    effect = FoundEffect(
        "tether", "a tether", "", ("lily_01",), "suspected", {}, 12.0, (Rival("steady_current", 1.2),),
        because=("It stands at a bound.",),
    )  # fmt: skip
    screened = (ScreenedEffect("tether", 11.0, {}, 0.3), ScreenedEffect("pump_lag", -np.inf, {}, np.inf))
    for effects in ((effect,), (effect, replace(effect, id="unknown:yaw~x", because=())), ()):
        verdict: Any = "mismatch" if effects else "consistent"
        told = diagnosis_tree(Diagnosis(verdict, "", (), (), effects, (), (), {}, screened=screened))
        assert diagnosis_tree(_found(told))["probabilities"] == told["probabilities"]


def test_the_picture_is_the_same_every_time(tmp_path: Path) -> None:
    """An SVG with a dot for every class; twice the same bytes."""
    from trial.reliability_picture import draw

    row = {"from": 0.7, "to": 0.9, "mean": 0.8, "rate": 2 / 3, "low": 0.2, "high": 0.9, "hits": 2, "of": 3}
    for name in ("one.svg", "other.svg"):
        draw({"by_most_probable": [row], "by_any": [row, row]}, tmp_path / name)
    text = (tmp_path / "one.svg").read_text("utf-8")
    assert text == (tmp_path / "other.svg").read_text("utf-8") and text.count("<use ") >= 3


def test_the_fit_follows_what_came_true() -> None:
    """Further names that are mostly a rest are believed less than where the fit begins, those that are right more."""
    from trial.weights import START, fitted

    found = tree("mismatch", ("tether", 400.0), ("pump_lag", 60.0))
    wrong = fitted([opened(["tether"], found)] * 30 + [opened(["tether", "pump_lag"], found)] * 10, 1.0)
    right = fitted([opened(["tether", "pump_lag"], found)] * 40, 1.0)
    assert wrong.rest == 0.6 > START["rest"] > right.rest  # at its bound: a confirmed effect stays the more probable


def test_the_fit_finds_the_rate_of_what_is_passed_over() -> None:
    """Of 200 silent recordings, all alike, 50 hide something: weights make just that of it, but for the prior."""
    from trial.weights import fitted

    from cocorosim_ros.diagnosis.showing.probability import probabilities_of

    found = tree("consistent", seen_from=0.2)
    some = [opened([], found)] * 150 + [opened(["battery_sag"], found)] * 50
    told = probabilities_of(some[0].found, fitted(some, 1.0)).told
    assert abs(told["something else"] - 0.25) < 0.02


def test_scores_are_of_what_came_true() -> None:
    """The logarithm of the probability of the right answer; other folds are scored by weights that never saw them."""
    from trial.weights import cross_validated, fitted, scores, told_by

    from cocorosim_ros.diagnosis.criteria.probability import PROBABILITY
    from cocorosim_ros.diagnosis.showing.probability import probabilities_of

    one, other = opened(["tether"], tree("mismatch", ("tether", 90.0))), opened([], tree("consistent"))
    told = [probabilities_of(each.found).told for each in (one, other)]
    assert np.allclose(
        scores(told_by([one, other], PROBABILITY))[:, 0], np.log([told[0]["tether"], told[1]["nothing"]])
    )
    some = [one, other] * 5
    of_others = told_by([one], fitted([*some[1:5], *some[6:]]))
    assert np.allclose(scores(cross_validated(some))[0], scores(of_others)[0])
