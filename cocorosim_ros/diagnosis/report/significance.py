"""The numbers of an effect that were shown to be there, and those that may as well be nothing."""

from __future__ import annotations

from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES
from cocorosim_ros.diagnosis.findings import FoundEffect


def not_shown_numbers(found: FoundEffect) -> tuple[str, ...]:
    """Name the amplitudes whose 95 % intervals hold the value at which they do nothing, in the effect's order.

    None where that is so of all of them: then the whole effect is in doubt (`may_be_nothing`).
    """
    doubtful = doubtful_numbers(found)
    return doubtful if len(doubtful) < len(_doubts(found)) else ()


def doubtful_numbers(found: FoundEffect) -> tuple[str, ...]:
    """Name the amplitudes whose 95 % intervals hold the value at which they do nothing, be it all of them."""
    doubts = _doubts(found)
    return tuple(name for name in found.parameters if doubts.get(name))


def may_be_nothing(found: FoundEffect) -> bool:
    """Tell whether the 95 % interval of each amplitude of an effect holds the value at which it does nothing."""
    doubts = _doubts(found).values()
    return bool(doubts) and all(doubts)


def _doubts(found: FoundEffect) -> dict[str, bool]:
    """Tell of each amplitude, by name, whether its interval holds the value at which it does nothing."""
    if found.law is not None:
        return {name: each.holds(0.0) for name, each in found.parameters.items() if name == "coefficient"}
    doubts: dict[str, bool] = {}
    for entry in ENTRIES:
        if entry.id == found.id:
            doubts |= entry.doubts(found.parameters)
    return doubts
