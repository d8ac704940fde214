"""The folder of a diagnosed fleet: an outcome for each recording, written at once, and what they were made with.

fleet.json                  which recordings, which platform, which code
outcomes/NAME.json          what became of the recording NAME; appears whole or not at all
fleet.parquet, fleet.html   what they show together, made anew each time

A process that is killed at any moment, this one too, loses the recordings that were being diagnosed, and nothing else.
"""

from __future__ import annotations

import hashlib
import json
import shutil
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from cocorosim_ros.diagnosis.fleet.outcome import Outcome, outcome_from
from cocorosim_ros.diagnosis.fleet.recordings import FleetRecording
from cocorosim_ros.foundation.errors import ArgumentError, CocorosimError
from cocorosim_ros.foundation.json_file import json_text
from cocorosim_ros.foundation.output_file import replace_file
from cocorosim_ros.foundation.resumed_folder import opening, refuse_foreign, remove_unfinished
from cocorosim_ros.scenario.parts.platform import Platform, platform_tree

NOTE, OUTCOMES, TABLE, PAGE = "fleet.json", "outcomes", "fleet.parquet", "fleet.html"
_OURS = (NOTE, OUTCOMES, TABLE, PAGE)


@dataclass(frozen=True)
class Order:
    """An order: the folder of the recordings, the platform with what is known of it, the code's version."""

    fleet: Path
    platform: Platform
    version: str

    def note(self) -> dict[str, Any]:
        """Content of fleet.json; outcomes of other notes are not comparable."""
        text = json.dumps(platform_tree(self.platform), sort_keys=True, default=str)
        return {
            "fleet": str(self.fleet.resolve()),
            "platform": self.platform.name,
            "platform_sha256": hashlib.sha256(text.encode()).hexdigest(),
            "version": self.version,
        }


@dataclass(frozen=True)
class Found:
    """Outcomes that are there. changed: recordings written since; again: those that are tried once more."""

    outcomes: dict[str, Outcome]
    changed: tuple[str, ...]
    again: tuple[str, ...]


class FleetStore:
    """Keeps the outcomes of one fleet."""

    def __init__(self, folder: Path, order: Order, *, force: bool = False) -> None:
        """Raises ArgumentError if the folder holds something else, or outcomes of another fleet, platform or code."""
        self._folder, self._order = folder, order
        with opening(folder):
            self._open(force)

    def add(self, outcome: Outcome) -> None:
        """Keep an outcome. Raises CocorosimError if a worker with other code has made it, or if there is no room."""
        if outcome.version != self._order.version:
            raise CocorosimError(
                f"A worker has version {outcome.version} of the program, this is {self._order.version}; what both find "
                "would not be comparable, so its diagnosis is not kept: give all workers this version and the same "
                "command again."
            )
        write_whole(self._place(outcome.recording), outcome.text().encode())

    def found(self, recordings: Sequence[FleetRecording]) -> Found:
        """Read the outcomes of these recordings, but for those that have changed since or are to be tried again."""
        outcomes, changed, again = {}, [], []
        for recording in recordings:
            path = self._place(recording.name)
            if not path.is_file():
                continue
            outcome = _read(path)
            if outcome is None or outcome.again:
                again.append(recording.name)
            elif outcome.files != recording.files:
                changed.append(recording.name)
            else:
                outcomes[recording.name] = outcome
        return Found(outcomes, tuple(changed), tuple(again))

    def left_over(self, recordings: Iterable[FleetRecording]) -> int:
        """Count outcomes of recordings that are no longer in the fleet."""
        there = {self._place(each.name) for each in recordings}
        return sum(path not in there for path in (self._folder / OUTCOMES).rglob("*.json"))

    def _place(self, name: str) -> Path:
        return self._folder / OUTCOMES / f"{name}.json"

    def _open(self, force: bool) -> None:
        refuse_foreign(self._folder, NOTE, _OURS.__contains__, "a fleet's diagnosis")
        if force:
            self._empty()
        note, mine = self._folder / NOTE, self._order.note()
        if note.is_file():
            _compare(self._folder, _read_note(note), mine)
        (self._folder / OUTCOMES).mkdir(parents=True, exist_ok=True)
        remove_unfinished(self._folder)
        replace_file(note, json_text(mine).encode())

    def _empty(self) -> None:
        shutil.rmtree(self._folder / OUTCOMES, ignore_errors=True)
        for name in (NOTE, TABLE, PAGE):
            (self._folder / name).unlink(missing_ok=True)


def write_whole(path: Path, content: bytes) -> None:
    """Write a file at once, below folders that are made if need be. Raises CocorosimError if it cannot be written."""
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        replace_file(path, content)
    except OSError as error:
        raise CocorosimError(
            f"{path} cannot be written: {error.strerror}; make room and give the same command again. What is finished "
            "is kept."
        ) from error


def _read(path: Path) -> Outcome | None:
    """Read an outcome; None if its file is damaged, so that its recording is diagnosed again."""
    try:
        return outcome_from(path.read_text("utf-8"))
    except (OSError, ValueError):
        return None


def _read_note(path: Path) -> dict[str, Any]:
    try:
        note = json.loads(path.read_text("utf-8"))
    except (OSError, ValueError) as error:
        note = " ".join(str(error).split())
    if not isinstance(note, dict):
        raise ArgumentError(
            f"{path} does not say which fleet the outcomes beside it belong to; put it back as it was, give another "
            "folder with 'out', or 'force' to start again.",
            "out",
            "force",
        )
    return note


def _compare(folder: Path, there: dict[str, Any], mine: dict[str, Any]) -> None:
    """Raise ArgumentError if the outcomes in a folder were made of another fleet, with another platform or code."""
    told = {
        "fleet": f"of another fleet, {there.get('fleet')}, not of {mine['fleet']}",
        "platform": f"with the platform '{there.get('platform')}', not with '{mine['platform']}'",
        "platform_sha256": f"with the platform '{mine['platform']}' as it was: its numbers, or what is taken as known, "
        "have changed since",
        "version": f"of version {there.get('version')} of the program, this is {mine['version']}",
    }
    for key, words in told.items():
        if there.get(key) != mine[key]:
            raise ArgumentError(
                f"The folder {folder} holds diagnoses {words}; both together would not be comparable: give another "
                "folder with 'out', or 'force' to start again.",
                "out",
                "force",
            )
