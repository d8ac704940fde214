"""Choice of manoeuvres that would show what a recording leaves open."""

from __future__ import annotations

from collections.abc import Sequence

from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES
from cocorosim_ros.diagnosis.findings import FoundEffect


def manoeuvre_of(effect: str) -> str | None:
    """Name of the manoeuvre that shows an effect of the catalogue, by its identifier; None if there is none."""
    return next((entry.manoeuvre for entry in ENTRIES if entry.id == effect and entry.manoeuvre), None)


def advised(effects: Sequence[FoundEffect], unseen: Sequence[str]) -> tuple[str, ...]:
    """Choose up to three manoeuvres, by name, those first that serve most effects.

    They tell the found effects from their rivals, or, if there are no rivals, show effects that this recording could
    not show.
    """
    open_effects = [rival.id for effect in effects for rival in effect.ambiguous_with] + [
        effect.id for effect in effects if effect.ambiguous_with
    ]
    names = [name for name in (manoeuvre_of(effect) for effect in dict.fromkeys(open_effects or unseen)) if name]
    return tuple(sorted(dict.fromkeys(names), key=lambda name: -names.count(name))[:3])
