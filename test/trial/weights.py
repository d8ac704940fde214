"""Fits the weights of probabilities (`criteria.probability` of the tool) to a sealed trial that has been opened.

The weights maximise the logarithm of the probability that was told of what came true (Good, J. Royal Statistical
Society B 14 (1952) 107: a proper score), plus that of a prior: logarithms of weights are normal around those of START.
Cross-validation says what the weights are worth on recordings that they were not fitted to.
"""

from __future__ import annotations

import json
import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from concealer.calibration import brier, calibration, came_true, told
from concealer.cases import Case
from concealer.score import opened
from concealer.score_text import probabilities_text
from concealer.seal import LEDGER
from scipy.optimize import minimize
from trial.provenance import noted

if TYPE_CHECKING:
    from cocorosim_ros.diagnosis.criteria.probability import ProbabilityCriteria
    from cocorosim_ros.diagnosis.findings import Diagnosis

# Where the fit begins. Of 172 first names of docs/trial.json one was something else and one nothing, of 46 further ones
# seven were a rest; laws among them were right where they came first (18 of 19), and never beside an effect. Odds of
# 0.65 to 0.35 that something is hidden, of 0.15 to 0.35 that it is more than one effect, are those of
# test/concealer/prior.yaml. How far nats are to be believed is a guess.
START = {
    "temper": 0.5, "unnamed": 0.01, "chance": 0.01, "rest": 0.15, "law": 0.05, "rest_by_law": 0.6,
    "missing": 0.65 / 0.35, "further": 0.15 / 0.35, "outside": 0.02,
}  # fmt: skip
DOUBT = 0.25  # standard deviation of the logarithm of a weight before any recording; up to 1 it is worth the same
FOLDS = 5
LEAST = 1e-4  # probability: what is not told at all is no more than that
# Bounds that keep a confirmed effect more probable than not, whatever the sample: 4 nats are the least of such a one.
BOUNDS = {"temper": (0.3, 1.0), "rest_by_law": (1e-4, 0.6), "rest": (1e-4, 0.6)}


@dataclass(frozen=True)
class Opened:
    """What a diagnosis found, beside the truth."""

    found: Diagnosis
    case: Case


def of_trial(out: Path) -> list[Opened]:
    """All recordings of a trial that have a diagnosis which says what it screened."""
    folders = sorted(path.parent for path in (out / "trial").glob(f"*/{LEDGER}"))
    cases = [case for folder in folders for case in opened(folder, out / "diagnoses" / folder.name, folder.name)]
    return [Opened(_found(case.diagnosis), case) for case in cases if case.diagnosis and "screened" in case.diagnosis]


def _found(tree: dict[str, Any]) -> Diagnosis:
    """What probabilities are made of, back from the file of a diagnosis."""
    from cocorosim_ros.diagnosis.findings import Diagnosis, FoundEffect, Rival, ScreenedEffect
    from cocorosim_ros.diagnosis.report.words import reasons_of

    def number(value: float | None) -> float:
        return math.inf if value is None else value

    effects = [
        FoundEffect(
            each["id"], each["name"], "", tuple(each["robots"]), each["tier"], {}, number(each["nats"]),
            tuple(Rival(rival["id"], number(rival["nats_behind"])) for rival in each["ambiguous_with"]),
        )
        for each in tree["effects"]
    ]  # fmt: skip
    # A sentence that rivals or held-out data alone give is no objection to the fit.
    told = [tuple(each["because"]) for each in tree["effects"]]
    effects = [
        each if why == reasons_of(each) else replace(each, because=why) for each, why in zip(effects, told, strict=True)
    ]
    screened = [
        ScreenedEffect(name, -math.inf if each["nats"] is None else each["nats"], {}, number(each["seen_from"]))
        for name, each in tree["screened"].items()
    ]
    return Diagnosis(tree["verdict"], "", (), (), tuple(effects), (), (), {}, screened=tuple(screened))


