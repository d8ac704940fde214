"""The numbers of an effect that were shown to be there, and those that may as well be nothing."""

from __future__ import annotations

from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES
from cocorosim_ros.diagnosis.findings import FoundEffect


def not_shown_numbers(found: FoundEffect) -> tuple[str, ...]:
    """Name the amplitudes whose 95 % intervals hold the value at which they do nothing, in the effect's order.

    None where that is so of all of them: then the whole effect is in doubt, which its tier says.
    """
    doubts: dict[str, bool] = {}
    for entry in ENTRIES:
        if entry.id == found.id:
            doubts |= entry.doubts(found.parameters)
    doubtful = tuple(name for name in found.parameters if doubts.get(name))
    return doubtful if len(doubtful) < len(doubts) else ()
