"""The residual: the random force that a model needs over time, with its swings, its changes and typical sizes."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from scipy.ndimage import median_filter
from scipy.signal import find_peaks, periodogram

from cocorosim_ros.diagnosis.criteria.naming import SWINGS
from cocorosim_ros.diagnosis.foretelling.nameless_force import turn_back
from cocorosim_ros.diagnosis.tracks.passes import FORCE_X, FORCE_Y, FORCE_Z, YAW_MOMENT, Smoothed
from cocorosim_ros.diagnosis.tracks.surroundings import FAR
from cocorosim_ros.diagnosis.tracks.track import Track
from cocorosim_ros.diagnosis.tracks.vehicle_size import full_forces, slowness
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.state.state import YAW, X, Y, Z
from cocorosim_ros.world.terms.regressors import REGRESSORS, Extent
from cocorosim_ros.world.terms.search import Scene

FORCE_COLUMNS = {"world_x": FORCE_X, "world_y": FORCE_Y, "heave": FORCE_Z, "yaw": YAW_MOMENT}
LEVEL_EQUATIONS = ("world_x", "world_y")
WAVE_EQUATIONS = (*LEVEL_EQUATIONS, "heave")


class Spectrum(NamedTuple):
    """Power of a force by frequency [1/s], both (frequencies,)."""

    frequency: Floats
    power: Floats


class Band(NamedTuple):
    """Periods between which swings are looked for [s]."""

    shortest: float
    longest: float


def scene_of(tracks: Sequence[Track], courses: Sequence[Smoothed], drag_form: float = 0.0) -> Scene:
    """Describe what the recordings span, and how the residual force swings, for the grids of the catalogue.

    courses: the smoothed course of each track, in their order. drag_form: see Scene.
    """
    places = np.concatenate([course.mean[:, X : Z + 1] for course in courses])
    seen = np.concatenate([course.mean for course in courses])
    lower, upper = places.min(axis=0), np.maximum(places.max(axis=0), places.min(axis=0) + SWINGS.least_extent)
    duration = max(float(course.time[-1]) for course in courses)
    forces = [forces_by_equation(course.mean) for course in courses]
    slow = slowness(tracks[0].vehicle)
    spectra = {name: _spectrum(courses, [each[name] for each in forces]) for name in forces[0]}
    periods = {name: _periods(courses, spectrum, SWINGS.shortest_period) for name, spectrum in spectra.items()}
    of_current = [_periods(courses, spectra[name], slow * SWINGS.shortest_current) for name in LEVEL_EQUATIONS]
    periods["current"] = tuple(sorted({period for each in of_current for period in each}))
    periods["waves"] = _wave_periods(courses, [spectra[name] for name in WAVE_EQUATIONS])
    return Scene(
        tuple(lower.tolist()),
        tuple(upper.tolist()),
        duration,
        tracks[0].vehicle.hull,
        tracks[0].vehicle.arm,
        periods,
        tuple(moment for course in courses for moment in _changes(course.time, course.mean[:, FORCE_Z], slow)),
        _scales(tracks[0], seen, duration),
        _driven(tracks, seen),
        drag_form,
        tracks[0].vehicle.above_water,
        tracks[0].vehicle.height,
        tracks[0].vehicle.weight,
        tracks[0].vehicle.cable,
    )


def _driven(tracks: Sequence[Track], seen: Floats) -> bool:
    """Tell whether the thrust is greater than the random force in the horizontal plane, by root mean squares.

    seen (points, COURSE_SIZE): all smoothed courses, one after the other.
    """
    thrust = np.concatenate([track.actuation.nominal_force() for track in tracks])
    return bool(np.mean(thrust**2) > np.mean(seen[:, FORCE_X : FORCE_Y + 1] ** 2))


def forces_by_equation(mean: Floats) -> dict[str, Floats]:
    """Random force of a smoothed course (points, COURSE_SIZE) in each equation: (points,) [N, N m]."""
    in_body = turn_back(mean[:, FORCE_X : YAW_MOMENT + 1], mean[:, YAW])
    forces = {name: mean[:, column] for name, column in FORCE_COLUMNS.items()}
    return {**forces, "surge": in_body[:, X], "sway": in_body[:, Y]}


def _periods(courses: Sequence[Smoothed], spectrum: Spectrum, shortest: float) -> tuple[float, ...]:
    """Periods [s] at which a force swings most, strongest first, and last the longest that the recordings show.

    shortest: below which none is looked for [s].
    """
    shortest, longest = max(shortest, SWINGS.readings * _step(courses[0])), _longest(courses) / SWINGS.swings
    return (*_strongest(spectrum, Band(shortest, longest), SWINGS.most_periods), longest)


def _wave_periods(courses: Sequence[Smoothed], spectra: Sequence[Spectrum]) -> tuple[float, ...]:
    """Periods [s] at which waves may be: where the forces with these spectra together swing most.

    The peaks have to stand out, so that nothing is looked for where the water pushes at random alone.
    """
    power = np.sum([each.power for each in spectra], axis=0)
    around = median_filter(power, size=SWINGS.finer * SWINGS.wave_around, mode="nearest")
    shortest, longest = SWINGS.wave_periods
    shortest = max(shortest, SWINGS.readings * _step(courses[0]))
    band = Band(shortest, min(longest, _longest(courses) / SWINGS.swings))
    standing = np.where(power > SWINGS.wave_stands_out * around, power, 0.0)
    return _strongest(Spectrum(spectra[0].frequency, standing), band, SWINGS.most_waves)


def _longest(courses: Sequence[Smoothed]) -> float:
    return max(float(course.time[-1] - course.time[0]) for course in courses)


def _step(course: Smoothed) -> float:
    return float(course.time[1] - course.time[0])


def _spectrum(courses: Sequence[Smoothed], forces: Sequence[Floats]) -> Spectrum:
    """Add the spectra of a force over all courses; forces: one (points,) for each."""
    most = max(len(course.time) for course in courses)
    spectra = [
        Spectrum(*periodogram(force, fs=1.0 / _step(course), nfft=SWINGS.finer * most))
        for course, force in zip(courses, forces, strict=True)
    ]
    return Spectrum(spectra[0].frequency, np.sum([each.power for each in spectra], axis=0))


def _strongest(spectrum: Spectrum, band: Band, most: int) -> tuple[float, ...]:
    """Periods [s] of the strongest peaks in a band, strongest first."""
    frequency, power = spectrum
    wanted = (frequency > 1.0 / band.longest) & (frequency < 1.0 / band.shortest)
    peaks, _ = find_peaks(np.where(wanted, power, 0.0))
    strongest = peaks[np.argsort(power[peaks])[::-1][:most]]
    return tuple((1.0 / frequency[strongest]).tolist())


def _changes(time: Floats, force: Floats, slow: float) -> list[float]:
    """Moments [s] at which the mean of a force (points,) changes most, by the means just before and just after.

    slow: the slowness of the vehicle.
    """
    width = round(slow * SWINGS.steady / float(time[1] - time[0]))
    if len(time) < 2 * width + 1:
        return []
    total = np.concatenate([[0.0], np.cumsum(force)])
    middle = np.arange(width, len(time) - width)
    change = np.abs(total[middle + width] - 2.0 * total[middle] + total[middle - width]) / width
    peaks, _ = find_peaks(change, distance=width)
    strongest = peaks[np.argsort(change[peaks])[::-1][: SWINGS.most_changes]]
    return [float(time[middle[peak]]) for peak in strongest]


def _scales(track: Track, seen: Floats, duration: float) -> dict[str, float]:
    """Typical sizes by name, SI units: regressors in these recordings, full forces by equation, the mass.

    seen (points, COURSE_SIZE): all smoothed courses, one after the other.
    """
    vehicle = track.vehicle
    extent = Extent(
        np.sqrt(np.mean(seen**2, axis=0)),
        duration,
        np.maximum(vehicle.force_scale, SWINGS.least_force),
        bool(vehicle.surroundings.upper[0] < FAR),
    )
    full = full_forces(vehicle)
    return {
        **{regressor.name: regressor.typical(extent) for regressor in REGRESSORS},
        "surge_force": full.across, "heave_force": full.random_heave, "yaw_force": full.yaw,
        "mass": track.vehicle.mass,
    }  # fmt: skip
