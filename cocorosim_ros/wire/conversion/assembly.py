"""From rows to the streams of robots: sorted out by robot, gaps kept, what is dropped is counted and said."""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import SupportsInt

import numpy as np

from cocorosim_ros.foundation.arrays import Flags, Floats
from cocorosim_ros.foundation.counted import counted, either
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.wire.conversion import attitude
from cocorosim_ros.wire.conversion.conversion_map import (
    CommandValue,
    RobotMap,
    StreamMap,
    TableMap,
    TravelValue,
    UnknownValue,
)
from cocorosim_ros.wire.conversion.doubts import doubtful_angles
from cocorosim_ros.wire.conversion.rows import Rows, Stamps, in_si
from cocorosim_ros.wire.conversion.streams import (
    StreamRows,
    angles_among,
    has_no_heading,
    heading_of_travel,
    is_made_of_depth,
    named_rows,
    stream_rows,
    travels,
    without_heading,
)
from cocorosim_ros.wire.topics.actuator_feedback import FEEDBACK

COMMAND = "thruster_command"
_UNSET = "with an attitude of four zeros, which was not known,"


@dataclass(frozen=True)
class Stream:
    """The messages of one topic of one robot: (n,) stamps [ns] and their numbers."""

    robot: str
    topic: str
    stamp_ns: Stamps
    rows: StreamRows
    travels: bool = False  # the heading is still to be taken from the track
    sort: bool = False  # rows whose time runs backwards are sorted
    from_depth: bool = False  # pressures that were made of depths
    measured: bool = False  # commands that are what the actuators did
    source: str = ""  # file or topic, and table of the map, that it is from


def table_streams(table: TableMap, rows: Rows, named: str, findings: list[str]) -> Iterator[Stream]:
    """The streams of every robot in the rows of one file or topic; `named` is what {robot} is in its name."""
    stamps, timed = rows.stamps(table.time)
    if not timed.all():
        findings.append(f"{rows.origin}: {_rows_left_out(np.count_nonzero(~timed), 'without a time')}.")
    robots = _robots(table.robot, rows, named)
    for mapped in table.streams:
        columns = {
            name: in_si(value, rows)
            for name, value in mapped.values.items()
            if not isinstance(value, TravelValue | UnknownValue)
        }
        usable, unset = _usable(mapped, columns, timed, rows)
        for robot, mine in robots.items():
            place = f"{robot}/{mapped.topic} from {rows.origin}"
            for left_out, why in ((~usable & ~unset, "with missing or infinite numbers"), (unset, _UNSET)):
                if dropped := np.count_nonzero(mine & timed & left_out):
                    findings.append(f"{place}: {_rows_left_out(dropped, why)}.")
            chosen = mine & usable
            if not chosen.any():
                findings.append(f"{place}: no usable row, so there is no such topic.")
                continue
            kept = {name: column[chosen] for name, column in columns.items()}
            findings += doubtful_angles(place, angles_among(mapped), kept)
            content = _content(mapped, kept, place, findings)
            yield Stream(
                robot,
                mapped.topic,
                stamps[chosen],
                content,
                travels(mapped.values),
                table.sort,
                is_made_of_depth(mapped.topic, mapped.values),
                _is_measured(mapped),
                f"{rows.origin} ({table.place.key})",
            )


def _is_measured(mapped: StreamMap) -> bool:
    """Tell whether a stream of commands holds what all of its actuators were measured to do."""
    return all(isinstance(value, CommandValue) and value.measured for value in mapped.values.values())


def _usable(mapped: StreamMap, columns: Mapping[str, Floats], timed: Flags, rows: Rows) -> tuple[Flags, Flags]:
    """(n,) which rows have all numbers, and which have a quaternion that was never set.

    Raises CocorosimError for quaternions that are none, and for a pose of which no attitude was ever known.
    """
    given = np.isfinite(list(columns.values()))
    # An actuator whose current is not in every row still reports its rotation there.
    usable = timed & (given.any(axis=0) if mapped.topic == FEEDBACK else given.all(axis=0))
    if attitude.QUATERNION[0] not in columns:
        return usable, np.zeros(rows.count, dtype=bool)
    unset = attitude.unset(columns)
    if mapped.topic == "pose" and timed.any() and unset[timed].all():
        raise mapped.place.problem(
            f"has an attitude that is four zeros in all rows of {rows.origin}, so that it was never known; give 'yaw' "
            "instead: '{unknown: true}', or '{travel: true}', which takes it from the track."
        )
    usable &= ~unset
    attitude.check_normalised(columns, usable, rows, mapped.place)
    return usable, unset


