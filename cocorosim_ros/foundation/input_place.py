"""Places of results that are places of inputs: nothing that is read is ever overwritten."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from cocorosim_ros.foundation.errors import ArgumentError

_PARTS = frozenset({".mcap", ".db3", ".zstd", ".bag", ".ulg", ".bin", ".tlog", ".csv", ".txt", ".tsv", ".dat", ".log",
                    ".parquet", ".npz", ".mat"})  # fmt: skip
"""How files end that make up a recording or a log of several files."""
_METADATA = "metadata.yaml"
"""The file of a recording that tells which others belong to it."""


def refuse_inputs(place: Path | None, inputs: Iterable[Path]) -> None:
    """Nothing, unless a place to write is that of an input, of a part of it, or holds it.

    A page, a picture or a folder of results may lie within the folder of a recording. Links are followed. Raises
    CocorosimError otherwise, whether what is there may be replaced or not.
    """
    if place is None:
        return
    resolved = place.resolve()
    for given in inputs:
        read = given.resolve()
        if resolved == read:
            found = f"is read by this command ({given})"
        elif read in resolved.parents and (resolved.suffix in _PARTS or resolved.name == _METADATA):
            found = f"is a part of {given}, which is read by this command,"
        elif resolved in read.parents:
            found = f"holds {given}, which is read by this command"
        else:
            continue
        raise ArgumentError(f"{place} {found} and is not replaced, even with 'force'; choose another place.", "force")
