"""Formats of other people's logs: records of how a source becomes rows."""

from __future__ import annotations

from collections.abc import Callable, Collection
from dataclasses import dataclass
from pathlib import Path
from typing import Protocol

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.foundation.installation import DISTRIBUTION
from cocorosim_ros.scenario.reading.entry import Entry
from cocorosim_ros.wire.bags.file_kinds import kind_of, kind_or_table, told
from cocorosim_ros.wire.conversion.conversion_map import CsvLayout
from cocorosim_ros.wire.conversion.rows import Rows


class Log(Protocol):
    """A source that holds topics."""

    damage: tuple[str, ...]
    """Sentences about what is missing from it."""

    def rows(self, topic: str, place: Entry) -> Rows:
        """The messages of a topic; the error names the place in the map if there is none."""


@dataclass(frozen=True)
class FileFormat:
    """A format whose every file is one table with columns.

    rows: the rows of a file, from its path, its place below the source's folder, and how CSV is written.
    """

    summary: str
    kinds: tuple[str, ...]  # keys of `file_kinds.KINDS` that files of this format have; none for text
    rows: Callable[[Path, str, CsvLayout], Rows]


@dataclass(frozen=True)
class LogFormat:
    """A format whose source holds many topics.

    open: the log at a path.
    clock: the column of every topic that tells its time, and its unit; None where messages have stamps of ROS.
    """

    summary: str
    kinds: tuple[str, ...]
    open: Callable[[Path], Log]
    clock: tuple[str, str] | None = None

    @property
    def ros(self) -> bool:
        """Tell whether messages are of ROS: stamps in headers, SI units, lists that name their elements."""
        return self.clock is None


Format = FileFormat | LogFormat


BY_MAP = ", as the map says"
BY_NAME = ", as its name says"
UNSAID = ""  # no map is there, and the name says nothing


def check_file(path: Path, origin: str, summary: str, kinds: Collection[str], said: str = BY_MAP) -> None:
    """Nothing, if a file can be of that format by its first bytes. Raises CocorosimError otherwise.

    said: what tells that it is: BY_MAP, BY_NAME or UNSAID.
    """
    try:
        empty, kind = path.stat().st_size == 0, kind_or_table(path) if kinds else kind_of(path)
    except OSError as error:
        raise CocorosimError(f"{origin} cannot be read: {error.strerror}; check its name and permissions.") from error
    if empty and kinds:
        raise CocorosimError(f"{origin} is empty: nothing was recorded; give another file.")
    if kind is not None and kind.key not in kinds:
        raise CocorosimError(f"{origin} is not {summary}{said}: it {told(kind, path)}.")
    if kind is None and kinds:
        raise CocorosimError(
            f"{origin} is not {summary}{said}, and its kind is not known; give the right file, or save it "
            "as CSV or Parquet."
        )


def unreadable(origin: str, summary: str, error: Exception | str) -> CocorosimError:
    """The error for a file that begins as it should and cannot be read further."""
    reason = " ".join(str(error).split())[:160].rstrip(".")
    found = f" ({reason})" if reason else ""
    return CocorosimError(
        f"{origin} is damaged or ends early and cannot be read as {summary}{found}; copy it again or give another file."
    )


def missing_library(library: str, what: str) -> CocorosimError:
    """The error for a library that an optional format needs."""
    return CocorosimError(
        f"{what} needs the library {library}, which is not installed; install it by `pip install {library}`, or all "
        f'such libraries by `pip install "{DISTRIBUTION}[logs]"`.'
    )
