"""Numbers of a map that are not the same for every recording."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fnmatch import fnmatchcase

from cocorosim_ros.scenario.reading.entry import Entry, listed


@dataclass(frozen=True)
class RunWise:
    """A number [SI] for each recording, by patterns of its name with *; the first that fits counts."""

    values: tuple[tuple[str, float], ...]
    place: Entry

    def of(self, recording: str) -> float:
        """The number of a recording. Raises CocorosimError if no pattern fits its name."""
        for pattern, value in self.values:
            if fnmatchcase(recording, pattern):
                return value
        patterns = listed(f"'{pattern}'" for pattern, _ in self.values)
        raise self.place.problem(
            f"has no number for the recording '{recording}', only for {patterns}; add '{recording}' or '*'."
        )


Number = float | RunWise


def number_of(number: Number, recording: str) -> float:
    """The number [SI] as it is in that recording."""
    return number.of(recording) if isinstance(number, RunWise) else number


def read_number(entry: Entry, read: Callable[[Entry], float]) -> Number:
    """One number for all recordings, or a mapping of patterns of their names to numbers."""
    if not isinstance(entry.value, dict) or "value" in entry.value:
        return read(entry)
    parts: Mapping[str, Entry] = entry.mapping()
    if not parts:
        raise entry.problem("is empty; give a number, or one for each pattern of recordings' names.")
    return RunWise(tuple((pattern, read(part)) for pattern, part in parts.items()), entry)
