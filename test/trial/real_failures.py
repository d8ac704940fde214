"""All that went wrong on real recordings, item by item."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from trial.documented import causes_by_group, is_named
from trial.other_half import TIERS
from trial.real_figures import AGAIN, HALVES, ONE, OTHER, diagnosis, halves
from trial.real_musts import AT_A_BOUND, COLLAPSED, not_kept, worse_than_own
from trial.real_words import HALF_WORDS, digits, title

Tree = dict[str, Any]
WHAT = {
    ONE: "one half",
    OTHER: "the other half",
    AGAIN: "the same recordings with the found model",
    HALVES: "the halves compared",
}


def failures(figures: Tree) -> list[str]:
    """Lines of the page, by kind; a kind without any says so."""
    confirmed, suspected = (not_kept(figures, tier) for tier in TIERS)
    kinds = {
        "Diagnoses that did not end well": _not_ended(figures),
        "Confirmed in one half, and not borne out by the other": confirmed,
        "Suspected in one half, and not borne out by the other": suspected,
        "Documented, and named in neither half": _not_named(figures),
        "Unseen recordings on which the found model errs more than the platform's file": worse_than_own(figures),
        "Parts that no fit of the numbers saw, on which the model with all effects errs more": _worse_inside(figures),
        "The same recordings with the found model: not `consistent`": _other_than_consistent(figures, AGAIN),
        "One half against the other: not `consistent`": _other_than_consistent(figures, HALVES),
        "Fits that collapsed, or whose numbers stand at a bound": _collapsed(figures),
    }
    lines = []
    for kind, items in kinds.items():
        told = [f"- {each}" for each in items]
        lines += [f"{kind}: {len(told) if told else 'none'}.", "", *told, *([""] if told else [])]
    return lines[:-1] if lines[-1] == "" else lines


def _not_ended(figures: Tree) -> Iterable[str]:
    for name, group in figures["groups"].items():
        for what, told in group["diagnoses"].items():
            if told["ended"]["status"] != 0 or told["diagnosis"] is None:
                yield f"{name}, {WHAT[what]}: {told['ended']['said'] or 'no reason is given'}"


def _not_named(figures: Tree) -> Iterable[str]:
    for name, causes in causes_by_group().items():
        group = figures["groups"].get(name)
        for cause in causes if group else ():
            if not any(is_named(cause, diagnosis(group, half)) for half in (ONE, OTHER)):
                yield f"{name}: {cause['what']}"


def _worse_inside(figures: Tree) -> Iterable[str]:
    for name, half, said in halves(figures):
        for channel, told in said["held_out"].items():
            by_file, by_model = told.get("nominal"), told.get("augmented")
            if by_file and by_model and by_model > by_file and digits(by_model) != digits(by_file):
                unit = told.get("unit", "")
                yield f"{name}, {HALF_WORDS[half]}, {channel}: {digits(by_model)} for {digits(by_file)} {unit}"


def _other_than_consistent(figures: Tree, what: str) -> Iterable[str]:
    for name, group in figures["groups"].items():
        said = diagnosis(group, what)
        if said is not None and said["verdict"] != "consistent":
            yield f"{name}: {said['verdict']}{''.join(f', {title(each)}' for each in said['effects'])}"


def _collapsed(figures: Tree) -> Iterable[str]:
    for name, half, said in halves(figures):
        for warning in said.get("warnings") or []:
            if COLLAPSED in warning or AT_A_BOUND in warning:
                yield f"{name}, {HALF_WORDS[half]}: {warning}"
