"""The rows of a source for each table of a map, run by run."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path

from cocorosim_ros.wire.conversion.beside import BesideRows, neighbour
from cocorosim_ros.wire.conversion.conversion_map import ConversionMap, TableMap
from cocorosim_ros.wire.conversion.formats import FORMATS
from cocorosim_ros.wire.conversion.formats.format import FileFormat, Log, LogFormat, check_file
from cocorosim_ros.wire.conversion.rows import Rows
from cocorosim_ros.wire.conversion.sources import Run, SourceFile, find_runs, sha256_of


@dataclass(frozen=True)
class SourceTable:
    """One table of a map for one file or topic: `robot` is what {robot} stands for, `rows` reads the rows.

    `rows` raises TopicError where a log lacks a topic.
    """

    table: TableMap
    robot: str
    rows: Callable[[], Rows]


@dataclass(frozen=True)
class Source:
    """The tables of one run, the sha256 of what they are read from, and what was found while reading."""

    tables: list[SourceTable] = field(default_factory=list)
    hashes: dict[str, str] = field(default_factory=dict)
    findings: list[str] = field(default_factory=list)

    def tell(self, rows: Rows) -> Rows:
        """Keep what is missing from rows, once if several tables read them."""
        if rows.damage and rows.damage not in self.findings:
            self.findings.append(rows.damage)
        return rows


@dataclass(frozen=True)
class SourceRun:
    """One run: its name, '' for the only one; how its recording is called in the map; and what reads its tables."""

    name: str
    recording: str
    read: Callable[[], Source]


def runs_of(mapped: ConversionMap, source: Path) -> Iterator[SourceRun]:
    """The runs of a source. Raises CocorosimError if it holds none."""
    chosen = FORMATS[mapped.format]
    if isinstance(chosen, LogFormat):
        yield SourceRun("", source.stem, partial(_log_source, mapped, chosen, source))
        return
    for run in find_runs(mapped, source):
        recording = run.name or (source.name if source.is_dir() else source.stem)
        yield SourceRun(run.name, recording, partial(_file_source, mapped, chosen, run))


def _file_source(mapped: ConversionMap, chosen: FileFormat, run: Run) -> Source:
    found = Source()
    for table, files in zip(mapped.tables, run.files, strict=True):
        for file in files:
            rows = _read(file, table, chosen, found)
            others = {name: _read(other, table, chosen, found) for name, other in file.beside.items()}
            found.tables.append(SourceTable(table, file.robot, partial(_beside, table, rows, others)))
        # A pattern for other runs only is no reason to complain.
        if not files and table.runs == "*":
            found.findings.append(f"No file fits '{table.source}', so its topics are missing.")
    return found


def _read(file: SourceFile, table: TableMap, chosen: FileFormat, found: Source) -> Rows:
    """The rows of one file; its hash and what is missing from it are kept."""
    check_file(file.path, file.origin, chosen.summary, chosen.kinds)
    rows = chosen.rows(file.path, file.origin, table.layout)
    found.hashes[file.origin] = sha256_of(file.path)
    return found.tell(rows)


def _log_source(mapped: ConversionMap, chosen: LogFormat, source: Path) -> Source:
    log = chosen.open(source)
    files = [source] if source.is_file() else sorted(path for path in source.iterdir() if path.is_file())
    found = Source(hashes={path.name: sha256_of(path) for path in files}, findings=list(log.damage))
    found.tables.extend(SourceTable(table, "", partial(_of_log, log, table, found)) for table in mapped.tables)
    return found


def _of_log(log: Log, table: TableMap, found: Source) -> Rows:
    """The messages of a table's topic, with those beside them."""
    rows = found.tell(log.rows(table.source, table.place))
    others = {name: found.tell(log.rows(each.source, each.place)) for name, each in table.beside.items()}
    return _beside(table, rows, others)


def _beside(table: TableMap, rows: Rows, others: Mapping[str, Rows]) -> Rows:
    """The rows with those nearest in time of others beside them, if there are others."""
    if not others:
        return rows
    own, _ = rows.stamps(table.time)
    brought = {
        name: neighbour(own, others[name], each.time or table.time, each.within_ns)
        for name, each in table.beside.items()
    }
    return BesideRows(rows, brought)
