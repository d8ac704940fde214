"""A model whose readings have coloured errors, for recordings that show such.

Errors of an instrument may last for longer than it takes to the next reading, as those of a tracker or of a compass
beside iron do. Taken as white they count as often as there are readings, and slow errors of a reading become evidence
of what acts slowly. Such errors are first-order processes here (`filter.coloured`), with a memory for each number of
noise.

Places of a satellite receiver err otherwise: little from reading to reading, and by far more over a minute. No single
memory has both. So the place itself wanders in the filter, as a random walk, beside white errors: what readings show is
then the place of the vehicle as the instrument has it, which moves alike. Of a wander that stays bounded a walk holds
all but the bound.
Source: Bar-Shalom, Li and Kirubarajan, Estimation with Applications to Tracking and Navigation (2001), section 6.2.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace

import numpy as np

from cocorosim_ros.diagnosis.criteria.fitting import COLOURED, RECALIBRATION
from cocorosim_ros.diagnosis.filter.layout import KINDS_OF_STREAM
from cocorosim_ros.diagnosis.filter.records import Readings
from cocorosim_ros.diagnosis.fitting.climbing import settled, with_noise
from cocorosim_ros.diagnosis.fitting.fit import Fit, evaluated
from cocorosim_ros.diagnosis.fitting.unknowns import RANDOM_FORCE, READING, Owner, Unknown
from cocorosim_ros.diagnosis.tracks.by_robot import tracks_by_robot
from cocorosim_ros.diagnosis.tracks.columns import (
    COLUMN,
    NOISE_UNITS,
    READING_MEMORY,
    READING_NOISE,
    READING_NOISE_OF_KIND,
    WANDER,
)
from cocorosim_ros.diagnosis.tracks.vehicle_size import full_forces
from cocorosim_ros.foundation.arrays import Floats, Integers

MEMORY_OF = dict(zip(READING_NOISE, READING_MEMORY, strict=True))
PLACES = "reading.pose_xy"
NOISE_OF = {**dict(zip(READING_MEMORY, READING_NOISE, strict=True)), WANDER: PLACES}
STREAM_OF = {READING_NOISE_OF_KIND[kind]: stream for stream, kinds in KINDS_OF_STREAM.items() for kind in kinds}
"""Stream of a number of noise, by its name without what stands before the point."""


def with_obvious_colour(first: Fit, roughly: Fit) -> Fit | None:
    """Add lasting errors of all instruments to a first guess where a rough fit shows them of most; else None.

    What a model lacks makes the innovations of some instruments resemble the ones before, but hardly those of most of
    them, each by itself. With white errors such recordings take minutes to fit, and much is named for nothing. The
    random force has then followed the errors of the others, so that all instruments of the robot begin anew, with one
    memory and with the noise that differences of such errors show.
    """
    found = _with_suspects(roughly)
    added = found.noise[len(roughly.noise) :]
    begun = first
    for numbers in tracks_by_robot(first.tracks).values():
        shown = [unknown for unknown in added if set(unknown.tracks) <= set(numbers)]
        concerned = {number for unknown in shown for number in unknown.tracks}
        seen = [unknown for unknown in first.noise if not concerned.isdisjoint(unknown.tracks)]
        if len(_streams(shown)) >= max(COLOURED.instruments, COLOURED.most * len(_streams(seen))):
            begun = _all_coloured(begun, tuple(sorted(concerned)), float(np.median([each.base for each in shown])))
    return evaluated(begun) if begun is not first else None


def with_quick_colour(first: Fit, white: Fit) -> Fit | None:
    """Add errors that last for a few readings to a first guess where white ones need incredible water; else None.

    A tracker whose readings are held until the next one, or come with stamps that jitter, errs alike for some readings
    in a row. With white errors the water has to shake the robot by as much, far harder than its own actuators could. So
    lasting errors are tried for few instruments too, although slow ones could not be told from slow motion there, and
    with water that is no stronger than the actuators; the likelihood decides. white: the fit from that first guess.
    """
    begun = first
    for numbers in tracks_by_robot(first.tracks).values():
        if not memories_of(first) and _is_shaken(white, numbers):
            erring = [column for column in MEMORY_OF if not _is_exact(white, numbers, column)]
            gaps = [gap for column in erring if (gap := _mean_gap(white, numbers, column)) is not None]
            if gaps:
                begun = _all_coloured(_unshaken(begun, numbers), numbers, math.log(COLOURED.quick * min(gaps)), erring)
    return evaluated(begun) if begun is not first else None


def _strongest(fit: Fit, numbers: Sequence[int]) -> dict[str, float]:
    """Logarithm of what all actuators of a robot deliver at their limits, by column of the random force."""
    full = full_forces(fit.tracks[numbers[0]].vehicle)
    return {"random.force": math.log(full.across), "random.moment": math.log(full.yaw)}


def _is_shaken(fit: Fit, numbers: Sequence[int]) -> bool:
    """Tell whether the random force on a robot is incredible beside all its actuators at their limits."""
    row, beyond = fit.filled[numbers[0]], math.log(COLOURED.shaken)
    return any(row[COLUMN[column]] > most + beyond for column, most in _strongest(fit, numbers).items())


def _unshaken(fit: Fit, numbers: Sequence[int]) -> Fit:
    """Bound the random force on a robot by all its actuators at their limits; the fit is not evaluated."""
    strongest = _strongest(fit, numbers)
    noise = tuple(
        replace(each, bounds=(each.bounds[0], max(strongest[each.column] - each.base, each.bounds[0])))
        if each.column in strongest and set(each.tracks) <= set(numbers)
        else each
        for each in fit.noise
    )
    return replace(fit, noise=noise)


def _is_exact(fit: Fit, numbers: Sequence[int], column: str) -> bool:
    """Tell whether all readings of a column are as exact as any can be, as those of a number that was put in."""
    chosen = [
        unknown.at_ends(q)[0]
        for unknown, q in zip(fit.noise, fit.q_noise.tolist(), strict=True)
        if unknown.column == column and not set(numbers).isdisjoint(unknown.tracks)
    ]
    return all(chosen)


def _streams(noise: Sequence[Unknown]) -> set[str]:
    """Streams of the readings of which numbers are noise or memory."""
    names = [unknown.column.partition(".")[2] for unknown in noise if unknown.owner.effect == READING]
    return {STREAM_OF[name] for name in names}


def _are_enough(fit: Fit, robot: str) -> bool:
    """Tell whether a robot has so many instruments that lasting errors of one can be told from its motion."""
    return len(_streams([each for each in fit.noise if robot in each.owner.robots])) >= COLOURED.instruments


def _all_coloured(fit: Fit, numbers: tuple[int, ...], log_memory: float, columns: Iterable[str] = MEMORY_OF) -> Fit:
    """Add memories, all alike at first, of all readings of one robot in some tracks; the fit is not evaluated.

    columns: numbers of noise of these readings; all if left out.
    """
    robot, q_noise, added = fit.tracks[numbers[0]].name, fit.q_noise.copy(), []
    for column in columns:
        memory, gap = MEMORY_OF[column], _mean_gap(fit, numbers, column)
        if gap is None:
            continue
        added.append(_memory(robot, numbers, memory, log_memory))
        white = -np.expm1(-2.0 * gap / np.exp(log_memory))  # share of the variance that differences show
        for place, unknown in enumerate(fit.noise):
            if unknown.column == column and not set(numbers).isdisjoint(unknown.tracks):
                q_noise[place] = unknown.clipped(float(q_noise[place] - 0.5 * np.log(white)))
    return replace(fit, noise=(*fit.noise, *added), q_noise=np.append(q_noise, np.zeros(len(added))))


def with_coloured_readings(fit: Fit, fitted: Fit) -> Fit | None:
    """Fit the model with coloured errors of just those readings that show them; None if it has these already.

    fit: the model; fitted: the same or a richer model, with all effects that are named, by which colour is told, since
    what a model lacks makes innovations alike too.
    """
    found = _with_wandering_places(_with_suspects(_without_idle(fitted)))
    wanted, present = colours_of(found), colours_of(fit)
    if set(wanted) == set(present):
        return None
    return settled(_begun(_without(fit, present), found, wanted), RECALIBRATION.most_rounds)


def robots_of(colours: Iterable[Unknown]) -> frozenset[str]:
    """Names of the robots that have these errors."""
    return frozenset(name for unknown in colours for name in unknown.owner.robots)


def colours_of(fit: Fit) -> tuple[Unknown, ...]:
    """Memories of errors, and how far places wander, among the noise of a model."""
    return tuple(unknown for unknown in fit.noise if unknown.column in NOISE_OF)


def memories_of(fit: Fit) -> tuple[Unknown, ...]:
    """Memories of errors among the noise of a model."""
    return tuple(unknown for unknown in fit.noise if unknown.column in READING_MEMORY)


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


def _with_wandering_places(fit: Fit) -> Fit:
    """Let places wander instead of having errors with a memory, where the model gains enough by it.

    As slow errors, a wander cannot be told from slow motion where no other instruments show the motion.
    """
    for memory in memories_of(fit):
        if NOISE_OF[memory.column] == PLACES and _are_enough(fit, memory.owner.robots[0]):
            trial = _coloured(_exact_again(_without(fit, [memory]), memory), _wander(fit, memory), COLOURED.walk_rounds)
            if trial.objective > fit.objective + COLOURED.worth:
                fit = trial
    return fit


def _without_idle(fit: Fit) -> Fit:
    """Take away the memories by which the model gains too little, one after the other."""
    for unknown in colours_of(fit):
        less = with_noise(evaluated(_without(fit, [unknown])), COLOURED.rounds, (NOISE_OF[unknown.column],))
        if fit.objective - less.objective < COLOURED.worth:
            fit = less
    return fit


def _without(fit: Fit, memories: Sequence[Unknown]) -> Fit:
    """Leave memories out of a model, which is not evaluated."""
    kept = [unknown not in memories for unknown in fit.noise]
    noise = tuple(unknown for unknown, keep in zip(fit.noise, kept, strict=True) if keep)
    return replace(fit, noise=noise, q_noise=fit.q_noise[kept])


def _exact_again(fit: Fit, memory: Unknown) -> Fit:
    """Put the noise of the readings of a memory back to the first guess, which differences of neighbours show."""
    q_noise = [
        0.0 if unknown.column == NOISE_OF[memory.column] and not set(unknown.tracks).isdisjoint(memory.tracks) else q
        for unknown, q in zip(fit.noise, fit.q_noise.tolist(), strict=True)
    ]
    return replace(fit, q_noise=np.array(q_noise))


def _coloured(fit: Fit, memory: Unknown, rounds: int = COLOURED.rounds) -> Fit:
    """Add a memory to a model, and fit it together with the noise of its readings, everything else held."""
    begun = evaluated(replace(fit, noise=(*fit.noise, memory), q_noise=np.append(fit.q_noise, 0.0)))
    return with_noise(begun, rounds, (NOISE_OF[memory.column], memory.column))


def _wander(fit: Fit, memory: Unknown) -> Unknown:
    """Make the wander of places into an unknown, around the walk that errors with a memory are over short times."""
    row = fit.filled[memory.tracks[0]]
    owner = replace(memory.owner, effect=RANDOM_FORCE, parameter="place", unit=NOISE_UNITS[WANDER])
    step = float(row[COLUMN[PLACES]] + 0.5 * (math.log(2.0) - row[COLUMN[memory.column]]))
    return replace(memory, owner=owner, column=WANDER, base=step)


def _suspects(fit: Fit) -> Iterator[Unknown]:
    """Memories of those numbers of noise whose innovations resemble the ones before, at the size that this gives.

    Slow errors of few instruments cannot be told from slow motion, since no others show the motion without them.
    """
    fitted = {(unknown.column, number) for unknown in fit.noise for number in unknown.tracks}
    for robot, every in tracks_by_robot(fit.tracks).items():
        if not _are_enough(fit, robot):
            continue
        for column, memory in MEMORY_OF.items():
            kept = {memory, WANDER} if column == PLACES else {memory}
            numbers = tuple(n for n in every if (column, n) in fitted and not {(each, n) for each in kept} & fitted)
            likeness = _likeness(fit, numbers, column)
            if likeness is not None:
                yield _memory(robot, numbers, memory, _memory_of(*likeness))


def _likeness(fit: Fit, numbers: Sequence[int], column: str) -> tuple[float, float] | None:
    """Correlation of innovations with those before of the same kind, and mean gap between these [s]; None if little.

    Exact readings, of which the filter expects more noise than they have, err by its steps, which are alike.
    """
    products, squares = [np.zeros(0)], [np.zeros(0)]
    for number in numbers:
        passed, readings = fit.passes[number], _readings(fit, number)
        scaled = np.where(passed.believed, passed.innovation / np.sqrt(passed.variance), np.nan)[readings.origin]
        scaled = _without_means(scaled, readings.kind, _kinds_of(column))
        chosen = _with_one_before(readings, column)
        now, before = scaled[chosen], scaled[readings.before[chosen]]
        both = np.isfinite(now) & np.isfinite(before)
        products.append(now[both] * before[both])
        squares.append(now[both] ** 2)
    product, square = np.concatenate(products), np.concatenate(squares)
    gap = _mean_gap(fit, numbers, column)
    if gap is None or len(product) < COLOURED.fewest or square.mean() < COLOURED.material:
        return None
    correlation = float(product.mean() / square.mean())
    return (correlation, gap) if correlation > COLOURED.correlated else None


def _mean_gap(fit: Fit, numbers: Sequence[int], column: str) -> float | None:
    """Mean gap [s] between readings that have one before of the same kind; None where these are few."""
    found = [np.zeros(0)]
    for number in numbers:
        readings = _readings(fit, number)
        found.append(readings.gap[_with_one_before(readings, column)])
    gaps = np.concatenate(found)
    return float(gaps.mean()) if len(gaps) >= COLOURED.fewest else None


def _readings(fit: Fit, number: int) -> Readings:
    return fit.tracks[number].timeline.under(fit.filled[number])


def _with_one_before(readings: Readings, column: str) -> Integers:
    """Places of the readings of a column's kinds that have one before of the same kind."""
    return np.flatnonzero(np.isin(readings.kind, _kinds_of(column)) & (readings.before >= 0))


