"""Figures of a trial of families: right answers and intervals that hold the truth, by the member that was drawn."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

from concealer.cases import Case
from concealer.estimates import Found, of_effects, of_platform
from concealer.figures import rate

Scores = dict[str, Any]
SHOWN = 20.0  # nats that the platform's own laws leave of a law outside the catalogue, for it to be plain to see


def kind_of(member: str) -> str:
    """The registered kind of a member: `placed` of `placed_2`."""
    name, _, number = member.rpartition("_")
    return name if number.isdigit() else member


def form_in_words(effect: dict[str, Any]) -> str:
    """The form of a hidden effect, for a line of failures; nothing where there are no families."""
    form = effect.get("form_of_family", "plain")
    return "" if form == "plain" else f", {form}"


def members_in_words(case: Case) -> str:
    """Noise, programme and tank of a case, for a line of failures."""
    drawn = case.truth.get("families")
    return f" [noise {drawn['noise']}, plan {drawn['plan']}, arena {drawn['arena']}]" if drawn else ""


def _held(found: Iterable[Found]) -> list[bool]:
    """Whether intervals hold the truth, of the numbers that have one."""
    some = [(truth, answer["ci95"]) for _, truth, answer in found if answer.get("ci95") and None not in answer["ci95"]]
    return [min(ends) <= truth <= max(ends) for truth, ends in some]


def _by(pairs: Iterable[tuple[str, bool]]) -> dict[str, Any]:
    """Rates by name, sorted."""
    groups: dict[str, list[bool]] = {}
    for name, answer in pairs:
        groups.setdefault(name, []).append(answer)
    return {name: rate(answers) for name, answers in sorted(groups.items())}


def _form(case: Case, effect: str) -> str:
    """Kind of the form of a hidden effect: its own, that of the Concealer as it always was, if none is drawn."""
    return next(kind_of(e["form_of_family"]) for e in case.truth["effects"] if e["id"] == effect)


def _sealed(case: Case) -> str:
    """Whether any drawn member was sealed."""
    sealed = case.truth["families"]["sealed"]
    some = sealed["noise"] or sealed["plan"] or sealed["arena"] or any(sealed["forms"].values())
    return "one or more members sealed" if some else "open members alone"


def _intervals(cases: list[Case]) -> Scores:
    single = [case for case in cases if case.kind == "single"]
    of_forms = [
        (_form(case, found[0].partition(".")[0]), held)
        for case in cases
        for found in of_effects(case)
        for held in _held([found])
    ]
    platform = [(_form(case, case.hidden[0]), held) for case in single for held in _held(of_platform(case))]
    quiet = [held for case in cases if not case.hidden for held in _held(of_platform(case))]
    by_noise = [
        (kind_of(case.truth["families"]["noise"]), held)
        for case in cases
        for held in _held([*of_effects(case), *of_platform(case)])
    ]
    return {
        "95 % intervals of effects that hold the truth, by form": _by(of_forms),
        "95 % intervals of the platform's numbers that hold the truth, one effect, by its form": _by(platform)
        | {"nothing hidden": rate(quiet)},
        "95 % intervals that hold the truth, by noise": _by(by_noise),
    }


def _outside(cases: list[Case]) -> Scores:
    laws = [case for case in cases if case.kind == "outside"]
    shown = [case for case in laws if case.truth["effects"][0]["parameters"].get("nats", 0.0) >= SHOWN]
    return {
        "outside the catalogue, flagged, by equation": _by(
            (case.hidden[0].partition(":")[2].partition("~")[0], case.flagged()) for case in laws
        )
        | {f"of {SHOWN:g} nats and more": rate(case.flagged() for case in shown)}
    }


def by_family(cases: list[Case]) -> Scores:
    """Tables of rates by title; nothing where no case has families."""
    some = [case for case in cases if case.truth.get("families")]
    if not some:
        return {}
    single = [case for case in some if case.kind == "single"]
    quiet = [case for case in some if case.kind in ("nothing", "recalibration")]

    def by_member(family: str, among: list[Case], answer: Callable[[Case], bool]) -> dict[str, Any]:
        return _by((kind_of(case.truth["families"][family]), answer(case)) for case in among)

    return {
        "exact naming of one effect, by form": _by((_form(case, case.hidden[0]), case.exact()) for case in single),
        "right answers of all kinds, by noise": by_member("noise", some, Case.right),
        "right answers of all kinds, by plan": by_member("plan", some, Case.right),
        "right answers of all kinds, by arena": by_member("arena", some, Case.right),
        "right answers of all kinds, sealed or open": _by((_sealed(case), case.right()) for case in some),
        "false alarms where structure is intact, by noise": by_member("noise", quiet, Case.false_alarm),
        **_outside(some),
        **_intervals(some),
    }
