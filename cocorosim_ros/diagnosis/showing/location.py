"""Location of what the recalibrated model lacks: equation, regressor, time, and part of the course."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from cocorosim_ros.diagnosis.catalogue.entry import SENSOR_CHANNELS
from cocorosim_ros.diagnosis.criteria.catalogue import CATALOGUE
from cocorosim_ros.diagnosis.criteria.showing import LOCATION
from cocorosim_ros.diagnosis.evidence.streams.stream_columns import VELOCITIES
from cocorosim_ros.diagnosis.findings import Concentration, Located, Regime
from cocorosim_ros.diagnosis.fitting.fit import Fit, slopes
from cocorosim_ros.diagnosis.fitting.screening import Screened
from cocorosim_ros.diagnosis.fitting.unknowns import Unknown
from cocorosim_ros.diagnosis.naming.residual import scene_of
from cocorosim_ros.diagnosis.tracks.columns import COLUMN
from cocorosim_ros.diagnosis.tracks.passes import Smoothed
from cocorosim_ros.foundation.arrays import Flags, Floats
from cocorosim_ros.world.effects import LAWS
from cocorosim_ros.world.laws.law import Law
from cocorosim_ros.world.state.state import HEAVE, SURGE, YAW_RATE, X, Y, Z
from cocorosim_ros.world.terms.equations import EQUATION


def locate(
    fit: Fit, screened: Sequence[Screened], laws: Sequence[Screened], courses: Sequence[Smoothed]
) -> tuple[Located, ...]:
    """Locate the clearest differences between the recalibrated model and the recordings, the clearest first.

    fit: the recalibrated one; screened, laws: the first screening; courses: the smoothed course of each track. Forces
    are located by laws outside the catalogue, sensors by entries of the catalogue.
    """
    sensed = [each for each in screened if each.candidate.entry.channel in SENSOR_CHANNELS]
    standing = [each for each in (*laws, *sensed) if np.abs(each.z).max() >= LOCATION.clear and each.nats > 0.0]
    standing.sort(key=lambda each: -each.nats)
    found: list[Located] = []
    for each in standing:
        equation, regressor = _named(each)
        if len(found) < LOCATION.most and not any(
            equation == other.equation and regressor == other.regressor for other in found
        ):
            found.append(_located(fit, each, courses))
    return tuple(found)


def _strongest(screened: Screened) -> tuple[Unknown, float]:
    """Amplitude with the greatest score over its standard deviation, and the amount of its q."""
    number = int(np.abs(screened.z).argmax())
    return screened.candidate.amplitudes()[number], float(abs(screened.q[number]))


def _named(screened: Screened) -> tuple[str, str]:
    """Equation and regressor of a screened candidate, by the contract."""
    entry = screened.candidate.entry
    if entry.form is not None:
        return _law_named(entry.form)
    equation = "clock" if entry.id == "clock_skew" else entry.channel if entry.channel not in VELOCITIES else "pose"
    return equation, _strongest(screened)[0].owner.parameter


def _law_named(law: Law) -> tuple[str, str]:
    """Equation and regressor of a law, by the contract.

    The contract has no equations along the axes of the world, which become 'surge', and no velocities, which become
    'pose'.
    """
    if law.topic is not None:
        return "pose" if law.topic in VELOCITIES else law.topic, law.product.text
    if law.of.startswith("world"):
        return "surge", f"{law.product.text} ({law.of})"
    return law.of, law.product.text


def _located(fit: Fit, screened: Screened, courses: Sequence[Smoothed]) -> Located:
    """Describe where one screened candidate acts, and how strongly.

    The size of a law of motion is the force or moment that it typically has, else that of the strongest amplitude.
    """
    entry = screened.candidate.entry
    equation, regressor = _named(screened)
    time, gained = _gain_over_time(fit, screened)
    first, last = _window(time, gained)
    if entry.form is not None and entry.law in LAWS:
        name = entry.form.of
        scales = scene_of(fit.tracks, courses).scales
        force = scales[{"heave": "heave_force", "yaw": "yaw_force"}.get(name, "surge_force")]
        size, unit = float(abs(screened.q[0])) * CATALOGUE.large_share * force, EQUATION[name].unit
    else:
        unknown, q = _strongest(screened)
        size, unit = q * unknown.scale, unknown.owner.unit
    where, z = _where(screened, time, gained, courses), float(np.abs(screened.z).max())
    return Located(
        screened.candidate.robots, equation, regressor, where, (first, last), size, unit, z,
        entry.form, _swing(fit, screened),
    )  # fmt: skip


def _swing(fit: Fit, screened: Screened) -> tuple[float, float]:
    """Rate [rad/s] and phase [rad] with which a law of motion swings in time; 0, 0 if it does not."""
    place = screened.candidate.entry.law
    if place not in LAWS:
        return 0.0, 0.0
    row = screened.candidate.write(fit.rows, screened.values)[screened.candidate.everybody[0]]
    return float(row[COLUMN[f"{place}.omega"]]), float(row[COLUMN[f"{place}.phase"]])


def _gain_over_time(fit: Fit, screened: Screened) -> tuple[Floats, Floats]:
    """Stamps [s] of all readings, in order, and the nats that each gains by the candidate: both (m,)."""
    rows = screened.candidate.write(fit.rows, screened.values)
    unknowns = screened.candidate.amplitudes()
    moved = slopes(replace(fit, rows=rows), unknowns, np.zeros(len(unknowns)))
    times, nats = [], []
    for number in screened.candidate.everybody:
        passed, track = fit.passes[number], fit.tracks[number]
        shift = moved[number] @ screened.q
        times.append(track.timeline.stamp)
        nats.append(-(passed.innovation * shift + 0.5 * shift**2) / passed.variance)
    time, gained = np.concatenate(times), np.concatenate(nats)
    order = np.argsort(time, kind="stable")
    return time[order], gained[order]


def _window(time: Floats, gained: Floats) -> tuple[float, float]:
    """Begin and end [s] of the time in which the middle 90 % of the gain came, in thirtieths of the recording."""
    bins = np.linspace(time[0], time[-1] + 1e-9, 31)
    index = np.digitize(time, bins) - 1
    total = np.maximum(np.bincount(index, gained, minlength=30)[:30], 0.0)
    share = np.cumsum(total) / max(float(total.sum()), 1e-300)
    first, last = int(np.searchsorted(share, 0.05)), int(np.searchsorted(share, 0.95))
    return float(bins[first]), float(bins[min(last + 1, 30)])


def _regimes(course: Smoothed, state: Floats) -> dict[Regime, Flags]:
    """Flags (n,) by regime: the states (n, COURSE_SIZE) that lie in it, compared with the medians of the course."""
    middle = np.median(course.mean, axis=0)
    pace, size = np.median(np.abs(course.mean), axis=0), np.abs(state)
    return {
        "turning": size[:, YAW_RATE] > pace[YAW_RATE],
        "straight": size[:, YAW_RATE] <= pace[YAW_RATE],
        "fast": size[:, SURGE] > pace[SURGE],
        "slow": size[:, SURGE] <= pace[SURGE],
        "deep": state[:, Z] < middle[Z],
        "shallow": state[:, Z] >= middle[Z],
        "climbing": size[:, HEAVE] > pace[HEAVE],
        "east": state[:, X] > middle[X],
        "west": state[:, X] <= middle[X],
        "north": state[:, Y] > middle[Y],
        "south": state[:, Y] <= middle[Y],
    }


def _where(screened: Screened, time: Floats, gained: Floats, courses: Sequence[Smoothed]) -> Concentration | None:
    """Regime with the greatest share of the gain; None if even that share is not large.

    time [s], gained [nats]: both (m,), by reading. Regimes that fill nearly all of the time are left out.
    """
    course = courses[screened.candidate.everybody[0]]
    index = np.clip(np.searchsorted(course.time, time), 0, len(course.time) - 1)
    total = float(gained.sum())
    if total <= 0.0:
        return None
    shares = [
        Concentration(regime, float(gained[chosen].sum()) / total)
        for regime, chosen in _regimes(course, course.mean[index]).items()
        if chosen.mean() < LOCATION.everywhere  # a vehicle that keeps one depth is 'shallow' all the time
    ]
    best = max(shares, key=lambda each: each.share, default=None)
    return best if best is not None and best.share > LOCATION.concentrated else None
