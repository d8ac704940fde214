"""The numbers of an effect that were shown to be there, and those that may as well be nothing."""

from __future__ import annotations

from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES
from cocorosim_ros.diagnosis.findings import FoundEffect

_NEUTRAL = {(entry.id, part.name): part.neutral for entry in ENTRIES for part in entry.amplitudes}


def not_shown_numbers(found: FoundEffect) -> tuple[str, ...]:
    """Name the amplitudes whose 95 % intervals hold the value at which they do nothing, in the effect's order.

    None where that is so of all of them: then the whole effect is in doubt, which its tier says.
    """
    known = [(name, _NEUTRAL[found.id, name]) for name in found.parameters if (found.id, name) in _NEUTRAL]
    doubtful = tuple(name for name, neutral in known if found.parameters[name].holds(neutral))
    return doubtful if len(doubtful) < len(known) else ()
