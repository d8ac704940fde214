"""The Scorer: envelopes against diagnoses, as tables with Wilson intervals; it knows the interface alone."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Collection
from pathlib import Path
from typing import Any

from concealer.calibration import calibration
from concealer.cases import Case, load
from concealer.estimates import of_effects, of_platform
from concealer.figures import percent, power_curve, rate, spread
from concealer.score_families import by_family, form_in_words, members_in_words
from concealer.score_text import as_text
from concealer.seal import LEDGER, broken_seals
from concealer.table import grouped, of_kind, table

Scores = dict[str, Any]


def intervals(cases: list[Case]) -> Scores:
    """Coverage of the 95 % intervals of effects and platform, and errors relative to the truth, by parameter too."""
    inside: dict[str, list[bool]] = {}
    errors: dict[str, list[float]] = {}
    for case in cases:
        for name, truth, answer in [*of_effects(case), *of_platform(case)]:
            if truth != 0.0 and not name.startswith("platform."):
                errors.setdefault(name, []).append(abs(answer["value"] - truth) / abs(truth))
            ends = answer.get("ci95")
            if ends and None not in ends:
                inside.setdefault(name, []).append(min(ends) <= truth <= max(ends))
    platform = [value for name, values in inside.items() if name.startswith("platform.") for value in values]
    effects = [value for name, values in inside.items() if not name.startswith("platform.") for value in values]
    return {
        "coverage": rate([*effects, *platform]),
        "coverage_of_effects": rate(effects),
        "coverage_of_platform": rate(platform),
        "coverage_by_parameter": {name: rate(values) for name, values in sorted(inside.items())},
        "relative_error": spread([value for values in errors.values() for value in values]),
        "relative_error_by_parameter": {name: spread(values) for name, values in sorted(errors.items())},
    }


def _oracle(case: Case, told: Scores, window: float, channel: str) -> float | None:
    """Root mean square over robots of the oracle's error, measured as a diagnosis measures its own.

    told: the channel's free runs in the diagnosis; over as many seconds as it says, else `window`, and with the noise
    of the readings if it measures against readings, else against the true course where that is told.
    """
    length = f"{told.get('seconds') or window:g}"
    measure = channel if told.get("against") == "readings" else f"{channel}_alone"
    best = [runs[length] for runs in case.truth["oracle"].values() if length in runs]
    errors = [scores.get(measure, scores[channel]) for scores in best if channel in scores]
    return (sum(error**2 for error in errors) / len(errors)) ** 0.5 if errors else None


def held_out(cases: list[Case], window: float) -> Scores:
    """Free runs: augmented against the model that knows the truth and against the recalibrated one.

    Against the first only where the water pushes at random: elsewhere that model makes no error at all.
    """
    ratios: dict[str, list[float]] = {}
    for case in of_kind(cases, "single", "several", "nothing", "recalibration"):
        fit = ((case.diagnosis or {}).get("fit") or {}).get("held_out") or {}
        for channel in ("position", "heading", "depth"):
            scores = fit.get(channel) or {}
            best = _oracle(case, scores, window, channel)
            if scores.get("augmented") and best and case.truth["noise"] > 0.0:
                ratios.setdefault(f"{channel}: augmented / oracle", []).append(scores["augmented"] / best)
            if scores.get("augmented") and scores.get("recalibrated") and case.hidden:
                gain = scores["augmented"] / scores["recalibrated"]
                ratios.setdefault(f"{channel}: augmented / recalibrated", []).append(gain)
    return {name: spread(values) for name, values in ratios.items()}


def confusion(cases: list[Case]) -> dict[str, dict[str, int]]:
    """Counts of the first named effect by what was hidden.

    Several effects count under each of theirs if the first is one of them.
    """
    out: dict[str, Counter[str]] = {}
    for case in cases:
        truth = case.kind if case.kind == "cannot_tell" or not case.hidden else case.hidden[0]
        if case.kind == "several":
            truth = case.first if case.first in case.hidden else "several: " + " + ".join(sorted(case.hidden))
        out.setdefault(truth, Counter())[case.first] += 1
    return {truth: dict(counts.most_common()) for truth, counts in sorted(out.items())}


def _said(effect: dict[str, Any]) -> str:
    topic = f" of {effect['topic']}" if effect.get("topic") else ""
    rivals = [f"{r['id']} {r['nats_behind']:.1f} behind" for r in effect.get("ambiguous_with") or []]
    return f"{effect['id']}{topic} ({float(effect.get('nats') or 0.0):.0f} nats{''.join('; ' + r for r in rivals)})"


def failures(cases: list[Case]) -> list[str]:
    """One line for every answer that is not what it should be."""
    lines = []
    for case in cases:
        if case.right():
            continue
        hidden = " + ".join(
            f"{e['id']}{' of ' + e['topic'] if e['topic'] else ''} (size {e['size']:.2f}{form_in_words(e)})"
            for e in case.truth["effects"]
        )
        said = " + ".join(map(_said, case.effects)) or "none"
        swimmers = len(case.truth.get("robots") or [0])
        lines.append(
            f"{case.name}  {case.kind}, noise {percent(case.truth['noise'])}, {swimmers} robot{'s' * (swimmers > 1)}: "
            f"{hidden or 'nothing'}{members_in_words(case)}; said {case.verdict}: {said}"
        )
    return lines


def score(cases: list[Case], window: float = 20.0) -> Scores:
    """All figures of a trial."""
    single = of_kind(cases, "single")
    sized: dict[str, list[Case]] = {}
    for case in single:
        sized.setdefault(case.hidden[0], []).append(case)
    outside = of_kind(cases, "outside")
    return {
        "recordings": len(cases),
        "composition": dict(Counter(case.kind for case in cases)),
        "table": table(cases),
        "exact_by_effect": grouped(single, lambda case: case.hidden[0]),
        "flagged_by_law": {
            form: rate(case.flagged() and not case.named_wrongly() for case in outside if case.hidden[0] == form)
            for form in sorted({case.hidden[0] for case in outside})
        },
        "exact_by_size": grouped(single, lambda case: case.band),
        "exact_by_noise": grouped(single, lambda case: case.truth["noise"]),
        "exact_by_size_and_noise": grouped(single, lambda case: f"{case.band}, {percent(case.truth['noise'])}"),
        "power": {
            name: power_curve([case.size for case in group], [case.exact() for case in group])
            for name, group in sorted(sized.items())
        },
        "intervals": intervals(cases),
        "held_out": held_out(cases, window),
        "probabilities": calibration(cases),
        "families": by_family(cases),
        "confusion": confusion(cases),
        "failures": failures(cases),
    }


def opened(trial: Path, diagnoses: Path, block: str = "") -> list[Case]:
    """All cases of a trial, or of a part of one, whose seals hold. Raises ValueError if one is broken."""
    faults = broken_seals(trial / LEDGER, trial / "envelopes")
    if faults:
        raise ValueError("; ".join(faults))
    return load(trial, diagnoses, block)


def score_trial(
    trial: Path, diagnoses: Path, out: Path, window: float = 20.0, tried: Collection[str] | None = None
) -> str:
    """Checks the seals, writes scores.json and scores.md into a new folder, and returns the text.

    A trial in several parts has a folder with a ledger for each; its diagnoses are in folders of the same names.
    Only recordings whose names are in `tried` count, if that is given: time may be up before the tool saw them all.
    Raises ValueError if a seal is broken, FileExistsError if the folder exists.
    """
    if (trial / LEDGER).exists():
        cases = opened(trial, diagnoses)
    else:
        parts = sorted(path.parent for path in trial.glob(f"*/{LEDGER}"))
        cases = [case for part in parts for case in opened(part, diagnoses / part.name, part.name)]
    figures = score([case for case in cases if tried is None or case.name in tried], window)
    out.mkdir(parents=True)
    (out / "scores.json").write_text(json.dumps(figures, indent=1) + "\n", encoding="utf-8")
    text = as_text(figures)
    (out / "scores.md").write_text(text, encoding="utf-8")
    return text