def _rows_left_out(number: SupportsInt, why: str) -> str:
    return f"{counted(number, 'row')} {why} {either(number, 'was', 'were')} left out"


def streams_of(parts: list[Stream], findings: list[str]) -> list[Stream]:
    """The streams from the parts of one topic of one robot: one, or one for each table that tells of actuators.

    What actuators report is not held until others report. Raises CocorosimError as `joined`, and if two tables give
    the same number.
    """
    if parts[0].topic != FEEDBACK:
        return [joined(parts, findings)]
    pieces = _pieces(parts)
    names = [name for part in pieces for name in part.rows.extra["name"]]
    for name in names:
        if names.count(name) > 1:
            raise CocorosimError(f"{_name(parts[0])}: {name} is given by several tables; give it by one of them only.")
    return [joined([part], findings) for part in pieces]


def joined(parts: list[Stream], findings: list[str]) -> Stream:
    """One stream from the parts of one topic of one robot: pieces of a log, or actuators logged apart.

    Raises CocorosimError if time runs backwards and is not to be sorted, or the parts do not fit together.
    """
    if len({part.from_depth for part in parts}) > 1:
        raise CocorosimError(
            f"{_name(parts[0])} is given as 'depth' by one table and as 'pressure' by another, which are read by "
            "different weights of water; give it by one of them only."
        )
    ordered = [_in_order(part, findings) for part in _pieces(parts)]
    stream = ordered[0] if len(ordered) == 1 else _held_together(ordered, findings)
    stream = replace(stream, measured=all(part.measured for part in parts))
    repeated = np.count_nonzero(np.diff(stream.stamp_ns) == 0)
    if repeated:
        words = either(repeated, "repeats the stamp before it and was", "repeat the stamp before them and were")
        findings.append(f"{_name(stream)}: {counted(repeated, 'message')} {words} kept.")
    return _with_heading(stream) if stream.travels else stream


def _robots(mapped: RobotMap, rows: Rows, named: str) -> dict[str, Flags]:
    """(n,) which rows are whose, by the robots' names."""
    everything = np.ones(rows.count, dtype=bool)
    if mapped.column is None:
        name = mapped.name + _tidy(named, mapped.digits)
        return {_checked_name(name, rows.origin): everything}
    words = np.array([_tidy(word, mapped.digits) for word in rows.words(mapped.column)])
    names = sorted(set(words.tolist()) - {"", "nan"})
    return {_checked_name(mapped.name + name, rows.origin): words == name for name in names}


def _tidy(word: str, digits: int) -> str:
    """7.0 and 7 are the same robot, and 007 with three digits."""
    try:
        number = Fraction(word)
    except (ValueError, ZeroDivisionError):
        return word
    return str(number.numerator).zfill(digits) if number.denominator == 1 else word


def _checked_name(name: str, origin: str) -> str:
    if not name.replace("_", "a").isalnum() or not name.isascii() or not name[0].isalpha():
        raise CocorosimError(f"{origin} has a robot '{name}', no name for ROS; use a prefix and letters, digits and _.")
    return name


def _content(mapped: StreamMap, columns: Mapping[str, Floats], place: str, findings: list[str]) -> StreamRows:
    if mapped.topic == FEEDBACK:
        return named_rows("value", tuple(columns), np.column_stack(list(columns.values())))
    if mapped.topic != COMMAND:
        rows = stream_rows(mapped.topic, columns, north_east_down=mapped.north_east_down)
        return without_heading(rows) if has_no_heading(mapped.values) else rows
    values = np.column_stack(list(columns.values()))
    beyond = np.count_nonzero((np.abs(values) > 1.0).any(axis=1))
    if beyond:
        cut = f"{counted(beyond, 'command')} beyond -1..1 {either(beyond, 'was', 'were')} cut to it"
        limits = [value.place.key for value in mapped.values.values() if isinstance(value, CommandValue)]
        findings.append(f"{place}: {cut}; check the limits at '{limits[0]}'.")
    return named_rows("command", tuple(columns), np.clip(values, -1.0, 1.0))


