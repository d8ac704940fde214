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
from cocorosim_ros.wire.bags.bag_writer import BagWriter, Channel
from cocorosim_ros.wire.cdr import type_store
from cocorosim_ros.wire.cdr.packed import PackedMessage
from cocorosim_ros.wire.conversion.assembly import Stream, streams_of
from cocorosim_ros.wire.conversion.conversion_map import ConversionMap
from cocorosim_ros.wire.conversion.doubts import doubtful_times
from cocorosim_ros.wire.conversion.optional_tables import parts_of
from cocorosim_ros.wire.conversion.rows import Stamps
from cocorosim_ros.wire.conversion.source_tables import SourceRun, runs_of
from cocorosim_ros.wire.conversion.sources import check_there
from cocorosim_ros.wire.topics.topics import ROBOT_TOPICS, robot_topic

WORLD_FRAME = "world"
PRESSURE_FROM_DEPTH = "pressure_from_depth"
"""Key of what a recording says of the robots, as a JSON list, whose pressures were made of depths in fresh water."""
MEASURED_COMMANDS = "measured_commands"
"""Key of the same of the robots whose commands are what their actuators were measured to do."""


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
    check_there(mapped, source)
    conversions = []
    for run in runs_of(mapped, source):
        progress(run.name)
        conversions.append(_converted(mapped, run))
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


def _converted(mapped: ConversionMap, run: SourceRun) -> Conversion:
    source = run.read()
    findings = source.findings
    parts = parts_of(source.tables, run.recording, findings)
    order = {topic: place for place, topic in enumerate(ROBOT_TOPICS)}
    parts.sort(key=lambda part: (part.robot, order[part.topic]))
    groups = groupby(parts, key=lambda part: (part.robot, part.topic))
    streams = tuple(stream for _, group in groups for stream in streams_of(list(group), findings))
    if not streams:
        where = f"run {run.name} of the source" if run.name else "the source"
        raise CocorosimError(f"{mapped.file} finds nothing to convert in {where}: {' '.join(findings)}")
    stamps: dict[str, list[Stamps]] = {}
    for stream in streams:
        stamps.setdefault(_topic(stream), []).append(stream.stamp_ns)
    findings += doubtful_times(stamps)
    metadata = {
        "converted_from": json.dumps(source.hashes, sort_keys=True),
        "conversion_map": mapped.text,
        "conversion_name": mapped.name,
        "conversion_run": run.name,
        "conversion_findings": "\n".join(findings),
        "versions": json.dumps({"cocorosim_ros": __version__}),
    }
    of_depth = [stream.robot for stream in streams if stream.from_depth]
    if of_depth:
        metadata[PRESSURE_FROM_DEPTH] = json.dumps(of_depth)
    measured = [stream.robot for stream in streams if stream.measured]
    if measured:
        metadata[MEASURED_COMMANDS] = json.dumps(measured)
    return Conversion(run.name, streams, tuple(findings), metadata)


def _written(conversion: Conversion, folder: Path, *, force: bool) -> Converted:
    channels = {
        _topic(stream): Channel(
            _topic(stream), ROBOT_TOPICS[stream.topic].type_name, ROBOT_TOPICS[stream.topic].quality
        )
        for stream in conversion.streams
    }
    writer = BagWriter(folder, list(channels.values()), metadata=conversion.metadata, force=force)
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
