"""The folder of a run: made, or emptied of an older run if that was asked for."""

from __future__ import annotations

import shutil
from pathlib import Path

from cocorosim_ros.foundation.errors import CocorosimError

RUN_PARTS = ("bag", "log", "metrics.json", "shoal.png", "live_metrics.json")


def prepare_folder(folder: Path, *, force: bool) -> Path:
    """An existing, empty run folder. Raises CocorosimError if there is a run and not `force`, or something else."""
    try:
        if folder.is_dir() and any(folder.iterdir()):
            _empty(folder, force=force)
        folder.mkdir(parents=True, exist_ok=True)
        probe = folder / ".writable"
        probe.touch()
        probe.unlink()
    except (FileExistsError, NotADirectoryError) as error:
        raise CocorosimError(f"{folder} is a file, or lies below one; give another folder with --out.") from error
    except OSError as error:
        raise CocorosimError(
            f"The folder {folder} cannot be written: {error.strerror}; give another one with --out."
        ) from error
    return folder


def _empty(folder: Path, *, force: bool) -> None:
    foreign = sorted(part.name for part in folder.iterdir() if part.name not in RUN_PARTS)
    if foreign:
        raise CocorosimError(
            f"The folder {folder} holds '{foreign[0]}', which is no part of a run, so it is not touched; "
            "give another folder with --out."
        )
    if not force:
        raise CocorosimError(f"The folder {folder} holds a run already; give another with --out, or --force.")
    for name in RUN_PARTS:
        part = folder / name
        shutil.rmtree(part) if part.is_dir() else part.unlink(missing_ok=True)
