"""Files of results: whether one may be written, asked before the work that fills it, and the writing itself."""

from __future__ import annotations

import os
from collections.abc import Iterable
from pathlib import Path

from cocorosim_ros.foundation.errors import ArgumentError, CocorosimError
from cocorosim_ros.foundation.input_place import refuse_inputs

NEW = ".new"
"""What follows the name of a file that is not written in full yet."""


def check_file(file: Path | None, *, force: bool, inputs: Iterable[Path] = ()) -> None:
    """Nothing, if the file can be written, or if there is none to write.

    inputs: files and folders that are read. Raises CocorosimError if it exists (without `force`), is a folder, lies in
    none, may not be written, or is an input or part of one.
    """
    if file is None:
        return
    if file.is_dir() or not file.absolute().parent.is_dir():
        wrong = "is a folder" if file.is_dir() else "lies in a folder that does not exist"
        raise CocorosimError(f"{file} {wrong}; give the name of a file in a folder that exists.")
    refuse_inputs(file, inputs)
    if file.exists() and not force:
        raise ArgumentError(f"{file} exists already and is not overwritten; choose another name, or 'force'.", "force")
    if not os.access(file if file.exists() else file.absolute().parent, os.W_OK):
        raise CocorosimError(f"{file} may not be written by you; give a file in a folder of your own.")


def write_text(file: Path, text: str) -> None:
    """Write `text` in UTF-8. Raises CocorosimError if it cannot be written."""
    try:
        file.write_text(text, "utf-8")
    except OSError as error:
        raise CocorosimError(f"{file} cannot be written: {error.strerror}; give another file.") from error


def replace_file(file: Path, content: bytes) -> None:
    """Put content in the place of a file, which is there in full or as it was, even if the power fails.

    Raises OSError if it cannot be written.
    """
    new = file.with_name(file.name + NEW)
    with open(new, "wb") as stream:
        stream.write(content)
        stream.flush()
        os.fsync(stream.fileno())
    os.replace(new, file)
