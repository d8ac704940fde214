"""The page about a diagnosis: report.html, which needs no other file."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Collection, Sequence
from pathlib import Path
from typing import Any

from cocorosim_ros import __version__
from cocorosim_ros.diagnosis.catalogue.parameter_words import parameter_words
from cocorosim_ros.diagnosis.criteria.report import REPORT
from cocorosim_ros.diagnosis.findings import Diagnosis, FoundEffect, FreeRun, HeldOut, Located, Recalibrated
from cocorosim_ros.diagnosis.report.actuator_table import reported_headings, reported_rows
from cocorosim_ros.diagnosis.report.advice import manoeuvre_words, where_words
from cocorosim_ros.diagnosis.report.bars_of_nats import bars_of_nats, bars_words, without_bars
from cocorosim_ros.diagnosis.report.equation_text import typeset
from cocorosim_ros.diagnosis.report.free_run_figure import free_runs_figure
from cocorosim_ros.diagnosis.report.marks import DOUBTFUL_NUMBER, limit_words, marked_words, unlike_words
from cocorosim_ros.diagnosis.report.medium import in_its_medium
from cocorosim_ros.diagnosis.report.model_file import Origin
from cocorosim_ros.diagnosis.report.nameless_force import NO_BOUND, is_no_bound, no_bound_sentence
from cocorosim_ros.diagnosis.report.nats_words import explained_at_first_sight
from cocorosim_ros.diagnosis.report.not_shown import not_shown_context
from cocorosim_ros.diagnosis.report.number_text import estimate_words, in_unit_of
from cocorosim_ros.diagnosis.report.place_figure import over_place
from cocorosim_ros.diagnosis.report.probability_words import meaning_words, told_probabilities
from cocorosim_ros.diagnosis.report.reading_figure import reading_figure
from cocorosim_ros.diagnosis.report.recorded import as_recorded
from cocorosim_ros.diagnosis.report.regressors import OF_BODY, residual_of, said_law
from cocorosim_ros.diagnosis.report.residual_figures import (
    Pair,
    against_regressor,
    by_conditions,
    condition_words,
    over_time,
    pairs_of,
    why_not_drawn,
)
from cocorosim_ros.diagnosis.report.sentence import detail_lines
from cocorosim_ros.diagnosis.report.shift_figure import shifts
from cocorosim_ros.diagnosis.report.significance import may_be_nothing, not_shown_numbers
from cocorosim_ros.diagnosis.report.verdict_words import (
    nothing_missing_words,
    untested_because,
    verdict_words,
    weighed_words,
)
from cocorosim_ros.diagnosis.report.words import (
    CHANNEL_WORDS,
    NOISES,
    check_words,
    control_words,
    effect_words,
    odds_words,
    tier_words,
)
from cocorosim_ros.diagnosis.showing.doubt import SIZE_MAY_BE_NOTHING
from cocorosim_ros.foundation.units.quantity_text import NONE, handy_scale, plain_number, quantity_words
from cocorosim_ros.foundation.units.quantity_text import with_unit as number_with_unit
from cocorosim_ros.study.pictures.page import page_template
from cocorosim_ros.world.terms.regressors import REGRESSOR

Context = dict[str, Any]


def render_report(diagnosis: Diagnosis, origin: Origin) -> str:
    """The page as text."""
    template = page_template(Path(__file__).parent, "report.html.jinja")
    known = {
        "verdict": verdict_words(diagnosis),
        "nothing_missing": nothing_missing_words(diagnosis),
        "untested": untested_because(diagnosis),
        "probability": told_probabilities(diagnosis),
        "meaning": meaning_words(diagnosis),
        "weighed": weighed_words(diagnosis),
    }
    diagnosis = as_recorded(diagnosis, origin.platform)
    page = template.render(
        **known,
        diagnosis=diagnosis,
        origin=origin,
        version=__version__,
        details=detail_lines(diagnosis),
        control=control_words(diagnosis.against),
        learned=", ".join(map(effect_words, diagnosis.against.learned)) if diagnosis.against else "",
        manoeuvre=_clause(manoeuvre_words(diagnosis.manoeuvres)),
        **_where(diagnosis, origin),
        **_what(diagnosis),
        **_fit(diagnosis),
        reported=(reported_headings(diagnosis.actuators), reported_rows(diagnosis.actuators)),
        **not_shown_context(diagnosis),
    )
    return in_its_medium(explained_at_first_sight(page), origin.platform)


def _clause(sentence: str | None) -> str:
    """A sentence as it stands after a colon."""
    return sentence[:1].lower() + sentence[1:].rstrip(".") if sentence else ""


def _where(diagnosis: Diagnosis, origin: Origin) -> Context:
    pairs = pairs_of(diagnosis)
    shown = list(zip(pairs, _titles([pair.before.robot for pair in pairs], origin), strict=True))[: REPORT.most_robots]
    return {
        "located": [_located(each) for each in diagnosis.mismatch],
        "robots": [_pictures(pair, diagnosis) | {"title": title} for pair, title in shown],
        "more": _more([pair.before.robot for pair in pairs]),
        "readings": [
            (reading_figure(each), each, _regressor_words(each.regressor))
            for each in diagnosis.readings[: REPORT.most_readings]
        ],
        "readings_first": bool(diagnosis.mismatch) and diagnosis.mismatch[0].equation not in OF_BODY,
        "readings_left_out": _readings_left_out(diagnosis),
    }


def _regressor_words(regressor: str) -> str:
    """Words for the regressor over which a picture is drawn, for its caption."""
    return REGRESSOR[regressor].meaning if regressor in REGRESSOR else regressor.replace("*", "\u00b7")


def _readings_left_out(diagnosis: Diagnosis) -> list[str]:
    """A sentence for each stream that an effect was found of and that has no picture."""
    every = Counter(f"/{each.robot}/{each.topic}" for each in diagnosis.readings[REPORT.most_readings :])
    hidden = [f"{topic} of {count} more recordings" if count > 1 else topic for topic, count in every.items()]
    drawn = {(each.robot, each.topic) for each in diagnosis.readings}
    said = [f"Not drawn, to be brief: what {', '.join(hidden)} show less what the model expects."] if hidden else []
    for found in diagnosis.effects:
        missing = [name for name in found.robots if found.topic and (name, found.topic) not in drawn]
        if missing and found.correction is None:
            topics = ", ".join(f"/{name}/{found.topic}" for name in missing)
            said.append(
                f"There is no picture of {topics} for {effect_words(found.id)}: no picture shows such readings."
            )
    return said


def _titles(robots: Sequence[str], origin: Origin) -> list[str]:
    """Titles that tell the courses of robots apart; a robot of several recordings appears in their order."""
    titles = []
    for place, robot in enumerate(robots):
        number, count = robots[:place].count(robot), robots.count(robot)
        in_all = count == len(origin.recordings)
        which = f" in {origin.recordings[number]}" if in_all else f", {number + 1} of its {count} recordings"
        titles.append(robot + which if count > 1 else robot)
    return titles


def _more(robots: Sequence[str]) -> str:
    """The number of robots or recordings without pictures, in words; empty if all have pictures."""
    others = set(robots[REPORT.most_robots :]) - set(robots[: REPORT.most_robots])
    if others:
        return f"{len(others)} more robot{'s' if len(others) > 1 else ''}"
    hidden = len(robots[REPORT.most_robots :])
    return f"{hidden} more recording{'s' if hidden > 1 else ''}" if hidden else ""


def _located(found: Located) -> Context:
    start, end = found.when
    law = said_law(found)
    equation, regressor = law.equation, law.regressor
    return {
        "equation": equation.replace("_", " "),
        "regressor": typeset(regressor) if regressor != "1" else "nothing: it is constant",
        "size": quantity_words(found.size, found.unit),
        "z": plain_number(found.z),
        "where": where_words(found.where),
        "when": f"{start:.0f} to {end:.0f}\u00a0s" if math.isfinite(start + end) else NONE,
        "robots": ", ".join(found.robots),
    }


def _pictures(pair: Pair, diagnosis: Diagnosis) -> Context:
    mine = [each for each in diagnosis.mismatch if not each.robots or pair.before.robot in each.robots]
    equations = [law.equation for law in map(said_law, mine) if residual_of(law.equation, pair.before)] or [
        "surge",
        "yaw",
    ]
    leading = equations[0]
    drawn = [(each, said_law(each)) for each in mine[: REPORT.most_located]]
    return {
        "robot": pair.before.robot,
        "paired": pair.after is not None,
        "over_time": over_time(pair),
        "against": [(against_regressor(pair, each), law.equation, law.regressor) for each, law in drawn],
        "left_out": _left_out(pair, mine, {each.topic for each in diagnosis.readings}),
        "leading": leading.replace("_", " "),
        "over_place": over_place(pair, leading) if "position" in diagnosis.fit or not diagnosis.fit else "",
        "by_conditions": by_conditions(pair, equations[:2]),
        "conditions": condition_words(pair),
    }


def _left_out(pair: Pair, mine: Sequence[Located], drawn_streams: Collection[str]) -> list[str]:
    """A sentence for each finding about a robot that has no picture of its own."""
    said = [
        why_not_drawn(pair, each)
        for each in mine[: REPORT.most_located]
        if said_law(each).equation not in drawn_streams
    ]
    if len(mine) > REPORT.most_located:
        said.append(f"Drawn are the {REPORT.most_located} clearest of {len(mine)} findings; the table has all.")
    return [sentence for sentence in said if sentence]


def _what(diagnosis: Diagnosis) -> Context:
    return {
        "effects": [_effect(each) | _reasons(each, diagnosis.warnings) for each in diagnosis.effects],
        "unlike": unlike_words(diagnosis.unlike),
        "may_be_nothing": DOUBTFUL_NUMBER,
        "passed_over": [_effect(each.found) | {"because": each.because} for each in diagnosis.passed_over],
        "nats_bars": bars_of_nats(diagnosis),
        "without_bars": ", ".join(effect_words(name) for name in without_bars(diagnosis)),
        "bars_words": bars_words(diagnosis),
    }


def _effect(found: FoundEffect) -> Context:
    doubtful = not_shown_numbers(found)
    return {
        "id": found.id,
        "name": found.name,
        "topic": found.topic,
        "equation": typeset(found.equation) if found.equation else "",
        "numbers": [
            (name, (*estimate_words(each), limit_words(each)))
            for name, each in found.parameters.items()
            if name not in doubtful
        ],
        "doubt": SIZE_MAY_BE_NOTHING if may_be_nothing(found) else "",
        "doubtful": [f"{name.replace('_', ' ')} ({marked_words(found.parameters[name])[1]})" for name in doubtful],
        "correction": found.correction,
        "robots": ", ".join(found.robots),
        "tier": found.tier,
        "tier_words": tier_words(found),
        "nats": plain_number(found.nats),
        "held_out_nats": plain_number(found.held_out_nats) if math.isfinite(found.held_out_nats) else "",
        "check": check_words(found.id),
        "rivals": [
            {
                "name": effect_words(each.id),
                "nats": plain_number(each.nats_behind, 2),
                "odds": odds_words(each.nats_behind),
            }
            for each in found.ambiguous_with
        ],
    }


def _reasons(found: FoundEffect, warnings: Sequence[str]) -> Context:
    """Reasons for which an effect is suspected: its own, and how many stand at the top of the page for all."""
    own = [reason for reason in found.because if reason not in warnings]
    return {"because": own, "shared": len(found.because) - len(own)}


def _fit(diagnosis: Diagnosis) -> Context:
    parameters = diagnosis.all_recalibrated or diagnosis.recalibrated
    augmented = bool(diagnosis.effects)
    return {
        "fit": [
            {"channel": CHANNEL_WORDS.get(name, name), "cells": _held_out(name, each), "against": each.against}
            for name, each in diagnosis.fit.items()
        ],
        "no_bound": no_bound_sentence([name for name, row in diagnosis.fit.items() if is_no_bound(name, row)]),
        "seconds": next((f"{each.seconds:g}" for each in diagnosis.fit.values() if each.seconds), None),
        "free_runs": free_runs_figure(_chosen_runs(diagnosis.free_runs), diagnosis.fit, augmented=augmented),
        "parameters": [_parameter(each) for each in parameters],
        "shifts": shifts(parameters),
        "noise": [(NOISES.get(name, name), estimate_words(each)) for name, each in diagnosis.noise.items()],
    }


def _chosen_runs(runs: Sequence[FreeRun]) -> list[FreeRun]:
    """Choose a few stretches, of as many robots as possible."""
    own = [sum(other.robot == run.robot for other in runs[:index]) for index, run in enumerate(runs)]
    order = sorted(range(len(runs)), key=lambda index: own[index])
    return [runs[index] for index in sorted(order[: REPORT.most_free_runs])]


def _held_out(channel: str, found: HeldOut) -> list[Context]:
    """The cells of a row of the table, all in one unit; the best model's is marked, and a figure that is no bound."""
    unbound = is_no_bound(channel, found)
    models = {name: getattr(found, name) for name in ("nominal", "recalibrated", "augmented", "noise_floor")}
    errors = sorted(models[name] for name in ("nominal", "recalibrated", "augmented") if math.isfinite(models[name]))
    scale = handy_scale(errors[-1] if errors else math.nan, found.unit)
    cells = []
    for name, value in models.items():
        low, high = (end * scale.factor for end in found.intervals.get(name, (math.nan, math.nan)))
        cells.append(
            {
                "value": number_with_unit(plain_number(value * scale.factor), scale.unit),
                "interval": f"{plain_number(low)} to {plain_number(high)}"
                if math.isfinite(low + high) and low < high
                else "",
                "mark": NO_BOUND if unbound and name == "noise_floor" else "",
                "best": len(errors) > 1 and value == errors[0] and value < REPORT.clearly_best * errors[1],
            }
        )
    return cells


def _parameter(found: Recalibrated) -> Context:
    value, interval = estimate_words(found.estimate)
    low, high = found.estimate.low, found.estimate.high
    return {
        "name": parameter_words(found.parameter),
        "nominal": in_unit_of(found.nominal, found.estimate),
        "value": value,
        "interval": interval,
        "mark": limit_words(found.estimate),
        "moved": math.isfinite(low + high) and not found.estimate.holds(found.nominal),
        "robots": ", ".join(found.robots),
    }
