"""A model whose random force grows with speed or thrust, for recordings that show one which does.

The variance of the random force is that at rest times 1 + (growth share)^2, with the share of the highest speed or
thrust. What comes in anew at each step of the filter grows at once; what is there already fades as before.
Such noise explains errors that grow with speed, so that laws that act at speed have to explain more than these.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from cocorosim_ros.diagnosis.criteria.fitting import GROWING_FORCE, RECALIBRATION
from cocorosim_ros.diagnosis.fitting.climbing import settled, with_noise
from cocorosim_ros.diagnosis.fitting.fit import Fit, evaluated
from cocorosim_ros.diagnosis.fitting.unknowns import RANDOM_FORCE, Owner, Unknown
from cocorosim_ros.diagnosis.tracks.agitation import Agitation
from cocorosim_ros.diagnosis.tracks.by_robot import tracks_by_robot
from cocorosim_ros.diagnosis.tracks.columns import COLUMN, NOISE_UNITS, WATER_GROWTH, WATER_RANDOM
from cocorosim_ros.diagnosis.tracks.passes import Smoothed
from cocorosim_ros.diagnosis.tracks.track import Track
from cocorosim_ros.diagnosis.tracks.vehicle_size import full_forces
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.state.state import HEAVE, SURGE

GROWS_WITH = {column.rpartition("_")[2]: column for column in WATER_GROWTH}
"""Columns of the growth by quantity: speed, thrust."""
ALL = tuple(GROWS_WITH)
WAYS = (*((quantity,) for quantity in GROWS_WITH), ALL)


def speed_and_thrust(track: Track, course: Smoothed) -> Floats:
    """Speed [m/s] and thrust [N] (points, quantities) of a robot at the grid points of its smoothed course."""
    speed = np.linalg.norm(course.mean[:, SURGE : HEAVE + 1], axis=1)
    thrust = np.linalg.norm(track.actuation.nominal_force(), axis=1)
    return np.column_stack([speed, thrust])


def with_growing_force(fit: Fit, fitted: Fit, courses: Sequence[Smoothed]) -> Fit | None:
    """Fit the model with a random force that grows with speed, thrust or both; None if the recordings tell no growth.

    fit: the model; fitted: the same or a richer model, with all effects that are named, by which growth is told, since
    what a model lacks grows with speed too; courses: its smoothed courses, in the order of the tracks. Growth with a
    quantity has to be worth some nats, and a force that is next to nothing at its strongest is none. Where growth with
    both quantities gains next to nothing, growth with one of them is not tried: it is a case of the other.
    """
    tracks = _agitated(fitted.tracks, courses)
    richest = _begun(fitted, tracks, ALL)
    if richest.objective - fitted.objective < GROWING_FORCE.hopeful * len(tracks_by_robot(tracks)):
        return None
    ways = [richest if which is ALL else _begun(fitted, tracks, which) for which in WAYS]
    gains = [way.objective - fitted.objective - GROWING_FORCE.worth * _count(way, fitted) for way in ways]
    best = max(range(len(WAYS)), key=gains.__getitem__)
    if gains[best] <= 0.0 or not _is_felt(ways[best]):
        return None
    begun = ways[best] if fit is fitted else _begun(fit, tracks, WAYS[best])
    grown = settled(begun, RECALIBRATION.most_rounds)
    return grown if grown.objective - fit.objective > GROWING_FORCE.worth * _count(grown, fit) else None


def _begun(fit: Fit, tracks: tuple[Track, ...], quantities: Sequence[str]) -> Fit:
    """Let the random force of each robot grow with quantities, and fit the random forces, everything else held."""
    added = [_growth(robot, numbers, name) for robot, numbers in tracks_by_robot(tracks).items() for name in quantities]
    q_noise = np.append(fit.q_noise, np.zeros(len(added)))
    first = evaluated(replace(fit, tracks=tracks, noise=(*fit.noise, *added), q_noise=q_noise))
    return with_noise(first, GROWING_FORCE.rounds, WATER_RANDOM)


def _count(grown: Fit, fit: Fit) -> int:
    return len(grown.noise) - len(fit.noise)


def _is_felt(fit: Fit) -> bool:
    """Tell whether the random force of any track is more than a trace of the full force at its strongest."""
    filled = fit.filled
    growth = np.exp(filled[:, [COLUMN[column] for column in WATER_GROWTH]])
    rms = np.exp(filled[:, COLUMN["random.force"]]) * np.sqrt(1.0 + (growth**2).sum(axis=1))
    full = np.array([full_forces(track.vehicle).across for track in fit.tracks])
    return bool((rms > GROWING_FORCE.trace * full).any())


def _growth(robot: str, numbers: tuple[int, ...], quantity: str) -> Unknown:
    column = GROWS_WITH[quantity]
    owner = Owner(RANDOM_FORCE, (robot,), column.partition(".")[2], NOISE_UNITS[column])
    return Unknown(
        owner, column, numbers, base=float(np.log(GROWING_FORCE.usual)), prior=GROWING_FORCE.prior,
        bounds=(-GROWING_FORCE.farthest, GROWING_FORCE.farthest),
    )  # fmt: skip


def _agitated(tracks: Sequence[Track], courses: Sequence[Smoothed]) -> tuple[Track, ...]:
    """Copy tracks, each with the shares of speed and thrust along its smoothed course; both in one order.

    The highest speed and thrust are those of all recordings of a robot, but for the few moments above a quantile.
    """
    values = [speed_and_thrust(track, course) for track, course in zip(tracks, courses, strict=True)]
    highest = np.ones((len(tracks), len(GROWS_WITH)))
    for numbers in tracks_by_robot(tracks).values():
        top = np.quantile(np.concatenate([values[number] for number in numbers]), GROWING_FORCE.highest, axis=0)
        highest[list(numbers)] = np.where(top > 0.0, top, np.inf)
    return tuple(
        replace(track, filter=track.filter.agitated(Agitation(course.time, value / top)))
        for track, course, value, top in zip(tracks, courses, values, highest, strict=True)
    )
