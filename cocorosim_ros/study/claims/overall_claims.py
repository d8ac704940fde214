"""Claims that sum others up: S19 and S20 of the four variants of boids, T4 and T5 of turbulence.

A detriment is a large effect in the direction that the paper calls worse: less polarised, slower, more robots lost,
more shoals. All verdicts follow from intervals, as those on single claims do: a sum of open parts may be open too.
Source: Read et al. 2013, sections 5 and 5.1.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.study.claims.answers import (
    DASH,
    NO_RUNS,
    NOT_DECIDABLE,
    NOT_REPRODUCED,
    REPRODUCED,
    Answer,
    above,
    all_of,
    denied,
)
from cocorosim_ros.study.claims.claims import HIGHER, LOWER, NOT_LARGE, shown, verdict_of, with_interval
from cocorosim_ros.study.metrics import PAPER_METRICS
from cocorosim_ros.study.results.bootstrap import LEAST, bootstrap_interval
from cocorosim_ros.study.results.effect_size import Effect, effect
from cocorosim_ros.study.results.results import Results

WORSE = {"polarisation": LOWER, "shoal_speed": LOWER, "lost": HIGHER, "shoals": HIGHER}
TOLERABLE = 2  # large effects of six, at most: "only 2 of the 6 metrics"


class _Case(NamedTuple):
    """One effect: what of, and what the paper says about it."""

    name: str
    paper: str
    effect: Effect


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
    """S19: no effect of the eight is large in the direction that is worse."""
    found = [
        _Case(f"{group} {metric}", bad, _effect(results, numerics, group, metric))
        for group in ("BLT", "BLC")
        for metric, bad in WORSE.items()
    ]
    verdicts = [spared(case.paper, case.effect) for case in found]
    sorts = {"detriment": NOT_REPRODUCED, "open": NOT_DECIDABLE}
    ours = _listed({words: _named(found, verdicts, verdict) for words, verdict in sorts.items()})
    if NO_RUNS in verdicts:
        ours = DASH
    elif not ours:
        nearest = max(found, key=lambda case: _reach(case.paper, case.effect))
        ours = f"no large detriment; nearest to one is {_in_words(nearest.name, nearest.effect)}"
    return Answer("S19", "BLT and BLC against Van", "no significant detriment", numerics, ours, all_of(verdicts))


def spared(bad: str, found: Effect) -> str:
    """The verdict on an effect that is claimed not to be a large one in the bad direction."""
    return denied(verdict_of(bad, found))


def _reach(bad: str, found: Effect) -> float:
    """How far the interval of A goes in the bad direction."""
    return found.high if bad == HIGHER else 1.0 - found.low


def _detriment(results: Results, numerics: str) -> Answer:
    """S20: NA is less polarised, slower and loses more, each by a large effect."""
    parts = [
        (metric, WORSE[metric], _effect(results, numerics, "NA", metric))
        for metric in ("polarisation", "shoal_speed", "lost")
    ]
    ours = "; ".join(_in_words(metric, found) for metric, _, found in parts)
    verdict = all_of(verdict_of(bad, found) for _, bad, found in parts)
    return Answer("S20", "NA against Van", "less polarised, slower, more lost", numerics, ours, verdict)


def _minor(results: Results, numerics: str) -> Answer:
    """T4: in polarisation and speed, the medians of T5e-4 are nearer to those of T0 than those of T5e-3 are."""
    words, verdicts = [], []
    for metric in ("polarisation", "shoal_speed"):
        samples = [_known(results, numerics, group, metric) for group in ("T0", "T5e-4", "T5e-3")]
        if not all(sample.size for sample in samples):
            verdicts.append(NO_RUNS)
            continue
        medians = ", ".join(f"{np.median(sample):.3g}" for sample in samples)
        low, high = bootstrap_interval(samples, further)
        found = f"{further(*samples):.2g} ({low:.2g} to {high:.2g})" if low <= high else f"unknown below {LEAST} runs"
        words.append(f"{_plain(metric)} {medians}, T5e-3 further off by {found}")
        verdicts.append(above(0.0, low, high))
    subject = "medians of T0, T5e-4, T5e-3"
    return Answer("T4", subject, "T5e-4 minor beside T5e-3", numerics, "; ".join(words) or DASH, all_of(verdicts))


def further(still: Floats, weak: Floats, strong: Floats) -> Floats:
    """By how much the median of `strong` (..., runs) is further off that of `still` than that of `weak` is."""
    base, near, far = (np.median(sample, axis=-1) for sample in (still, weak, strong))
    more: Floats = np.abs(far - base) - np.abs(near - base)
    return more


def _known(results: Results, numerics: str, group: str, metric: str) -> Floats:
    values = results.values(numerics, group, metric)
    return values[~np.isnan(values)]


def _tolerated(results: Results, numerics: str) -> Answer:
    """T5: at most two of the six metrics show a large effect of weak turbulence, whatever the intervals leave open."""
    found = [_Case(metric, NOT_LARGE, _effect(results, numerics, "T5e-4", metric)) for metric in PAPER_METRICS]
    verdicts = [verdict_of(case.paper, case.effect) for case in found]
    large, open_ = (_named(found, verdicts, verdict) for verdict in (NOT_REPRODUCED, NOT_DECIDABLE))
    least, most = len(large), len(large) + len(open_)
    verdict = REPRODUCED if most <= TOLERABLE else NOT_REPRODUCED if least > TOLERABLE else NOT_DECIDABLE
    count = f"large in {least} of 6" if least == most else f"large in {least} to {most} of 6"
    ours = f"{count}; {_listed({'large': large, 'open': open_})}".removesuffix("; ")
    if NO_RUNS in verdicts:
        verdict, ours = NO_RUNS, DASH
    return Answer("T5", "T5e-4 against T0", "the shoal tolerates weak turbulence", numerics, ours, verdict)


def _named(found: Sequence[_Case], verdicts: Sequence[str], wanted: str) -> list[str]:
    """In words, the effects on which the verdict is the wanted one."""
    pairs = zip(found, verdicts, strict=True)
    return [_in_words(case.name, case.effect) for case, verdict in pairs if verdict == wanted]


def _listed(parts: Mapping[str, Sequence[str]]) -> str:
    """What there is, each part after its heading."""
    return "; ".join(f"{heading}: {', '.join(words)}" for heading, words in parts.items() if words)


def _in_words(name: str, found: Effect) -> str:
    words = shown(found) if found.size == "undefined" else f"{found.direction}, {with_interval(found)}"
    return f"{_plain(name)} {words}"


def _plain(name: str) -> str:
    return name.replace("_", " ")
