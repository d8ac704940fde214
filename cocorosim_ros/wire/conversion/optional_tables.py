"""The tables of a map one after the other: those that a log may lack, and those that stand in for others."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.reading.entry import listed
from cocorosim_ros.wire.conversion.assembly import COMMAND, Stream, table_streams
from cocorosim_ros.wire.conversion.conversion_map import TableMap
from cocorosim_ros.wire.conversion.rows import TopicError
from cocorosim_ros.wire.conversion.source_tables import SourceTable
from cocorosim_ros.wire.topics.actuator_feedback import FEEDBACK


def parts_of(tables: Sequence[SourceTable], recording: str, findings: list[str]) -> list[Stream]:
    """The streams of all tables; what an optional table lacks is told in `findings`.

    Raises TopicError for a table that is not optional and whose topic the log lacks, another CocorosimError if with the
    optional ones everything is missing that shows motion.
    """
    parts: list[Stream] = []
    lacking: dict[str, list[TableMap]] = {}  # by topic
    for each in tables:
        table = each.table.for_recording(recording)
        if _is_given(parts, table.robot.name, table):
            continue
        try:
            rows = each.rows()
        except TopicError as error:
            if not table.optional:
                raise
            lacking.setdefault(error.topic, []).append(table)
            continue
        made = table_streams(table, rows, each.robot, findings)
        parts += [part for part in made if not _is_given(parts, part.robot, table)]
    if lacking:
        findings.append(_told(lacking, parts))
    return parts


def _is_given(parts: Sequence[Stream], robot: str, table: TableMap) -> bool:
    """Tell whether tables before this one give what it stands in for."""
    return any(part.robot == robot and part.topic in table.unless for part in parts)


def _told(lacking: Mapping[str, Sequence[TableMap]], parts: Sequence[Stream]) -> str:
    """The sentence on topics whose tables were left out. Raises CocorosimError if what remains shows no motion."""
    streams = {topic: [each.topic for table in tables for each in table.streams] for topic, tables in lacking.items()}
    told = listed((f"{topic} (for {listed(dict.fromkeys(names), 'and')})" for topic, names in streams.items()), "and")
    if all(part.topic in (COMMAND, FEEDBACK) for part in parts):
        ((first, *_), *_) = lacking.values()
        raise CocorosimError(
            f"{first.place.file}: the log lacks {told}, and without any of these nothing shows how the vehicle moved; "
            "record one of them, or write a map of what the log has."
        )
    return f"The log lacks {told}, which the map calls optional; what else the map takes from it is there."
