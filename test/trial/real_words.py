"""Words and numbers of a diagnosis for the page on real recordings."""

from __future__ import annotations

from typing import Any

Tree = dict[str, Any]
LONGEST = 1e6  # from which on a number is written with its power of ten
HALF_WORDS = {"one_half": "one half", "other_half": "the other half"}


def digits(value: Any) -> str:
    """Three digits of a number; words as they are, such as what was wrong with a frame."""
    if value is None or isinstance(value, str):
        return value or "-"
    short = f"{value:.3g}"
    return f"{float(short):.0f}" if 1e3 <= abs(value) < LONGEST else short


def number(name: str, told: Tree) -> str:
    """Name, value with unit, and 95 % interval where there is one."""
    unit = told.get("unit") or ""
    value = f"{digits(told.get('value'))} {'' if unit == '1' else unit}".strip()
    low, high = told.get("ci95") or (None, None)
    interval = "" if low is None and high is None else f" ({digits(low)} to {digits(high)})"
    return f"{name} {value}{interval}"


MAY_BE_NOTHING = "may as well be nothing"  # of a reason that a diagnosis gives


def title(effect: Tree) -> str:
    """The effect's name, with its stream if it has one."""
    return f"`{effect['id']}`" + (f" of {effect['topic']}" if effect.get("topic") else "")


def numbers(effect: Tree) -> str:
    """All numbers of an effect."""
    return ", ".join(number(name, told) for name, told in effect["parameters"].items())


def effect_line(effect: Tree) -> str:
    """An effect with evidence, tier, numbers and rivals."""
    rivals = ", ".join(f"`{r['id']}` {r['nats_behind']:.1f} nats behind" for r in effect.get("ambiguous_with") or [])
    tie = f"; it could also be {rivals}" if rivals else ""
    doubt = "; its size may as well be nothing" if any(MAY_BE_NOTHING in why for why in effect["because"]) else ""
    return f"{title(effect)} ({effect.get('nats') or 0:.0f} nats, {effect['tier']}): {numbers(effect)}{doubt}{tie}"


def passed_over_line(effect: Tree) -> str:
    """An effect that was passed over, with the reason that the diagnosis gives, up to its colon."""
    reason = next(iter(effect.get("because") or []), "no reason is given")
    reason = reason.partition(":")[0].rstrip(".")
    told = ", ".join([f"{title(effect)} ({effect.get('nats') or 0:.0f} nats)", *filter(None, [numbers(effect)])])
    return f"passed over, {told}: {reason}"


def recalibrated_line(told: list[Tree]) -> str:
    """Numbers of the platform that have moved, with what its file has."""
    moved = ", ".join(f"{number(each['parameter'], each)} for {digits(each.get('nominal'))}" for each in told)
    return f"the platform's own numbers: {moved}"


def diagnosis_lines(said: Tree) -> list[str]:
    """Lines below a verdict: effects, what was passed over, and numbers that have moved."""
    lines = [effect_line(effect) for effect in said["effects"]]
    lines += [passed_over_line(each) for each in said.get("passed_over") or []]
    return lines + ([recalibrated_line(said["recalibrated"])] if said.get("recalibrated") else [])
