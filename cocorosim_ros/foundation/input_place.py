"""Places of results that are places of inputs: nothing that is read is ever overwritten."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from cocorosim_ros.foundation.errors import ArgumentError


def refuse_inputs(place: Path | None, inputs: Iterable[Path]) -> None:
    """Nothing, unless a place to write is that of an input, lies within its folder or holds it.

    Links are followed. Raises CocorosimError then, whether what is there may be replaced or not.
    """
    if place is None:
        return
    resolved = place.resolve()
    for given in inputs:
        read = given.resolve()
        if resolved == read:
            found = f"is read by this command ({given})"
        elif read in resolved.parents:
            found = f"lies within {given}, which is read by this command"
        elif resolved in read.parents:
            found = f"holds {given}, which is read by this command"
        else:
            continue
        raise ArgumentError(f"{place} {found} and is not replaced, even with 'force'; choose another place.", "force")
