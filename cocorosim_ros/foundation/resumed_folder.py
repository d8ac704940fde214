"""Folders of long work that the same command goes on with: opened with sentences, and never one of something else."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

from cocorosim_ros.foundation.errors import ArgumentError
from cocorosim_ros.foundation.output_file import NEW


@contextmanager
def opening(folder: Path) -> Iterator[None]:
    """Turn what the system refuses within into sentences. Raises ArgumentError."""
    try:
        yield
    except (FileExistsError, NotADirectoryError) as error:
        told = f"{folder} is a file, or lies below one; give another folder with 'out'."
        raise ArgumentError(told, "out") from error
    except OSError as error:
        told = f"The folder {folder} cannot be written: {error.strerror}; give another one with 'out'."
        raise ArgumentError(told, "out") from error


def refuse_foreign(folder: Path, note: str, is_ours: Callable[[str], bool], whole: str) -> None:
    """Refuse a folder that holds something else: a name that is not ours, or ours without the note. May not be there.

    note: name of the file that says what the work is; files that are not written in full yet need none. whole: words
    for what such a folder holds. Raises ArgumentError.
    """
    there = sorted(part.name for part in folder.iterdir()) if folder.is_dir() else []
    finished = [name for name in there if not name.endswith(NEW)]
    foreign = [name for name in finished if not is_ours(name)]
    if foreign or (finished and note not in there):
        raise ArgumentError(
            f"The folder {folder} holds '{(foreign or there)[0]}', which is no part of {whole}, so it is not touched; "
            "give another folder with 'out'.",
            "out",
        )


def remove_unfinished(folder: Path) -> None:
    """Remove files that a killed process has not written in full."""
    for unfinished in folder.rglob(f"*{NEW}"):
        unfinished.unlink()
