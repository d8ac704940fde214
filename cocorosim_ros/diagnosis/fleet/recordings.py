"""Recordings of a fleet: everything below a folder that is a bag, or looks like one."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from cocorosim_ros.foundation.errors import ArgumentError
from cocorosim_ros.wire.bags.bag_metadata import FILE_NAME
from cocorosim_ros.wire.bags.bag_reader import RUN_PART

# What a robot has recorded, also if only `cocorosim convert` reads it: it is listed with a sentence then.
_SUFFIXES = (".mcap", ".mcap.zstd", ".db3", ".bag")
_RESULTS = ("diagnosis.json", "fleet.json")  # folders of results hold bags too, which are no recordings


@dataclass(frozen=True)
class FileState:
    """One file of a recording: if its size [bytes] or its time [ns] differ, it has been written since."""

    name: str
    size: int
    changed_ns: int


@dataclass(frozen=True)
class FleetRecording:
    """One recording of a fleet. name: its path below the fleet's folder, with slashes."""

    name: str
    path: Path
    files: tuple[FileState, ...]


def find_recordings(fleet: Path) -> tuple[FleetRecording, ...]:
    """Find all bags below a folder, in the order of their names; folders with results of a diagnosis are left out.

    Raises ArgumentError if there is no such folder, if it is a recording itself, or if no recording lies below it.
    """
    if not fleet.is_dir():
        wrong = "is a file" if fleet.exists() else "does not exist"
        raise ArgumentError(f"{fleet} {wrong}; give the folder that holds the recordings with 'fleet'.", "fleet")
    if _is_recording(fleet):
        raise ArgumentError(
            f"{fleet} is a recording itself; give the folder that holds the recordings with 'fleet', or diagnose this "
            "one without it.",
            "fleet",
        )
    found = tuple(sorted(_below(fleet, fleet, frozenset()), key=lambda each: each.name))
    if not found:
        raise ArgumentError(
            f"No recording lies below {fleet} (no rosbag2 folder and no {', '.join(_SUFFIXES)} file); give another "
            "folder with 'fleet', or bring other logs into bags with `cocorosim convert`.",
            "fleet",
        )
    return found


def _below(folder: Path, fleet: Path, seen: frozenset[Path]) -> Iterator[FleetRecording]:
    """Recordings below a folder; seen: resolved folders above it, since links may lead back."""
    try:
        parts = sorted(folder.iterdir())
        within = seen | {folder.resolve()}
    except OSError:
        yield _recording(folder, fleet, [])  # reading it says what is wrong
        return
    for part in parts:
        if part.name.startswith("."):
            continue
        try:
            found = list(_at(part, fleet, within))
        except OSError:  # a folder that may not be entered
            found = [_recording(part, fleet, [])]
        yield from found


def _at(part: Path, fleet: Path, within: frozenset[Path]) -> Iterator[FleetRecording]:
    """The recording at a path, or those below it. Raises OSError for a folder that may not be entered."""
    if part.is_dir():
        if _is_recording(part):
            yield _recording(part, fleet, _files_in(part))
        elif part.resolve() not in within and not _holds_results(part):
            yield from _below(part, fleet, within)
    elif part.name.endswith(_SUFFIXES):
        yield _recording(part, fleet, [part])


def _is_recording(folder: Path) -> bool:
    """Tell whether a folder is a rosbag2 folder, or that of a run with one in it."""
    bag = folder / RUN_PART
    return (folder / FILE_NAME).exists() or (bag / FILE_NAME).exists() or (bag.is_dir() and any(bag.glob("*.mcap")))


def _holds_results(folder: Path) -> bool:
    return any((folder / name).exists() for name in _RESULTS)


def _files_in(folder: Path) -> list[Path]:
    """Files of a rosbag2 folder, or of the one in a run's folder."""
    bag = folder if (folder / FILE_NAME).exists() else folder / RUN_PART
    return sorted(path for path in bag.iterdir() if path.is_file())


def _recording(path: Path, fleet: Path, files: list[Path]) -> FleetRecording:
    return FleetRecording(path.relative_to(fleet).as_posix(), path, tuple(_state(file, fleet) for file in files))


def _state(file: Path, fleet: Path) -> FileState:
    name = file.relative_to(fleet).as_posix()
    try:
        found = file.stat()
    except OSError:  # a link to nowhere
        return FileState(name, -1, 0)
    return FileState(name, found.st_size, found.st_mtime_ns)
