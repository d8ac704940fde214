"""A diagnosis as the machine-readable file diagnosis.json: exactly the fields of the contract, never NaN."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping, Sequence
from typing import Any

from cocorosim_ros.diagnosis.findings import (
    ActuatorReport,
    Comparison,
    Diagnosis,
    Estimate,
    FoundEffect,
    HeldOut,
    Located,
    NotLookedFor,
    PassedOver,
    Recalibrated,
    ScreenedEffect,
)
from cocorosim_ros.diagnosis.report.advice import manoeuvre_words, where_words
from cocorosim_ros.diagnosis.report.marks import limit_words
from cocorosim_ros.diagnosis.report.not_shown import not_looked_for_words
from cocorosim_ros.diagnosis.report.significance import doubtful_numbers
from cocorosim_ros.diagnosis.report.words import reasons_of
from cocorosim_ros.diagnosis.showing.probability import probabilities_of


def diagnosis_json(diagnosis: Diagnosis) -> str:
    """The text of the file; numbers that are not finite are null."""
    return json.dumps(diagnosis_tree(diagnosis), indent=2, ensure_ascii=False, allow_nan=False) + "\n"


def diagnosis_tree(diagnosis: Diagnosis) -> dict[str, Any]:
    """The content of the file as nested plain values."""
    form = {"drag_form": diagnosis.drag_form} if diagnosis.drag_form else {}
    believed = probabilities_of(diagnosis)
    return {
        "verdict": diagnosis.verdict,
        **form,
        "recalibrated": [_recalibrated(each) for each in diagnosis.recalibrated],
        "mismatch": [_located(each) for each in diagnosis.mismatch],
        "effects": [_effect(*each) for each in zip(diagnosis.effects, believed.of_effects, strict=True)],
        "probabilities": dict(believed.told),
        "not_shown_by_this_recording": list(diagnosis.not_shown),
        "not_looked_for": [_not_looked_for(each) for each in diagnosis.not_looked_for],
        "next_manoeuvre": manoeuvre_words(diagnosis.manoeuvres),
        "warnings": list(diagnosis.warnings),
        "cannot_be_told": list(diagnosis.untold),
        "fit": {"held_out": {channel: _held_out(each) for channel, each in diagnosis.fit.items()}},
        "passed_over": [_passed_over(each) for each in diagnosis.passed_over],
        "missing_in": list(diagnosis.beyond_floor),
        "screened": {each.id: _screened(each) for each in diagnosis.screened},
        **({"reasons": list(diagnosis.reasons)} if diagnosis.reasons else {}),
        **_against(diagnosis.against),
        **_actuators(diagnosis.actuators),
        **({"kept_as_given": list(diagnosis.held)} if diagnosis.held else {}),
    }


def _against(against: Comparison | None) -> dict[str, Any]:
    """Keys about the recordings that others were compared with; none where there are no such recordings."""
    if against is None:
        return {}
    return {
        "against": list(against.recordings),
        "against_control": {
            "verdict": "mismatch" if against.control else "consistent",
            "differs": list(against.control),
        },
        "against_learned": {
            "effects": list(against.learned),
            "taken_back": list(against.taken_back),
            "numbers": [_recalibrated(each) for each in against.before],
        },
        "against_spread": {name: _finite(each) for name, each in against.spreads.items()},
        "against_in_doubt": list(against.in_doubt),
        "against_seen_from": {name: dict(numbers) for name, numbers in against.seen_from.items()},
        "against_remarks": list(against.remarks),
    }


def _actuators(reports: Sequence[ActuatorReport]) -> dict[str, Any]:
    """The key about what actuators report; none where they report nothing."""
    return {"actuator_feedback": [_reported(each) for each in reports]} if reports else {}


def _reported(report: ActuatorReport) -> dict[str, Any]:
    """One quantity of an actuator: its numbers, or a clause why there are none; before: those compared with."""
    before = {"before": _estimates(report.before)} if report.before else {}
    told = _estimates(report.numbers) if report.numbers else {"because": report.because}
    place = {"robots": [report.robot], "actuator": report.actuator, "quantity": report.quantity}
    return place | {"of_amount": report.of_amount} | told | before


def _estimates(numbers: Mapping[str, Estimate]) -> dict[str, Any]:
    return {name: _estimate(estimate) for name, estimate in numbers.items()}


def _recalibrated(found: Recalibrated) -> dict[str, Any]:
    return {
        "parameter": found.parameter,
        "nominal": _finite(found.nominal),
        **_estimate(found.estimate),
        "robots": list(found.robots),
    }


def _located(found: Located) -> dict[str, Any]:
    return {
        "robots": list(found.robots),
        "equation": found.equation,
        "regressor": found.regressor,
        "where": where_words(found.where),
        "when": [_finite(moment) for moment in found.when],
        "size": _finite(found.size),
        "unit": found.unit,
        "z": _finite(found.z),
    }


def _screened(each: ScreenedEffect) -> dict[str, Any]:
    return {"nats": _finite(each.nats), "seen_from": _finite(each.seen_from)}


def _not_looked_for(each: NotLookedFor) -> dict[str, Any]:
    """An effect that was not looked for: the keys that the platform's file lacks, and the sentence of the page."""
    return {"id": each.id, "lacks": list(each.numbers), "because": not_looked_for_words(each)}


def _effect(found: FoundEffect, probability: float) -> dict[str, Any]:
    because = list(reasons_of(found))
    return _named(found) | {"tier": found.tier, "because": because, "probability": probability}


def _passed_over(passed: PassedOver) -> dict[str, Any]:
    """An effect without a name, in the form of those that have one; missing: whether something is all the same."""
    return _named(passed.found) | {"because": list(passed.because), "missing": passed.stands}


def _named(found: FoundEffect) -> dict[str, Any]:
    tree: dict[str, Any] = {"id": found.id, "name": found.name, "equation": found.equation}
    if found.topic is not None:
        tree["topic"] = found.topic
    doubtful = doubtful_numbers(found)
    parameters = {
        name: _estimate(estimate) | ({"may_be_nothing": True} if name in doubtful else {})
        for name, estimate in found.parameters.items()
    }
    if found.correction is not None:
        # Words have neither interval nor unit; every parameter has the same keys all the same.
        parameters["correction"] = {"value": found.correction, "ci95": [None, None], "unit": None}
    rivals = [{"id": rival.id, "nats_behind": _finite(rival.nats_behind)} for rival in found.ambiguous_with]
    return tree | {
        "robots": list(found.robots),
        "parameters": parameters,
        "nats": _finite(found.nats),
        "ambiguous_with": rivals,
    }


def _estimate(estimate: Estimate) -> dict[str, Any]:
    interval = [_finite(estimate.low), _finite(estimate.high)]
    limits = {"limits": [_finite(end) for end in estimate.limits]} if limit_words(estimate) else {}
    return {"value": _finite(estimate.value), "ci95": interval, "unit": estimate.unit, **limits}


def _held_out(found: HeldOut) -> dict[str, Any]:
    return {
        "nominal": _finite(found.nominal),
        "recalibrated": _finite(found.recalibrated),
        "augmented": _finite(found.augmented),
        "noise_floor": _finite(found.noise_floor),
        "unit": found.unit,
        **({} if found.seconds is None else {"seconds": found.seconds}),
        "against": found.against,
    }


def _finite(number: float) -> float | None:
    return float(number) if math.isfinite(number) else None
