"""Angles that drive a vehicle: those that its actuators report, or those ordered, whichever explains its motion.

A reported angle is where a rudder stands, unless the report comes late by a telemetry of its own or is of another part.
So the platform's own numbers are fitted with either before anything is called missing, and the likelihood chooses. Each
is given the delay that serves it best: where all readings are late, the later of two angles would win by that alone.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from typing import NamedTuple

from cocorosim_ros.diagnosis.criteria.fitting import ACTING_ANGLES
from cocorosim_ros.diagnosis.evidence.streams.log import Evidence, RobotLog
from cocorosim_ros.diagnosis.fitting.fit import Fit, evaluated, finite
from cocorosim_ros.diagnosis.tracks.columns import COLUMN, COMMAND_DELAY
from cocorosim_ros.diagnosis.tracks.track import Track


class Driven(NamedTuple):
    """A base fit, and sentences on what drives it where angles are reported."""

    base: Fit
    sentences: tuple[str, ...] = ()


def driven_as_shown(evidence: Evidence, fitted: Callable[[Evidence], Fit]) -> Driven:
    """Fit the base with reported angles and with those ordered; the orders drive it unless reports are clearly ahead.

    Without any report it is fitted once.
    """
    reported = fitted(evidence)
    if not reports_act(log for recording in evidence.recordings for log in recording.robots):
        return Driven(reported)
    ordered = fitted(as_ordered(evidence))
    nats = _best_delayed(reported) - _best_delayed(ordered)
    if nats > ACTING_ANGLES.clear or not finite(ordered):
        return Driven(reported, tuple(_reports_win(reported.tracks, nats)))
    return Driven(ordered, tuple(_orders_win(reported.tracks, nats)))


def _best_delayed(fit: Fit) -> float:
    """Objective of a fit with the one of a few delays of its commands that explains most, all else as it is [nats]."""
    found = [fit.objective]
    for delay in ACTING_ANGLES.delays:
        rows = fit.rows.copy()
        rows[:, COLUMN[COMMAND_DELAY]] += delay
        found.append(evaluated(replace(fit, rows=rows)).objective)
    return max(found)


def reports_act(logs: Iterable[RobotLog]) -> bool:
    """Tell whether reported angles act in any of these logs."""
    return any(log.acting is not None for log in logs)


def as_ordered(evidence: Evidence) -> Evidence:
    """Let all actuators of the evidence act as they were ordered."""
    recordings = tuple(
        replace(recording, robots=tuple(replace(log, acting=None) for log in recording.robots))
        for recording in evidence.recordings
    )
    return replace(evidence, recordings=recordings)


def _reports_win(tracks: Iterable[Track], nats: float) -> Iterator[str]:
    for robot, names in _reporting(tracks).items():
        yield (
            f"{robot}: the model is driven by the angles that {names} reports, which explain its motion {nats:.0f} "
            "nats better than those ordered. What is found is about the rest of it; in a simulation of it angles are "
            "there as soon as they are ordered."
        )


def _orders_win(tracks: Iterable[Track], nats: float) -> Iterator[str]:
    for robot, names in _reporting(tracks).items():
        yield (
            f"{robot}: the model is driven by the angles that were ordered, since those that {names} reports do not "
            f"explain its motion clearly better ({nats:.0f} nats): they may come late themselves, or be those of "
            "another part."
        )


def _reporting(tracks: Iterable[Track]) -> dict[str, str]:
    """Names of the actuators whose reported angles act, by robot."""
    found: dict[str, dict[str, None]] = {}
    for track in tracks:
        if track.log.acting is not None:
            found.setdefault(track.log.name, {}).update(dict.fromkeys(track.log.acting.reported))
    return {robot: ", ".join(names) for robot, names in found.items()}
