"""Holes of a log: times through which no model can be run, mostly since nothing tells what was commanded.

A reading that is missing only makes the motion less sure, since the commands foretell it. Where a recorder was off, or
a part of the file is damaged, the commands are missing too: the last one before the hole would be taken to hold to its
end, and what it did not do would pass for a fault of the model. So each part between holes is a course of its own.
Times afloat are holes too: there the hull is not under water, as it is in every model.
"""

from __future__ import annotations

import numpy as np

from cocorosim_ros.diagnosis.criteria.evidence import SPACING, SUFFICIENCY
from cocorosim_ros.diagnosis.evidence.cleaning import gaps_of
from cocorosim_ros.diagnosis.evidence.streams.log import RobotLog
from cocorosim_ros.foundation.arrays import Floats

Span = tuple[float, float]
"""Begin and end [s]."""


def holes_of(log: RobotLog) -> tuple[Span, ...]:
    """Holes of a log, ascending: its pauses, and when it lies at the surface."""
    return _merged(sorted([*_pauses_of(log), *log.afloat]))


def _pauses_of(log: RobotLog) -> tuple[Span, ...]:
    """Spans, ascending, in which all streams and commands pause, or commands alone that come evenly.

    Commands that are sent when they change hold until the next one; a pause of these alone is no hole.
    """
    found = list(gaps_of(_all_stamps(log)))
    if _is_even(log.command_time):
        found += gaps_of(log.command_time)
    return _merged(sorted(found))


def parts_of(log: RobotLog) -> tuple[Span, ...]:
    """Begin and end [s] of the parts of a log between its holes that are long enough to show a motion.

    A part after a hole begins with a command, because none is known before. The whole log is one part without holes.
    """
    stamps = _all_readings(log)
    holes = holes_of(log)
    if not holes or not len(stamps):
        return ((float(stamps[0]), float(stamps[-1])),) if len(stamps) else ()
    begins = [float(stamps[0]), *(_first(log.command_time, end) for _, end in holes)]
    ends = [*(begin for begin, _ in holes), float(stamps[-1])]
    spans = [_within(stamps, begin, end) for begin, end in zip(begins, ends, strict=True)]
    parts = tuple(span for span in spans if span[1] - span[0] >= SUFFICIENCY.shortest)
    return parts or (max(spans, key=lambda span: span[1] - span[0]),)


def hole_sentences(log: RobotLog) -> list[str]:
    """Remarks on the pauses of a log."""
    return [
        f"{log.name}: no command is known from {begin:.1f} to {end:.1f} s; what was recorded before and after is taken "
        "as separate courses."
        for begin, end in _pauses_of(log)
    ]


def _all_readings(log: RobotLog) -> Floats:
    times = [stream.time for stream in log.streams.values()]
    return np.unique(np.concatenate(times)) if times else np.empty(0)


def _all_stamps(log: RobotLog) -> Floats:
    """Stamps of readings and commands, those that differ by less than the usual interval of the slowest taken once."""
    times = [time for time in (log.command_time, *(stream.time for stream in log.streams.values())) if len(time) > 1]
    if not times:
        return np.empty(0)
    slowest = max(float(np.median(np.diff(time))) for time in times)
    ticks = np.unique(np.floor(np.concatenate(times) / slowest)) if slowest > 0.0 else np.empty(0)
    every = np.unique(np.concatenate(times))
    return every[np.searchsorted(np.floor(every / slowest), ticks)] if len(ticks) else every


def _is_even(time: Floats) -> bool:
    """Tell whether stamps come at a steady rate: nearly all of their intervals are at most twice the usual one."""
    steps = np.diff(time)
    return len(steps) > 2 and bool(np.mean(steps <= SPACING.even * np.median(steps)) >= SPACING.nearly_all)


def _merged(spans: list[Span]) -> tuple[Span, ...]:
    """Spans in ascending order, those that overlap joined."""
    merged: list[Span] = []
    for begin, end in spans:
        if merged and begin <= merged[-1][1]:
            merged[-1] = (merged[-1][0], max(end, merged[-1][1]))
        else:
            merged.append((begin, end))
    return tuple(merged)


def _first(time: Floats, moment: float) -> float:
    """First of the stamps at or after a moment [s]; the moment where there is none."""
    later = time[time >= moment]
    return float(later[0]) if len(later) else moment


def _within(stamps: Floats, begin: float, end: float) -> Span:
    """First and last of the stamps from `begin` to `end` [s]; an empty span where there is none."""
    inside = stamps[(stamps >= begin) & (stamps <= end)]
    return (float(inside[0]), float(inside[-1])) if len(inside) else (begin, begin)