def _kinds_of(column: str) -> list[int]:
    """Codes of the kinds of readings that share a number of noise."""
    return [code for code, name in enumerate(READING_NOISE_OF_KIND) if f"reading.{name}" == column]


def _without_means(scaled: Floats, kind: Integers, kinds: Sequence[int]) -> Floats:
    """Take the means of some kinds off innovations (m,) with NaN: what is off by a constant has no memory."""
    found = scaled.copy()
    for code in kinds:
        chosen = kind == code
        if np.isfinite(scaled[chosen]).any():
            found[chosen] -= np.nanmean(scaled[chosen])
    return found


def _memory(robot: str, numbers: tuple[int, ...], column: str, log_memory: float) -> Unknown:
    """Make the memory of errors into an unknown around exp(log_memory) [s]."""
    owner = Owner(READING, (robot,), f"{column.partition('.')[2]}_memory", NOISE_UNITS[column])
    ends = (-COLOURED.farthest, COLOURED.farthest)
    return Unknown(owner, column, numbers, base=log_memory, prior=COLOURED.prior, bounds=ends)


def _memory_of(correlation: float, gap: float) -> float:
    """Logarithm of the memory [s] of errors that have this correlation over a gap [s]."""
    return float(np.log(gap) - np.log(-np.log(min(correlation, COLOURED.most_correlated))))
