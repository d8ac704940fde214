"""Topics of which a log may hold several: `XKF1[0]` is the first of them alone."""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping

import numpy as np

from cocorosim_ros.scenario.reading.entry import Entry, listed
from cocorosim_ros.wire.conversion.formats.column_rows import ColumnRows
from cocorosim_ros.wire.conversion.rows import TopicError

_INSTANCE = re.compile(r"(.+)\[(\d+)\]")


def split(topic: str) -> tuple[str, int | None]:
    """The topic's name, and which of them is asked for."""
    match = _INSTANCE.fullmatch(topic)
    return (match[1], int(match[2])) if match else (topic, None)


def wanted_instance(topic: str, wanted: int | None, there: Collection[int], place: Entry, log: str) -> int:
    """The instance that is meant of those that are there.

    Raises TopicError if it is not there, another CocorosimError if it is open which is meant.
    """
    names = [f"{topic}[{number}]" for number in sorted(there)]
    if wanted is None and len(there) == 1:
        return next(iter(there))
    if wanted is None:
        raise place.problem(f"names {topic}, of which {log} has several; write {listed(names)}.")
    if wanted not in there:
        name = f"{topic}[{wanted}]"
        told = f"names {name}, which {log} does not have; write {listed(names)}."
        raise TopicError(name, str(place.problem(told)))
    return wanted


def rows_of(origin: str, messages: list[Mapping[str, object]]) -> ColumnRows:
    """The rows of messages with the same fields; fields that are lists become `name[0]`, `name[1]`."""
    columns = {}
    for name in messages[0]:
        cells = [message[name] for message in messages]
        columns[name] = np.array(cells) if isinstance(cells[0], (int, float, list)) else np.array(cells, dtype=object)
    return ColumnRows(origin, columns)