def told_by(some: Sequence[Opened], weights: ProbabilityCriteria) -> list[Case]:
    """The cases with the probabilities that these weights make of what was found."""
    from cocorosim_ros.diagnosis.showing.probability import probabilities_of

    cases = []
    for each in some:
        believed, tree = probabilities_of(each.found, weights), each.case.diagnosis or {}
        effects = [
            effect | {"probability": share} for effect, share in zip(tree["effects"], believed.of_effects, strict=True)
        ]
        answer = tree | {"probabilities": dict(believed.told), "effects": effects}
        cases.append(replace(each.case, diagnosis=answer))
    return cases


def scores(cases: Sequence[Case]) -> np.ndarray:
    """(n, 2) logarithm of the probability of what came true, and Brier's score, of each recording."""
    answers = [(told(case), came_true(case)) for case in cases]
    return np.array([(math.log(max(shares[right], LEAST)), brier(shares, right)) for shares, right in answers])


def fitted(some: Sequence[Opened], doubt: float = DOUBT) -> ProbabilityCriteria:
    """The weights that fit best; doubt: standard deviation of their logarithms before any recording."""
    centre = np.log(list(START.values()))
    ends = [BOUNDS.get(name, (1e-4, 20.0)) for name in START]

    def cost(logs: np.ndarray) -> float:
        return 0.5 * float(np.sum(((logs - centre) / doubt) ** 2)) - float(
            scores(told_by(some, _weights(logs)))[:, 0].sum()
        )

    found = minimize(cost, centre, method="L-BFGS-B", bounds=[(math.log(low), math.log(high)) for low, high in ends])
    return _weights(found.x)


def _weights(logs: np.ndarray) -> ProbabilityCriteria:
    """The tool's numbers with others in the place of those that are fitted, whose logarithms are given."""
    from cocorosim_ros.diagnosis.criteria.probability import PROBABILITY

    return replace(PROBABILITY, **dict(zip(START, np.exp(logs).tolist(), strict=True)))


def cross_validated(some: Sequence[Opened]) -> list[Case]:
    """The cases with the probabilities of weights that were fitted to the other folds."""
    cases: dict[int, Case] = {}
    for fold in range(FOLDS):
        mine = [place for place in range(len(some)) if place % FOLDS == fold]
        others = [each for place, each in enumerate(some) if place % FOLDS != fold]
        cases |= dict(zip(mine, told_by([some[place] for place in mine], fitted(others)), strict=True))
    return [cases[place] for place in range(len(some))]


def prove(out: Path, pages: Path | None = None) -> int:
    """Prints the weights that fit best, what weights are worth here, and how often what they tell comes true.

    pages: folder for the reliability diagram and the figures of the tool's own weights.
    """
    from cocorosim_ros.diagnosis.criteria.probability import PROBABILITY

    some = of_trial(out)
    best = fitted(some)
    print(json.dumps({name: float(f"{getattr(best, name):.3g}") for name in START}, indent=1))
    ways = {
        "the tool's": told_by(some, PROBABILITY),
        "where the fit begins": told_by(some, replace(PROBABILITY, **START)),
        "fitted": told_by(some, best),
        "fitted to the other folds": cross_validated(some),
    }
    for words, cases in ways.items():
        log, square = scores(cases).mean(axis=0).tolist()
        print(f"{words}: logarithm {log:.4f}, Brier's score {square:.4f}, {len(some)} recordings")
    for words in ("the tool's", "fitted to the other folds"):
        print("\n".join(["", f"# Weights: {words}", "", *probabilities_text(calibration(ways[words]))]))
    if pages is not None:
        _write(pages, calibration(ways["the tool's"]), noted(out, ""))
    return 0


def _write(pages: Path, found: dict[str, Any], source: dict[str, Any]) -> None:
    """The reliability diagram, and the figures with what made the recordings."""
    from trial.reliability_picture import draw

    pages.mkdir(parents=True, exist_ok=True)
    draw(found, pages / "reliability.svg")
    text = json.dumps({"source": source, "probabilities": found}, indent=1)
    (pages / "trial_probabilities.json").write_text(f"{text}\n", encoding="utf-8")
