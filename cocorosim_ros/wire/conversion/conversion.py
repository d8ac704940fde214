"""A map and a source made into recordings of the contract; the same input gives the same bytes."""

from __future__ import annotations

import json
import shutil
from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import dataclass
from itertools import groupby
from pathlib import Path

import numpy as np

from cocorosim_ros import __version__
from cocorosim_ros.foundation.errors import ArgumentError, CocorosimError
from cocorosim_ros.wire.bags.bag_reader import read_bag
from cocorosim_ros.wire.bags.bag_writer import BagWriter, Channel
from cocorosim_ros.wire.cdr import type_store
from cocorosim_ros.wire.cdr.packed import PackedMessage
from cocorosim_ros.wire.conversion.assembly import Stream, joined, table_streams
from cocorosim_ros.wire.conversion.bag_rows import BagRows
from cocorosim_ros.wire.conversion.conversion_map import ConversionMap, TableMap
from cocorosim_ros.wire.conversion.csv_rows import CsvRows
from cocorosim_ros.wire.conversion.rows import Rows
from cocorosim_ros.wire.conversion.sources import Run, SourceFile, find_runs, sha256_of
from cocorosim_ros.wire.topics.topics import ROBOT_TOPICS, robot_topic

WORLD_FRAME = "world"


@dataclass(frozen=True)
class Conversion:
    """One recording, ready to be written."""

    run: str
    streams: tuple[Stream, ...]
    findings: tuple[str, ...]
    metadata: dict[str, str]


@dataclass(frozen=True)
class Converted:
    """One recording that was written."""

    folder: Path
    digest: str
    conversion: Conversion


def convert(
    mapped: ConversionMap,
    source: Path,
    out: Path,
    *,
    force: bool = False,
    progress: Callable[[str], None] = lambda run: None,
) -> list[Converted]:
    """The recordings made from a source: one in `out`, or one in out/RUN for each run if there are several.

    `progress` is told the name of each run before it is read. Raises CocorosimError for whatever is wrong with
    map or source, and if `out` exists and not `force`; then nothing is left behind.
    """
    if out.exists() and not force:
        told = f"{out} exists already; choose another place with 'out', or replace it with 'force'."
        raise ArgumentError(told, "out", "force")
    conversions = []
    for name, read in _runs(mapped, source):
        progress(name)
        conversions.append(_converted(mapped, name, read))
    several = len(conversions) > 1
    done: list[Converted] = []
    try:
        for conversion in conversions:
            done.append(_written(conversion, out / conversion.run if several else out, force=force))
    except BaseException:
        for written in done:
            shutil.rmtree(written.folder, ignore_errors=True)
        if several:
            with suppress(OSError):
                out.rmdir()
        raise
    return done


class _Source:
    """The rows of one run, table by table, with the sha256 of what they were read from."""

    def __init__(self) -> None:
        self.tables: list[tuple[TableMap, str, Rows]] = []
        self.hashes: dict[str, str] = {}
        self.findings: list[str] = []


def _runs(mapped: ConversionMap, source: Path) -> Iterator[tuple[str, Callable[[], _Source]]]:
    if mapped.from_bag:
        yield "", lambda: _bag_source(mapped, source)
        return
    for run in find_runs(mapped, source):
        yield run.name, lambda run=run: _csv_source(mapped, run)  # type: ignore[misc]


def _csv_source(mapped: ConversionMap, run: Run) -> _Source:
    found = _Source()
    for table, files in zip(mapped.tables, run.files, strict=True):
        for file in files:
            rows = _csv_rows(table, file)
            found.hashes[file.origin] = sha256_of(file.path)
            if rows.short:
                found.findings.append(f"{file.origin}: {rows.short} rows end early; their last cells count as missing.")
            found.tables.append((table, file.robot, rows))
        # A pattern for other runs only is no reason to complain.
        if not files and table.runs == "*":
            found.findings.append(f"No file fits '{table.source}', so its topics are missing.")
    return found


def _csv_rows(table: TableMap, file: SourceFile) -> CsvRows:
    return CsvRows(file.path, file.origin, table.layout)


def _bag_source(mapped: ConversionMap, source: Path) -> _Source:
    bag = read_bag(source)
    found = _Source()
    files = [source] if source.is_file() else sorted(path for path in source.iterdir() if path.is_file())
    found.hashes = {path.name: sha256_of(path) for path in files}
    if bag.summary.damage:
        found.findings.append(bag.summary.damage)
    for table in mapped.tables:
        rows = BagRows(bag, table.source, table.place)
        if rows.unreadable:
            found.findings.append(f"{rows.origin}: {rows.unreadable} messages cannot be read and were left out.")
        found.tables.append((table, "", rows))
    return found


def _converted(mapped: ConversionMap, run: str, read: Callable[[], _Source]) -> Conversion:
    source = read()
    findings = source.findings
    parts = [
        part for table, named, rows in source.tables for part in table_streams(table, rows, named, findings)
    ]  # fmt: skip
    order = {topic: place for place, topic in enumerate(ROBOT_TOPICS)}
    parts.sort(key=lambda part: (part.robot, order[part.topic]))
    groups = groupby(parts, key=lambda part: (part.robot, part.topic))
    streams = tuple(joined(list(group), findings) for _, group in groups)
    if not streams:
        where = f"run {run} of the source" if run else "the source"
        raise CocorosimError(f"{mapped.file} finds nothing to convert in {where}: {' '.join(findings)}")
    metadata = {
        "converted_from": json.dumps(source.hashes, sort_keys=True),
        "conversion_map": mapped.text,
        "conversion_name": mapped.name,
        "conversion_run": run,
        "conversion_findings": "\n".join(findings),
        "versions": json.dumps({"cocorosim_ros": __version__}),
    }
    return Conversion(run, streams, tuple(findings), metadata)


def _written(conversion: Conversion, folder: Path, *, force: bool) -> Converted:
    channels = [
        Channel(_topic(stream), ROBOT_TOPICS[stream.topic].type_name, ROBOT_TOPICS[stream.topic].quality)
        for stream in conversion.streams
    ]
    writer = BagWriter(folder, channels, metadata=conversion.metadata, force=force)
    try:
        for stamp, topic, data in _in_time_order(conversion.streams):
            writer.write(topic, stamp, stamp, data)
        digest = writer.close()
    except BaseException:
        writer.discard()
        raise
    return Converted(folder, digest, conversion)


def _in_time_order(streams: tuple[Stream, ...]) -> Iterator[tuple[int, str, bytes]]:
    """Stamp [ns], topic and bytes of all messages, those of one moment in the order of the streams."""
    encoders = [_encoder(stream) for stream in streams]
    topics = [_topic(stream) for stream in streams]
    stamps = np.concatenate([stream.stamp_ns for stream in streams])
    which = np.repeat(np.arange(len(streams)), [len(stream.stamp_ns) for stream in streams])
    row = np.concatenate([np.arange(len(stream.stamp_ns)) for stream in streams])
    for place in np.lexsort((row, which, stamps)):
        number, stamp = which[place], int(stamps[place])
        values = streams[number].rows.values[row[place]]
        yield stamp, topics[number], encoders[number].encode(stamp, values[None])[0]


def _encoder(stream: Stream) -> PackedMessage:
    frame = WORLD_FRAME if stream.topic == "pose" else f"{stream.robot}/base_link"
    content = {"header": {"frame_id": frame}, **stream.rows.extra}
    return PackedMessage([type_store.build(ROBOT_TOPICS[stream.topic].type_name, content)], stream.rows.fields)


def _topic(stream: Stream) -> str:
    return robot_topic(stream.robot, stream.topic)
