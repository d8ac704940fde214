"""Where the recalibrated model and the recordings differ: which equation, in proportion to what, when and where."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from cocorosim_ros.diagnosis.catalogue.entry import SENSOR_CHANNELS
from cocorosim_ros.diagnosis.criteria.catalogue import CATALOGUE
from cocorosim_ros.diagnosis.criteria.showing import LOCATION
from cocorosim_ros.diagnosis.findings import Located
from cocorosim_ros.diagnosis.fitting.fit import Fit, slopes
from cocorosim_ros.diagnosis.fitting.screening import Screened
from cocorosim_ros.diagnosis.naming.residual import scene_of
from cocorosim_ros.diagnosis.tracks.track import Smoothed
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.effects import LAWS


def locate(
    fit: Fit, screened: Sequence[Screened], laws: Sequence[Screened], courses: Sequence[Smoothed]
) -> tuple[Located, ...]:
    """What stands out, the clearest first: laws of force by the scan, sensors by the catalogue."""
    sensed = [part for part in screened if part.candidate.entry.channel in SENSOR_CHANNELS]
    standing = [part for part in (*laws, *sensed) if np.abs(part.z).max() >= LOCATION.clear and part.nats > 0.0]
    standing.sort(key=lambda part: -part.nats)
    found: list[Located] = []
    for part in standing:
        equation, regressor = _named(part)
        if len(found) < LOCATION.most and not any(
            equation == other.equation and regressor == other.regressor for other in found
        ):
            found.append(_located(fit, part, courses))
    return tuple(found)


def _named(part: Screened) -> tuple[str, str]:
    entry = part.candidate.entry
    if entry.law is not None:
        equation, _, regressor = entry.id.removeprefix("unknown:").replace("velocity~", "pose~").partition("~")
        return ("surge" if equation.startswith("world") else equation), (
            f"{regressor} ({equation})" if equation.startswith("world") else regressor
        )
    strongest = int(np.abs(part.z).argmax()) % len(entry.amplitudes)
    return (
        "clock" if entry.id == "clock_skew" else entry.channel if entry.channel != "velocity" else "pose"
    ), entry.amplitudes[strongest].name


def _located(fit: Fit, part: Screened, courses: Sequence[Smoothed]) -> Located:
    entry = part.candidate.entry
    equation, regressor = _named(part)
    time, gained = _gain_over_time(fit, part)
    first, last = _window(time, gained)
    if entry.law in LAWS:
        name = entry.id.removeprefix("unknown:").partition("~")[0]
        scales = scene_of(fit.tracks, courses).scales
        force = scales[{"heave": "heave_force", "yaw": "yaw_force"}.get(name, "surge_force")]
        size, unit = float(abs(part.q[0])) * CATALOGUE.large_share * force, "N m" if name == "yaw" else "N"
    else:
        strongest = int(np.abs(part.z).argmax())
        amplitude = entry.amplitudes[strongest % len(entry.amplitudes)]
        size, unit = float(abs(part.q[strongest])) * part.candidate.large(amplitude), amplitude.unit
    words = _where(part, time, gained, courses)
    return Located(
        part.candidate.robots, equation, regressor, words, (first, last), size, unit, float(np.abs(part.z).max())
    )


def _gain_over_time(fit: Fit, part: Screened) -> tuple[Floats, Floats]:
    """Moments [s] and the nats that the readings there gain by the law."""
    rows = part.candidate.write(fit.rows, part.values)
    unknowns = part.candidate.amplitudes()
    moved = slopes(replace(fit, rows=rows), unknowns, np.zeros(len(unknowns)))
    times, nats = [], []
    for number in part.candidate.everybody:
        passed, track = fit.passes[number], fit.tracks[number]
        shift = moved[number] @ part.q
        times.append(track.readings.stamp)
        nats.append(-(passed.innovation * shift + 0.5 * shift**2) / passed.variance)
    time, gained = np.concatenate(times), np.concatenate(nats)
    order = np.argsort(time, kind="stable")
    return time[order], gained[order]


def _window(time: Floats, gained: Floats) -> tuple[float, float]:
    """From when to when the middle 90 % of the gain came [s]."""
    bins = np.linspace(time[0], time[-1] + 1e-9, 31)
    index = np.digitize(time, bins) - 1
    total = np.maximum(np.bincount(index, gained, minlength=30)[:30], 0.0)
    share = np.cumsum(total) / max(float(total.sum()), 1e-300)
    first, last = int(np.searchsorted(share, 0.05)), int(np.searchsorted(share, 0.95))
    return float(bins[first]), float(bins[min(last + 1, 30)])


def _where(part: Screened, time: Floats, gained: Floats, courses: Sequence[Smoothed]) -> str:
    """In words: in which regime the gain is at home more than time is."""
    course = courses[part.candidate.everybody[0]]
    index = np.clip(np.searchsorted(course.time, time), 0, len(course.time) - 1)
    state = course.mean[index]
    regimes = {
        "mostly when turning": np.abs(state[:, 7]) > np.median(np.abs(course.mean[:, 7])),
        "mostly when turning slowly or not": np.abs(state[:, 7]) <= np.median(np.abs(course.mean[:, 7])),
        "mostly at speed": np.abs(state[:, 4]) > np.median(np.abs(course.mean[:, 4])),
        "mostly when slow": np.abs(state[:, 4]) <= np.median(np.abs(course.mean[:, 4])),
        "mostly when deep": state[:, 2] < np.median(course.mean[:, 2]),
        "mostly when shallow": state[:, 2] >= np.median(course.mean[:, 2]),
        "mostly when diving or rising": np.abs(state[:, 6]) > np.median(np.abs(course.mean[:, 6])),
        "mostly in the eastern half": state[:, 0] > np.median(course.mean[:, 0]),
        "mostly in the western half": state[:, 0] <= np.median(course.mean[:, 0]),
        "mostly in the northern half": state[:, 1] > np.median(course.mean[:, 1]),
        "mostly in the southern half": state[:, 1] <= np.median(course.mean[:, 1]),
    }
    total = float(gained.sum())
    if total <= 0.0:
        return "throughout"
    shares = {
        words: float(gained[chosen].sum()) / total
        for words, chosen in regimes.items()
        if chosen.mean() < LOCATION.everywhere  # as where a vehicle has one depth alone
    }
    words, share = max(shares.items(), key=lambda entry: entry[1], default=("", 0.0))
    return f"{words} ({min(share, 1.0):.0%} of the evidence)" if share > LOCATION.concentrated else "throughout"