def _pieces(parts: list[Stream]) -> list[Stream]:
    """Parts with the same fields put behind each other."""
    by_fields: dict[tuple[str, ...], list[Stream]] = {}
    for part in parts:
        by_fields.setdefault(part.rows.fields, []).append(part)
    return [_behind_each_other(same) if len(same) > 1 else same[0] for same in by_fields.values()]


def _behind_each_other(parts: list[Stream]) -> Stream:
    _refuse_overlap(parts)
    first = parts[0]
    values = np.vstack([part.rows.values for part in parts])
    stamps = np.concatenate([part.stamp_ns for part in parts])
    return replace(first, stamp_ns=stamps, rows=replace(first.rows, values=values), sort=all(p.sort for p in parts))


def _refuse_overlap(parts: list[Stream]) -> None:
    """Raise CocorosimError for parts that tell of the same time: they are no pieces of one log.

    Sorted, their readings would take turns, and a robot would be in two places.
    """
    by_start = sorted(parts, key=lambda part: int(part.stamp_ns.min()))
    for one, other in itertools.pairwise(by_start):
        common = int(min(one.stamp_ns.max(), other.stamp_ns.max()) - other.stamp_ns.min()) / 1e9
        if common > 0.0:
            raise CocorosimError(
                f"{_name(one)} is given by {one.source} and by {other.source} for the same {common:.6g} s; give it by "
                "one of them only, or tell them apart as robots or runs, by {robot} or {run} in 'files'."
            )


def _in_order(stream: Stream, findings: list[str]) -> Stream:
    back = np.flatnonzero(np.diff(stream.stamp_ns) < 0)
    if not back.size:
        return stream
    after = (stream.stamp_ns[back[0]] - stream.stamp_ns[0]) / 1e9
    by = (stream.stamp_ns[back[0]] - stream.stamp_ns[back[0] + 1]) / 1e9
    places = counted(back.size, "place")
    found = f"{_name(stream)}: time runs backwards at {places}, first by {by:.6g} s, {after:.6g} s after "
    if not stream.sort:
        raise CocorosimError(f"{found}its first row; correct the log, or write 'backwards: sort' into its table.")
    findings.append(f"{found}its first row; the rows were sorted.")
    order = np.argsort(stream.stamp_ns, kind="stable")
    rows = replace(stream.rows, values=stream.rows.values[order])
    return replace(stream, stamp_ns=stream.stamp_ns[order], rows=rows)


def _held_together(parts: list[Stream], findings: list[str]) -> Stream:
    """Commands of actuators that were logged apart: at every change all of them, each as it last was."""
    first = parts[0]
    names = [name for part in parts for name in part.rows.extra.get("name", [])]
    if first.topic != COMMAND or len(set(names)) < len(names):
        raise CocorosimError(
            f"{_name(first)} is given by several tables with different numbers; give it by one of them only."
        )
    stamps = np.unique(np.concatenate([part.stamp_ns for part in parts]))
    latest = [np.searchsorted(part.stamp_ns, stamps, side="right") - 1 for part in parts]
    known = np.min(latest, axis=0) >= 0
    if not known.any():
        raise CocorosimError(f"{_name(first)}: {', '.join(names)} are never known together; check the times.")
    if not known.all():
        early = np.count_nonzero(~known)
        words = f"{counted(early, 'moment')} before all actuators are known {either(early, 'was', 'were')} left out"
        findings.append(f"{_name(first)}: {words}.")
    values = np.hstack([part.rows.values[rows[known]] for part, rows in zip(parts, latest, strict=True)])
    return replace(first, stamp_ns=stamps[known], rows=named_rows("command", tuple(names), values))


def _with_heading(stream: Stream) -> Stream:
    yaw = heading_of_travel(stream.rows.values[:, :3])
    values = stream.rows.values.copy()
    values[:, 3:] = 0.0
    values[:, 5], values[:, 6] = np.sin(yaw / 2), np.cos(yaw / 2)
    return replace(stream, rows=replace(stream.rows, values=values))


def _name(stream: Stream) -> str:
    return f"{stream.robot}/{stream.topic}"
