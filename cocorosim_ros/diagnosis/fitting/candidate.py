"""Candidates: an entry of the catalogue, or a law outside it, for certain robots, as unknowns of a fit."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from cocorosim_ros.diagnosis.catalogue.entry import Amplitude, Entry, Scene, Shape
from cocorosim_ros.diagnosis.fitting.unknowns import Unknown
from cocorosim_ros.diagnosis.tracks.by_robot import tracks_by_robot
from cocorosim_ros.diagnosis.tracks.columns import COLUMN
from cocorosim_ros.diagnosis.tracks.track import Track
from cocorosim_ros.diagnosis.tracks.vehicle_size import sizes
from cocorosim_ros.foundation.arrays import Floats

OVER = 0.1  # of a logarithm beyond the largest shape of a grid


@dataclass(frozen=True)
class Candidate:
    """An entry that acts on `robots`; tracks are numbers by robot. `slot` tells several of one entry apart."""

    entry: Entry
    robots: tuple[str, ...]
    tracks: tuple[tuple[int, ...], ...]  # by robot
    sizes: Mapping[str, float] = field(default_factory=dict)  # of the vehicle beside a Lily, by unit
    duration: float = math.inf  # of the longest recording [s]
    known: tuple[tuple[float, ...], ...] = ()  # by owner: amplitudes that the base has already; shapes then stay

    @property
    def key(self) -> tuple[str, str | None, tuple[str, ...]]:
        """What tells candidates apart."""
        return self.entry.id, self.entry.topic, self.robots

    @property
    def everybody(self) -> tuple[int, ...]:
        """All tracks on which it acts."""
        return tuple(itertools.chain.from_iterable(self.tracks))

    @property
    def moments(self) -> frozenset[str]:
        """Columns that say when something happens once."""
        return frozenset(part.column for part in self.entry.shapes if part.once)

    def amplitudes(self) -> list[Unknown]:
        """The amplitudes as unknowns: shared where they are of the water, else one for each robot."""
        owners = (self.everybody,) if self.entry.water else self.tracks
        bases = self.known or (tuple(part.neutral for part in self.entry.amplitudes),) * len(owners)
        return [
            _amplitude(part, tracks, base, self.large(part))
            for tracks, own in zip(owners, bases, strict=True)
            for part, base in zip(self.entry.amplitudes, own, strict=True)
        ]

    def searched(self) -> list[Floats]:
        """Amplitudes, in q, at which a fit of it may begin as well: all robots' at the same of the entry's values."""
        (part, *others), owners = self.entry.amplitudes, 1 if self.entry.water else len(self.tracks)
        return [] if others or self.known else [np.full(owners, value) for value in part.searched]

    def large(self, part: Amplitude) -> float:
        """What is large of an amplitude for this vehicle; that of a law is so already."""
        return part.large if self.entry.law is not None else part.large * self.sizes.get(part.unit, 1.0)

    def shape_unknowns(self, values: dict[str, float], scene: Scene) -> list[Unknown]:
        """The shapes that are not fixed, around these values, shared by all robots."""
        if self.known:
            return []
        return [
            _shape(part, self.everybody, values[part.column], part.grid(scene))
            for part in self.entry.shapes
            if not part.fixed
        ]

    def settings(self, scene: Scene) -> Iterator[dict[str, float]]:
        """Every point of the grid of shapes, with what is given."""
        if self.known:
            yield {}
            return
        given = {column: value(scene) for column, value in self.entry.fixed.items()}
        for point in itertools.product(*(part.grid(scene) for part in self.entry.shapes)):
            yield given | {part.column: value for part, value in zip(self.entry.shapes, point, strict=True)}

    def write(self, rows: Floats, values: dict[str, float]) -> Floats:
        """(tracks, columns) a copy of the rows with these values on the candidate's tracks."""
        filled = rows.copy()
        for column, value in values.items():
            filled[list(self.everybody), COLUMN[column]] = value
        return filled


def _amplitude(part: Amplitude, tracks: tuple[int, ...], base: float, large: float) -> Unknown:
    shift = (part.neutral - base) / large
    bounds = (part.least + shift, part.most + shift)
    return Unknown(part.column, tracks, base, large, prior=1.0, step=part.step, bounds=bounds)


def _shape(part: Shape, tracks: tuple[int, ...], value: float, grid: list[float]) -> Unknown:
    """Around one point of its grid; it does not leave the grid by more than half a spacing."""
    ends = (min(grid), max(grid))
    if part.logarithmic:
        spacing = math.log(ends[1] / ends[0]) / (len(grid) - 1) if len(grid) > 1 else 0.5
        reach = (math.log(ends[0] / value) - spacing, math.log(ends[1] / value) + OVER)
        return Unknown(part.column, tracks, value, 1.0, True, prior=3.0 * spacing, step=0.1 * spacing, bounds=reach)
    spacing = (ends[1] - ends[0]) / (len(grid) - 1) if len(grid) > 1 else 1.0
    reach = ((ends[0] - value) / spacing - 0.5, (ends[1] - value) / spacing + 0.5)
    bounds = (-math.inf, math.inf) if part.periodic else reach
    return Unknown(part.column, tracks, value, spacing, prior=3.0, step=0.1, bounds=bounds)


def expand(entries: Sequence[Entry], tracks: Sequence[Track], rows: Floats) -> list[Candidate]:
    """Every entry for all robots together and, where there are several and it is no matter of the water, for each.

    rows (tracks, columns): the base model, which may have some of them already.
    """
    numbers = tracks_by_robot(tracks)
    scaling = sizes(tracks[0].vehicle)
    duration = max(track.timeline.grid.duration for track in tracks)
    found = []
    for entry in entries:
        if entry.needs_neighbours and len(numbers) < 2:
            continue
        concerned = tuple(name for name in numbers if _has_topic(entry, [tracks[index] for index in numbers[name]]))
        if not concerned:
            continue
        groups = [concerned] if entry.water or len(concerned) == 1 else [concerned, *((name,) for name in concerned)]
        for group in groups:
            places = tuple(numbers[name] for name in group)
            owners = places[:1] if entry.water else places
            found.append(
                Candidate(entry, group, places, scaling, duration, _known(entry, rows[[own[0] for own in owners]]))
            )
    return found


def _known(entry: Entry, rows: Floats) -> tuple[tuple[float, ...], ...]:
    """The amplitudes of an entry in the base model's rows, one of each owner, if any is not neutral."""
    values = rows[:, [COLUMN[part.column] for part in entry.amplitudes]]
    there = (values != [part.neutral for part in entry.amplitudes]).any()
    return tuple(tuple(own) for own in values.tolist()) if there else ()


def _has_topic(entry: Entry, tracks: Sequence[Track]) -> bool:
    topic = entry.topic
    return topic is None or any(topic in track.log.streams and len(track.log.streams[topic].time) for track in tracks)
