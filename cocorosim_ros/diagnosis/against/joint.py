"""Joint fits: the vehicle's numbers shared by the recordings of when it was well and those to be judged."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from cocorosim_ros.diagnosis.evidence.streams.log import Evidence
from cocorosim_ros.diagnosis.fitting.base_model import base_rows, noise_unknowns
from cocorosim_ros.diagnosis.fitting.fit import Fit, covariance, evaluated
from cocorosim_ros.diagnosis.fitting.recalibration import climbed
from cocorosim_ros.diagnosis.fitting.unknowns import Z95, Unknown, write_values
from cocorosim_ros.diagnosis.tracks.columns import COLUMN, OF_TIME, READING_NOISE, WATER_NOISE
from cocorosim_ros.diagnosis.tracks.make_tracks import make_tracks
from cocorosim_ros.diagnosis.tracks.track import Track
from cocorosim_ros.foundation.arrays import Floats

NOISE_COLUMNS = [COLUMN[name] for name in (*WATER_NOISE, *READING_NOISE)]


def joint_fit(learned: Fit, bad: Evidence) -> Fit:
    """Fit the learned vehicle to its own tracks and to those of `bad`, which follow; noise is each side's own.

    Delays stay within what the learned vehicle's own recordings leave open: their likelihood is so rough that a stream
    which comes later in `bad` would draw them to a place between both, from which no slope leads back. The steps of the
    filter are those of the learned vehicle, since other steps average other readings.
    """
    known = below(learned)
    mine, first = judged_alone(learned, bad, known), len(learned.tracks)
    unknowns = tuple(_extended(unknown, mine.tracks, first) for unknown in _with_kept_delays(learned))
    return climbed(
        evaluated(
            Fit(
                (*learned.tracks, *mine.tracks),
                np.concatenate([known, mine.rows]),
                unknowns,
                (*learned.noise, *(_shifted(unknown, first) for unknown in mine.noise)),
                learned.q,
                np.concatenate([learned.q_noise, mine.q_noise]),
                (),
            )
        )
    )


def judged_alone(learned: Fit, bad: Evidence, known: Floats) -> Fit:
    """Make the tracks of `bad` with numbers `known` (tracks of the learned vehicle, columns), noise their own.

    It is not evaluated. Noise begins with that of the learned vehicle's water, and for readings with what these show.
    """
    step = min(track.timeline.grid.step for track in learned.tracks)
    tracks = make_tracks(replace(bad, platform=replace(bad.platform, fitted_step=step)))
    names = [track.name for track in learned.tracks]
    of_names = np.array([known[names.index(track.name)] for track in tracks])
    rows = of_names.copy()
    rows[:, NOISE_COLUMNS] = base_rows(tracks)[:, NOISE_COLUMNS]
    noise = noise_unknowns(tracks, rows)
    water = [_as_learned(unknown, of_names) for unknown in noise]
    return Fit(tracks, rows, (), tuple(noise), np.zeros(0), np.array(water), ())


def below(fit: Fit) -> Floats:
    """Rows (tracks, columns) of a fit with all fitted values written in but those on top of others."""
    places = [place for place, unknown in enumerate(fit.unknowns) if not unknown.on_top]
    written = write_values(fit.rows, [fit.unknowns[place] for place in places], fit.q[places])
    return write_values(written, fit.noise, fit.q_noise)


def part_of(fit: Fit, numbers: Sequence[int], kept: Sequence[Unknown]) -> Fit:
    """Take some tracks out of a fit, with the unknowns `kept` and the noise; all other numbers stay as fitted."""
    place_of = {number: place for place, number in enumerate(numbers)}
    others = [place for place, unknown in enumerate(fit.unknowns) if unknown not in kept and not unknown.on_top]
    tops = [place for place, unknown in enumerate(fit.unknowns) if unknown not in kept and unknown.on_top]
    rows = write_values(fit.rows, [fit.unknowns[place] for place in (*others, *tops)], fit.q[[*others, *tops]])
    chosen = [(unknown, q) for unknown, q in zip(fit.unknowns, fit.q, strict=True) if unknown in kept]
    noise = [
        (unknown, q) for unknown, q in zip(fit.noise, fit.q_noise, strict=True) if set(unknown.tracks) & set(numbers)
    ]
    return evaluated(
        Fit(
            tuple(fit.tracks[number] for number in numbers),
            rows[list(numbers)],
            tuple(_on(unknown, place_of) for unknown, _ in chosen),
            tuple(_on(unknown, place_of) for unknown, _ in noise),
            np.array([q for _, q in chosen]),
            np.array([q for _, q in noise]),
            (),
        )
    )


def with_streams_of(learned: Fit, joint: Fit) -> Fit:
    """Leave out the streams of a learned vehicle that the judged tracks of a joint fit do not have.

    What recordings tell of the time or place of poses beside a speed log says nothing of how far poses alone differ.
    """
    count = len(learned.tracks)
    kept = {stream for track in joint.tracks[count:] for stream in track.timeline.stream_names}
    tracks = tuple(_with_streams(track, kept) for track in learned.tracks)
    if all(mine is its for mine, its in zip(tracks, learned.tracks, strict=True)):
        return learned
    return evaluated(replace(learned, tracks=tracks))


def _with_streams(track: Track, kept: set[str]) -> Track:
    for name in track.timeline.stream_names:
        if name not in kept:
            track = track.without_stream(name)
    return track


def _as_learned(noise: Unknown, known: Floats) -> float:
    """Start q of a noise: that of the learned vehicle's water, and for readings what these recordings' own show."""
    if noise.column not in WATER_NOISE:
        return 0.0
    return noise.clipped(float(known[noise.tracks[0], COLUMN[noise.column]]) - noise.base)


def _with_kept_delays(learned: Fit) -> Iterator[Unknown]:
    """The unknowns of a learned vehicle, delays with bounds by their 95 % intervals."""
    if not any(unknown.column in OF_TIME for unknown in learned.unknowns):
        yield from learned.unknowns
        return
    spread = np.sqrt(np.diag(covariance(learned)))
    for unknown, q, off in zip(learned.unknowns, learned.q.tolist(), (Z95 * spread).tolist(), strict=True):
        is_delay = unknown.column in OF_TIME
        low, high = unknown.bounds
        yield replace(unknown, bounds=(max(low, q - off), min(high, q + off))) if is_delay else unknown


def _extended(unknown: Unknown, tracks: Sequence[Track], first: int) -> Unknown:
    """Let an unknown act on further tracks of its robots too; first: the number of the first of these tracks."""
    more = (first + number for number, track in enumerate(tracks) if track.name in unknown.owner.robots)
    return replace(unknown, tracks=(*unknown.tracks, *more))


def _shifted(unknown: Unknown, first: int) -> Unknown:
    return replace(unknown, tracks=tuple(first + number for number in unknown.tracks))


def _on(unknown: Unknown, place_of: dict[int, int]) -> Unknown:
    """Keep the tracks of an unknown that are among some, by their numbers there."""
    return replace(unknown, tracks=tuple(place_of[number] for number in unknown.tracks if number in place_of))
