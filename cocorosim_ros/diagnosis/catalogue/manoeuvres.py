"""Which manoeuvres would show what a recording leaves open."""

from __future__ import annotations

from collections.abc import Sequence

from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES
from cocorosim_ros.diagnosis.findings import FoundEffect


def manoeuvre_of(effect: str) -> str | None:
    """The name of the manoeuvre that shows an effect."""
    return next((entry.manoeuvre for entry in ENTRIES if entry.id == effect and entry.manoeuvre), None)


def advised(effects: Sequence[FoundEffect], unseen: Sequence[str]) -> tuple[str, ...]:
    """Names of up to three manoeuvres: they separate the rivals of what was found, or else show what was not seen."""
    open_effects = [rival.id for effect in effects for rival in effect.ambiguous_with] + [
        effect.id for effect in effects if effect.ambiguous_with
    ]
    names = [name for name in (manoeuvre_of(effect) for effect in dict.fromkeys(open_effects or unseen)) if name]
    return tuple(sorted(dict.fromkeys(names), key=lambda name: -names.count(name))[:3])
