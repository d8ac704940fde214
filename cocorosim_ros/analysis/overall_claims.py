"""Claims that sum others up: S19 and S20 of the four variants of boids, T4 and T5 of turbulence.

A detriment is a large effect in the direction that the paper calls worse: less polarised, slower, more robots lost,
more shoals.
Source: Read et al. 2013, sections 5 and 5.1.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from cocorosim_ros.analysis.answers import NO_RUNS, NOT_REPRODUCED, REPRODUCED, Answer, all_of
from cocorosim_ros.analysis.claims import HIGHER, LOWER, NOT_LARGE, verdict_of
from cocorosim_ros.analysis.effect_size import Effect, effect
from cocorosim_ros.analysis.results import Results
from cocorosim_ros.metrics import PAPER_METRICS

WORSE = {"polarisation": LOWER, "shoal_speed": LOWER, "lost": HIGHER, "shoals": HIGHER}
_OPPOSITE = {HIGHER: LOWER, LOWER: HIGHER}
SPARED = 4  # of the six metrics, at least: "only 2 of the 6 metrics"


def overall_answers(experiments: Mapping[str, Results]) -> Iterator[Answer]:
    """S19, S20, T4 and T5 in every kind of numerics of the designs that are there."""
    if "boids" in experiments:
        for numerics in experiments["boids"].numerics:
            yield _no_detriment(experiments["boids"], numerics)
            yield _detriment(experiments["boids"], numerics)
    if "turbulence" in experiments:
        for numerics in experiments["turbulence"].numerics:
            yield _minor(experiments["turbulence"], numerics)
            yield _tolerated(experiments["turbulence"], numerics)


def _effect(results: Results, numerics: str, group: str, metric: str) -> Effect:
    return effect(results.values(numerics, group, metric), results.values(numerics, results.baseline, metric))


def _no_detriment(results: Results, numerics: str) -> Answer:
    verdicts, worse = [], []
    for group in ("BLT", "BLC"):
        for metric, bad in WORSE.items():
            found = _effect(results, numerics, group, metric)
            verdicts.append(spared(bad, found))
            if verdicts[-1] == NOT_REPRODUCED:
                worse.append(f"{group} {metric.replace('_', ' ')} {bad}, A = {found.value:.3f}")
    ours = "detriment: " + "; ".join(worse) if worse else "no large detriment"
    return Answer("S19", "BLT and BLC against Van", "no significant detriment", numerics, ours, all_of(verdicts))


def spared(bad: str, found: Effect) -> str:
    """Whether it is reproduced that an effect is not a large one in the bad direction."""
    if found.direction == _OPPOSITE[bad]:
        return REPRODUCED
    return verdict_of(NOT_LARGE, found)


def _detriment(results: Results, numerics: str) -> Answer:
    parts = [
        (metric, WORSE[metric], _effect(results, numerics, "NA", metric))
        for metric in ("polarisation", "shoal_speed", "lost")
    ]
    ours = "; ".join(
        f"{metric.replace('_', ' ')} {found.direction}, A = {found.value:.3f}" for metric, _, found in parts
    )
    verdict = all_of(verdict_of(bad, found) for _, bad, found in parts)
    return Answer("S20", "NA against Van", "less polarised, slower, more lost", numerics, ours, verdict)


def _minor(results: Results, numerics: str) -> Answer:
    """T4: in polarisation and speed, the medians of T5e-4 are nearer to those of T0 than those of T5e-3 are."""
    words, verdicts = [], []
    for metric in ("polarisation", "shoal_speed"):
        still, weak, strong = (results.spread(numerics, group, metric) for group in ("T0", "T5e-4", "T5e-3"))
        if 0 in (still.runs, weak.runs, strong.runs):
            verdicts.append(NO_RUNS)
            continue
        words.append(f"{metric.replace('_', ' ')} {still.median:.3g}, {weak.median:.3g}, {strong.median:.3g}")
        nearer = abs(weak.median - still.median) < abs(strong.median - still.median)
        verdicts.append(REPRODUCED if nearer else NOT_REPRODUCED)
    subject = "medians of T0, T5e-4, T5e-3"
    return Answer("T4", subject, "T5e-4 minor beside T5e-3", numerics, "; ".join(words), all_of(verdicts))


def _tolerated(results: Results, numerics: str) -> Answer:
    """T5: at least four of the six metrics show no large effect of weak turbulence."""
    found = {metric: _effect(results, numerics, "T5e-4", metric) for metric in PAPER_METRICS}
    large = [name.replace("_", " ") for name, effect_ in found.items() if effect_.size == "large"]
    verdict = REPRODUCED if len(PAPER_METRICS) - len(large) >= SPARED else NOT_REPRODUCED
    if any(effect_.size == "undefined" for effect_ in found.values()):
        verdict = NO_RUNS
    ours = f"large in {len(large)} of 6" + (": " + ", ".join(large) if large else "")
    return Answer("T5", "T5e-4 against T0", "the shoal tolerates weak turbulence", numerics, ours, verdict)
