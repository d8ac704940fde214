"""Files of another kind than the one that is asked for, called what they are."""

from __future__ import annotations

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.reading.entry import Entry

_OF_MAPS = "tables"
"""A key that maps of `convert` have, and no other file."""


def refuse_maps(entry: Entry, wanted: str) -> None:
    """Raise CocorosimError for a map of `convert` where a platform, or what else is `wanted`, is asked for."""
    if _OF_MAPS in entry.mapping():
        raise CocorosimError(
            f"{entry.file} is a map of `cocorosim convert` ('{_OF_MAPS}' is there), no {wanted}; give a file as "
            f"`cocorosim new {wanted} NAME` writes one."
        )
