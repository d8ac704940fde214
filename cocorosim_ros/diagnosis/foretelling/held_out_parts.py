"""Held-out parts: blocks spread through each recording, or whole recordings, and the fit to all the rest.

Blocks lie late in one recording, early in the next and in the middle of a third, so that they meet all that happens.
Where what is held out is of another regime than the rest all the same (faster, deeper, in reverse), they lie elsewhere.
What lies between them is fitted as pieces that begin anew, each with a state of its own, so that nothing of a
block gets into the fit of the numbers. Robots of one recording have the same blocks.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from cocorosim_ros.diagnosis.criteria.foretelling import FREE_RUNS
from cocorosim_ros.diagnosis.fitting.climbing import improved, with_noise
from cocorosim_ros.diagnosis.fitting.fit import Fit, evaluated
from cocorosim_ros.diagnosis.fitting.unknowns import Unknown, write_values
from cocorosim_ros.diagnosis.foretelling.regimes import QUANTITIES, unlikeness
from cocorosim_ros.diagnosis.tracks.columns import WATER_RANDOM
from cocorosim_ros.diagnosis.tracks.track import Track
from cocorosim_ros.foundation.arrays import Floats


class Span(NamedTuple):
    """Some grid points of a track, behind each other."""

    first: int
    points: int

    @property
    def end(self) -> int:
        """The grid point behind the last one."""
        return self.first + self.points


NOWHERE = np.zeros((0, len(QUANTITIES)))


class Split(NamedTuple):
    """Parts of a track: those that are held out, and the pieces that are fitted."""

    held: tuple[Span, ...]
    seen: tuple[Span, ...]


def split_tracks(
    tracks: Sequence[Track], seconds: float, among: Collection[int], regimes: Sequence[Floats]
) -> tuple[Split, ...]:
    """Choose what is held out of each track, for free runs of so many seconds; nothing of one that is not `among`.

    regimes: by track, values (points, quantities) by which its parts may differ. Of a few assignments the first is
    taken, if what it holds out is like the rest; else the one of which that is most so.
    """
    numbers = sorted(among)
    assignments = _assignments([tracks[number] for number in numbers], seconds)
    own = [regimes[number] for number in numbers]
    best = assignments[0]
    if _apart(best, own) > FREE_RUNS.unlike:
        best = min(assignments, key=lambda splits: _apart(splits, own))
    chosen = iter(best)
    whole = [Split((), (Span(0, track.timeline.grid.points),)) for track in tracks]
    return tuple(next(chosen) if number in among else split for number, split in enumerate(whole))


def _apart(splits: Sequence[Split], regimes: Sequence[Floats]) -> float:
    """Difference between what splits hold out and what they do not, of all tracks together [standard deviations]."""

    def values(parts: Sequence[Sequence[Span]]) -> Floats:
        along = zip(regimes, parts, strict=True)
        return np.concatenate([values[span.first : span.end] for values, spans in along for span in spans] or [NOWHERE])

    return unlikeness(values([split.held for split in splits]), values([split.seen for split in splits]))


def _assignments(tracks: Sequence[Track], seconds: float) -> list[tuple[Split, ...]]:
    """Ways to hold parts out, the usual one first; in the others each recording takes the place of a later one."""
    places = _recordings(tracks)
    counts = [_blocks(track, seconds) for track in tracks]
    points = [track.timeline.grid.points for track in tracks]
    are_whole = max(places) + 1 >= FREE_RUNS.many and max(counts) == 1

    def split(length: int, count: int, place: int) -> Split:
        return (
            _whole(length, place)
            if are_whole
            else _spread(length, count, FREE_RUNS.places[place % len(FREE_RUNS.places)])
        )

    ways = [
        tuple(split(length, count, place + shift) for length, count, place in zip(points, counts, places, strict=True))
        for shift in range(FREE_RUNS.assignments)
    ]
    return list(dict.fromkeys(ways))


def _recordings(tracks: Sequence[Track]) -> list[int]:
    """Number of the recording of each track, by how many tracks of the same robot came before."""
    names = [track.name for track in tracks]
    return [names[:number].count(name) for number, name in enumerate(names)]


def _blocks(track: Track, seconds: float) -> int:
    """Number of blocks of a track, with FREE_RUNS.seen_windows windows between them where there is room."""
    fitted = (1.0 - FREE_RUNS.held_out) * track.timeline.grid.duration
    return min(max(int(fitted / (FREE_RUNS.seen_windows * seconds)), 1), FREE_RUNS.most_blocks)


def _whole(points: int, place: int) -> Split:
    """Hold out a whole recording wherever the number of those that should be held out grows by one."""
    grows = int((place + 1) * FREE_RUNS.held_out + 1e-9) > int(place * FREE_RUNS.held_out + 1e-9)
    return whole(points) if grows else Split((), (Span(0, points),))


def whole(points: int) -> Split:
    """Hold out a whole recording of so many grid points, but for its beginning, where little is known of the start."""
    begin = round(min(FREE_RUNS.places) * points)
    return Split((Span(begin, points - begin),), ())


def _spread(points: int, count: int, place: float) -> Split:
    """Hold out a block in each of `count` periods, from the share `place` of the period on; short rests are lost."""
    period = points / count
    length = int(FREE_RUNS.held_out * period)
    begins = [round((number + place) * period) for number in range(count)]
    held = tuple(Span(begin, min(length, points - begin)) for begin in begins)
    edges = [0, *(edge for span in held for edge in (span.first, span.end)), points]
    between = (Span(begin, end - begin) for begin, end in zip(edges[::2], edges[1::2], strict=True))
    return Split(held, tuple(span for span in between if span.points >= 2 * FREE_RUNS.fewest_points))


def fitted_to_the_rest(fit: Fit, splits: Sequence[Split]) -> Floats:
    """Fit a model anew to what is not held out; return its rows (tracks, columns), held-out tracks included.

    What belongs to held-out recordings alone, as the noise of their poses, stays as it was in `fit`.
    """
    owners = [number for number, split in enumerate(splits) for _ in split.seen]
    spans = [span for split in splits for span in split.seen]
    pieces = [fit.tracks[number].piece(*span) for number, span in zip(owners, spans, strict=True)]
    if not pieces:
        return fit.filled
    unknowns, known = _of_pieces(fit.unknowns, owners)
    noise, heard = _of_pieces(fit.noise, owners)
    start = Fit(tuple(pieces), fit.rows[owners], unknowns, noise, fit.q[known], fit.q_noise[heard], ())
    found = improved(with_noise(improved(evaluated(start), 2), 1, WATER_RANDOM), 3)
    q, q_noise = fit.q.copy(), fit.q_noise.copy()
    q[known], q_noise[heard] = found.q, found.q_noise
    return write_values(write_values(fit.rows, fit.unknowns, q), fit.noise, q_noise)


def _of_pieces(unknowns: Sequence[Unknown], owners: Sequence[int]) -> tuple[tuple[Unknown, ...], list[int]]:
    """Unknowns that act on pieces of their tracks, and their numbers; owners: the track of each piece."""
    moved = [
        replace(unknown, tracks=tuple(int(piece) for piece in np.flatnonzero(np.isin(owners, unknown.tracks))))
        for unknown in unknowns
    ]
    kept = [number for number, unknown in enumerate(moved) if unknown.tracks]
    return tuple(moved[number] for number in kept), kept
