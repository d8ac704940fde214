"""The folder of a diagnosis, whose files appear together and whole, or not at all."""

from __future__ import annotations

import os
import shutil
from collections.abc import Callable, Mapping
from pathlib import Path
from tempfile import TemporaryFile

from cocorosim_ros.foundation.errors import ArgumentError

FILES = ("diagnosis.json", "model.yaml", "report.html", "next_manoeuvre.yaml")
OVERLAY_FOLDER = "overlay"
_PARTIAL = ".partial"
"""Ending of what is not written in full yet, which a diagnosis that was killed leaves behind."""
_UNFINISHED = f".overlay{_PARTIAL}"


def check_folder(folder: Path, *, force: bool, argument: str = "out") -> None:
    """Check that the files of a diagnosis can be written into a folder.

    argument: which one named the folder. Raises CocorosimError if that is a file, holds a diagnosis already (without
    `force`), holds other people's files and no diagnosis, or cannot be made or written.
    """
    if folder.exists() and not folder.is_dir():
        raise ArgumentError(f"{folder} is a file; give a folder with '{argument}'.", argument)
    there = [name for name in (*FILES, OVERLAY_FOLDER) if (folder / name).exists()]
    if there and not force:
        told = f"{folder / there[0]} exists already; give another folder with '{argument}', or 'force'."
        raise ArgumentError(told, argument, "force")
    foreign = sorted(each.name for each in folder.iterdir() if each.suffix != _PARTIAL) if folder.is_dir() else []
    if foreign and not there:
        told = (
            f"{folder} holds '{foreign[0]}', which is no part of a diagnosis, so nothing is written there, even with "
            f"'force'; give another folder with '{argument}'."
        )
        raise ArgumentError(told, argument, "force")
    _check_writing(folder, argument)


def _check_writing(folder: Path, argument: str) -> None:
    """Make the folder, and take it away again: what cannot be written is said before a diagnosis, not after it."""
    made = _missing(folder)
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with TemporaryFile(dir=folder):
            pass
    except OSError as error:
        raise _unwritable(folder, error, argument) from error
    finally:
        _take_away({}, folder / _UNFINISHED, made)


def _unwritable(folder: Path, error: OSError, argument: str) -> ArgumentError:
    told = f"The folder {folder} cannot be written: {error.strerror}; give another one with '{argument}'."
    return ArgumentError(told, argument)


def write_folder(
    folder: Path,
    texts: Mapping[str, str],
    overlay: Callable[[Path], None] | None = None,
    *,
    argument: str = "out",
) -> None:
    """Write the files, by name, into the folder, which is made if need be; older ones of FILES are taken away.

    overlay: function that writes the folder `overlay` at a place that does not exist yet; None if there is none, and
    then an older one is taken away too. Raises CocorosimError if anything fails; then everything is as it was.
    """
    made = _missing(folder)
    partial = {folder / f".{name}{_PARTIAL}": folder / name for name in texts}
    unfinished = folder / _UNFINISHED / OVERLAY_FOLDER
    try:
        folder.mkdir(parents=True, exist_ok=True)
        if overlay is not None:
            shutil.rmtree(unfinished, ignore_errors=True)
            overlay(unfinished)
        for path, text in zip(partial, texts.values(), strict=True):
            path.write_text(text, "utf-8")
        _exchange(folder, partial, unfinished if overlay is not None else None)
    except OSError as error:
        _take_away(partial, folder / _UNFINISHED, made)
        raise _unwritable(folder, error, argument) from error
    except BaseException:
        _take_away(partial, folder / _UNFINISHED, made)
        raise


def _exchange(folder: Path, partial: Mapping[Path, Path], overlay: Path | None) -> None:
    """Put what is written in the place of what was there."""
    for path, final in partial.items():
        os.replace(path, final)
    for name in FILES:
        if folder / name not in partial.values():
            (folder / name).unlink(missing_ok=True)
    if (folder / OVERLAY_FOLDER).is_dir():
        shutil.rmtree(folder / OVERLAY_FOLDER)
    if overlay is not None:
        os.replace(overlay, folder / OVERLAY_FOLDER)
        overlay.parent.rmdir()


def _missing(folder: Path) -> list[Path]:
    """The folder and those above it that do not exist, innermost first."""
    return [each for each in (folder, *folder.parents) if not each.exists()]


def _take_away(partial: Mapping[Path, Path], unfinished: Path, made: list[Path]) -> None:
    shutil.rmtree(unfinished, ignore_errors=True)
    for path in partial:
        try:
            path.unlink(missing_ok=True)
        except OSError:
            continue  # the folder was never made
    for folder in made:
        if folder.is_dir() and not any(folder.iterdir()):
            folder.rmdir()
