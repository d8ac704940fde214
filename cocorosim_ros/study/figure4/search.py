"""The search for the best common reading, stage by stage; each stage follows from the results of those before it.

screening      a folded fraction of all settings, few runs
refining_1     the five best of them, and the setting that main effects alone would choose
refining_2 ... the best setting so far with one factor changed, each in turn
choosing       the best of all that were refined, with more runs, since the least of many by few runs is least by chance
confirming     the best of these, many runs with seeds of their own, so that nothing in them was chosen
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from cocorosim_ros.study.experiments.factorial import Factorial, Stage
from cocorosim_ros.study.experiments.fraction import Setting, folded_settings
from cocorosim_ros.study.figure4.main_effects import main_effects
from cocorosim_ros.study.figure4.published import PublishedFigure
from cocorosim_ros.study.figure4.scores import Score, scores
from cocorosim_ros.study.results.results import Results

SCREENING, CHOOSING, CONFIRMING = "screening", "choosing", "confirming"
KEPT = 5  # of the screening's best settings that are run again


@dataclass(frozen=True)
class Done:
    """A stage with its results and what its settings give back."""

    stage: Stage
    results: Results
    scores: tuple[Score, ...]


@dataclass(frozen=True)
class Searched:
    """A search that has come to its end."""

    factorial: Factorial
    figure: PublishedFigure
    stages: tuple[Done, ...]


def done(factorial: Factorial, figure: PublishedFigure, stage: Stage, results: Results, before: Sequence[Done]) -> Done:
    """A finished stage; what is confirmed keeps the readings of the metrics in which it was chosen."""
    columns = best(before).columns if stage.name == CONFIRMING else None
    return Done(stage, results, tuple(scores(factorial, figure, stage, results, columns)))


def next_stage(factorial: Factorial, before: Sequence[Done]) -> Stage | None:
    """What is to be run after the stages before; None when all is done."""
    if not before:
        return Stage(SCREENING, tuple(folded_settings(len(factorial.factors))), factorial.screening_runs)
    if before[-1].stage.name == CONFIRMING:
        return None
    number = len(before)
    if number <= factorial.refining_rounds and before[-1].stage.name != CHOOSING:
        settings = _first_round(before[0]) if number == 1 else _neighbours(before)
        if settings:
            return Stage(f"refining_{number}", settings, factorial.refining_runs)
    if before[-1].stage.name != CHOOSING:
        finalists = tuple(dict.fromkeys(one.setting for one in _ranked(before)))[: factorial.choosing_settings]
        return Stage(CHOOSING, finalists, factorial.choosing_runs)
    return Stage(CONFIRMING, (best(before).setting,), factorial.confirming_runs)


def best(before: Sequence[Done]) -> Score:
    """The setting nearest to the figure: of the chosen ones, else of those that were refined, else of the screening."""
    return _ranked(before)[0]


def _ranked(before: Sequence[Done]) -> list[Score]:
    """The scores of the stage or the rounds that count, nearest first."""
    tried = [part for part in before if part.stage.name != CONFIRMING]
    counts = [part for part in tried if part.stage.name == CHOOSING] or tried[1:] or tried[:1]
    return sorted((one for part in counts for one in part.scores), key=lambda one: one.total)


def predicted(screening: Done) -> Setting:
    """Each factor at the level at which the screening's settings are nearer to the figure on average."""
    totals = np.array([one.total for one in screening.scores])
    found = main_effects(totals, len(screening.stage.settings[0]))
    return tuple(bool(effect < 0.0) for effect in found.effects)


def _first_round(screening: Done) -> tuple[Setting, ...]:
    ordered = sorted(screening.scores, key=lambda one: one.total)
    return tuple(dict.fromkeys([predicted(screening), *(one.setting for one in ordered[:KEPT])]))


def _neighbours(before: Sequence[Done]) -> tuple[Setting, ...]:
    """The best setting with one factor changed, but those that were refined before."""
    known = {setting for part in before[1:] for setting in part.stage.settings}
    return tuple(one for one in _one_changed(best(before).setting) if one not in known)


def _one_changed(setting: Setting) -> Iterator[Setting]:
    for place in range(len(setting)):
        yield (*setting[:place], not setting[place], *setting[place + 1 :])
