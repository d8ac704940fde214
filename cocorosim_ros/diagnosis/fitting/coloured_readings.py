"""A model whose readings have coloured errors, for recordings that show such.

Errors of an instrument may last for longer than it takes to the next reading, as those of a tracker or of a compass
beside iron do. Taken as white they count as often as there are readings, and slow errors of a reading become evidence
of what acts slowly. Such errors are first-order processes here (`filter.coloured`), with a memory for each number of
noise.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from cocorosim_ros.diagnosis.criteria.fitting import COLOURED, RECALIBRATION
from cocorosim_ros.diagnosis.filter.layout import KINDS_OF_STREAM
from cocorosim_ros.diagnosis.fitting.climbing import settled, with_noise
from cocorosim_ros.diagnosis.fitting.fit import Fit, evaluated
from cocorosim_ros.diagnosis.fitting.unknowns import READING, Owner, Unknown
from cocorosim_ros.diagnosis.tracks.by_robot import tracks_by_robot
from cocorosim_ros.diagnosis.tracks.columns import NOISE_UNITS, READING_MEMORY, READING_NOISE, READING_NOISE_OF_KIND
from cocorosim_ros.foundation.arrays import Floats, Integers

MEMORY_OF = dict(zip(READING_NOISE, READING_MEMORY, strict=True))
NOISE_OF = dict(zip(READING_MEMORY, READING_NOISE, strict=True))
STREAM_OF = {READING_NOISE_OF_KIND[kind]: stream for stream, kinds in KINDS_OF_STREAM.items() for kind in kinds}
"""Stream of a number of noise, by its name without what stands before the point."""


def with_obvious_colour(first: Fit, roughly: Fit) -> Fit | None:
    """Add coloured errors to a first guess where most instruments show them already in a rough fit; else None.

    What a model lacks makes the innovations of some instruments resemble the ones before, but hardly those of most of
    them, each by itself. With white errors such recordings take minutes to fit, and much is named for nothing.
    """
    found = _with_suspects(roughly)
    added = found.noise[len(roughly.noise) :]
    for robots in {unknown.owner.robots for unknown in added}:
        seen = {_stream_of(unknown.column) for unknown in roughly.noise if unknown.owner.robots == robots} - {None}
        shown = {_stream_of(unknown.column) for unknown in added if unknown.owner.robots == robots}
        if len(shown) <= COLOURED.most * len(seen) or len(shown) < COLOURED.instruments:
            added = tuple(unknown for unknown in added if unknown.owner.robots != robots)
    return _begun(first, found, added) if added else None


def with_coloured_readings(fit: Fit, fitted: Fit) -> Fit | None:
    """Fit the model with coloured errors of just those readings that show them; None if it has these already.

    fit: the model; fitted: the same or a richer model, with all effects that are named, by which colour is told, since
    what a model lacks makes innovations alike too.
    """
    found = _with_suspects(_without_idle(fitted))
    wanted, present = _memories(found), _memories(fit)
    if set(wanted) == set(present):
        return None
    return settled(_begun(_without(fit, present), found, wanted), RECALIBRATION.most_rounds)


def _memories(fit: Fit) -> tuple[Unknown, ...]:
    return tuple(unknown for unknown in fit.noise if unknown.column in READING_MEMORY)


def _stream_of(column: str) -> str | None:
    """Name of the stream of which a column holds noise or memory; None for other columns."""
    return STREAM_OF.get(column.partition(".")[2]) if column.startswith(("reading.", "memory.")) else None


def _begun(fit: Fit, found: Fit, added: Sequence[Unknown]) -> Fit:
    """Add memories to a model, with the noise of readings that another one with the same and more noise has."""
    values = dict(zip(found.noise, found.q_noise.tolist(), strict=True))
    q_noise = [
        values[unknown] if unknown.column in READING_NOISE else q
        for unknown, q in zip(fit.noise, fit.q_noise.tolist(), strict=True)
    ]
    memories = [values[unknown] for unknown in added]
    return evaluated(replace(fit, noise=(*fit.noise, *added), q_noise=np.array([*q_noise, *memories])))


def _with_suspects(fit: Fit) -> Fit:
    """Add the memories that gain enough, one after the other."""
    for unknown in list(_suspects(fit)):
        trial = _coloured(fit, unknown)
        if trial.objective > fit.objective + COLOURED.worth:
            fit = trial
    return fit


def _without_idle(fit: Fit) -> Fit:
    """Take away the memories by which the model gains too little, one after the other."""
    for unknown in _memories(fit):
        less = with_noise(evaluated(_without(fit, [unknown])), COLOURED.rounds, (NOISE_OF[unknown.column],))
        if fit.objective - less.objective < COLOURED.worth:
            fit = less
    return fit


def _without(fit: Fit, memories: Sequence[Unknown]) -> Fit:
    """Leave memories out of a model, which is not evaluated."""
    kept = [unknown not in memories for unknown in fit.noise]
    noise = tuple(unknown for unknown, keep in zip(fit.noise, kept, strict=True) if keep)
    return replace(fit, noise=noise, q_noise=fit.q_noise[kept])


def _coloured(fit: Fit, memory: Unknown) -> Fit:
    """Add a memory to a model, and fit it together with the noise of its readings, everything else held."""
    begun = evaluated(replace(fit, noise=(*fit.noise, memory), q_noise=np.append(fit.q_noise, 0.0)))
    return with_noise(begun, COLOURED.rounds, (NOISE_OF[memory.column], memory.column))


def _suspects(fit: Fit) -> Iterator[Unknown]:
    """Memories of those numbers of noise whose innovations resemble the ones before, at the size that this gives."""
    fitted = {(unknown.column, number) for unknown in fit.noise for number in unknown.tracks}
    for robot, every in tracks_by_robot(fit.tracks).items():
        for column, memory in MEMORY_OF.items():
            numbers = tuple(number for number in every if (column, number) in fitted and (memory, number) not in fitted)
            likeness = _likeness(fit, numbers, column)
            if likeness is not None:
                yield _memory(robot, numbers, memory, *likeness)


def _likeness(fit: Fit, numbers: Sequence[int], column: str) -> tuple[float, float] | None:
    """Correlation of innovations with those before of the same kind, and mean gap between these [s]; None if little."""
    products, squares, gaps = [np.zeros(0)], [np.zeros(0)], [np.zeros(0)]
    kinds = [code for code, name in enumerate(READING_NOISE_OF_KIND) if f"reading.{name}" == column]
    for number in numbers:
        track, passed = fit.tracks[number], fit.passes[number]
        readings = track.filter.readings(fit.filled[number])
        scaled = np.where(passed.believed, passed.innovation / np.sqrt(passed.variance), np.nan)[readings.origin]
        scaled = _without_means(scaled, readings.kind)
        chosen = np.flatnonzero(np.isin(readings.kind, kinds) & (readings.before >= 0))
        now, before = scaled[chosen], scaled[readings.before[chosen]]
        both = np.isfinite(now) & np.isfinite(before)
        products.append(now[both] * before[both])
        squares.append(now[both] ** 2)
        gaps.append(readings.gap[chosen[both]])
    product, square, gap = (np.concatenate(each) for each in (products, squares, gaps))
    if len(product) < COLOURED.fewest or not square.any():
        return None
    correlation = float(product.mean() / square.mean())
    return (correlation, float(gap.mean())) if correlation > COLOURED.correlated else None


def _without_means(scaled: Floats, kind: Integers) -> Floats:
    """Take the mean of each kind off innovations (m,) with NaN: what is off by the same all the time has no memory."""
    found = scaled.copy()
    for code in np.unique(kind):
        chosen = kind == code
        if np.isfinite(scaled[chosen]).any():
            found[chosen] -= np.nanmean(scaled[chosen])
    return found


def _memory(robot: str, numbers: tuple[int, ...], column: str, correlation: float, gap: float) -> Unknown:
    """Make the memory of errors into an unknown around that of which innovations have this correlation over a gap."""
    owner = Owner(READING, (robot,), f"{column.partition('.')[2]}_memory", NOISE_UNITS[column])
    base = float(np.log(gap) - np.log(-np.log(min(correlation, 1.0 - 1e-6))))
    return Unknown(
        owner, column, numbers, base=base, prior=COLOURED.prior, bounds=(-COLOURED.farthest, COLOURED.farthest)
    )
