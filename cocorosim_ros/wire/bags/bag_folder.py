"""The place of a new recording: never over other people's files, over an old recording only when forced."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from cocorosim_ros.foundation.errors import ArgumentError, CocorosimError
from cocorosim_ros.wire.bags import bag_metadata

PROVISIONAL_NAME = bag_metadata.FILE_NAME + ".part"  # while metadata.yaml is being written
_MOST_NAMED = 3


def make_room(folder: Path, *, force: bool) -> None:
    """Make sure that the folder may be written: absent or, if forced, emptied of an old recording.

    Raises CocorosimError if it exists and is not to be replaced.
    """
    try:
        if not folder.exists():
            return
        if not folder.is_dir():
            raise CocorosimError(f"{folder} is a file; give the name of a folder that does not exist yet.")
        entries = sorted(folder.iterdir())
        if not force:
            raise ArgumentError(f"{folder} exists already; choose another folder, or replace it with 'force'.", "force")
        foreign = [entry for entry in entries if not _belongs_to_bag(entry)]
        if foreign:
            raise ArgumentError(_not_replaced(folder, foreign), "force")
        for entry in entries:
            entry.unlink()
    except OSError as error:
        raise CocorosimError(f"{folder} cannot be replaced: {error.strerror}; choose another folder.") from error


def _not_replaced(folder: Path, foreign: Sequence[Path]) -> str:
    """Why the folder stays, by what it holds beside the files of one recording."""
    others = [entry for entry in foreign if not (entry / bag_metadata.FILE_NAME).is_file()]
    if others:
        return (
            f"{folder} holds {others[0].name!r}, which is no part of a recording, so it is not replaced "
            "even with 'force'; choose another folder."
        )
    return (
        f"{folder} holds whole recordings ({', '.join(repr(entry.name) for entry in foreign[:_MOST_NAMED])}"
        f"{', ...' if len(foreign) > _MOST_NAMED else ''}), as a conversion of several runs leaves them, and would "
        "become one recording itself; so many are not replaced even with 'force': choose another folder, or remove "
        "this one first."
    )


def _belongs_to_bag(entry: Path) -> bool:
    metadata = (bag_metadata.FILE_NAME, PROVISIONAL_NAME)
    return entry.is_file() and (entry.name in metadata or entry.suffix == ".mcap")
