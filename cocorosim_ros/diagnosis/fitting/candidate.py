"""Candidates: an entry of the catalogue, or a law outside it, for certain robots, as unknowns of a fit."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from cocorosim_ros.diagnosis.catalogue.entry import Amplitude, Entry, Scene, Shape
from cocorosim_ros.diagnosis.fitting.unknowns import Owner, Unknown
from cocorosim_ros.diagnosis.tracks.by_robot import tracks_by_robot
from cocorosim_ros.diagnosis.tracks.columns import COLUMN
from cocorosim_ros.diagnosis.tracks.track import Track
from cocorosim_ros.diagnosis.tracks.vehicle_size import LILY_SIZES, sizes
from cocorosim_ros.foundation.arrays import Floats

OVER = 0.1  # of a logarithm beyond the largest shape of a grid


class Robots(NamedTuple):
    """Some robots and the numbers of all their tracks."""

    names: tuple[str, ...]
    tracks: tuple[int, ...]


@dataclass(frozen=True)
class Candidate:
    """An entry that acts on `robots`; tracks are numbers by robot. `slot` tells several of one entry apart."""

    entry: Entry
    robots: tuple[str, ...]
    tracks: tuple[tuple[int, ...], ...]  # by robot
    sizes: Mapping[str, float] = field(default_factory=lambda: LILY_SIZES)  # of the vehicle beside a Lily, by unit
    duration: float = math.inf  # of the longest recording [s]
    known: tuple[tuple[float, ...], ...] = ()  # by sharer: amplitudes that the base has already; shapes then stay

    @property
    def key(self) -> tuple[str, str | None, tuple[str, ...]]:
        """What tells candidates apart."""
        return self.entry.id, self.entry.topic, self.robots

    @property
    def everybody(self) -> tuple[int, ...]:
        """All tracks on which it acts."""
        return tuple(itertools.chain.from_iterable(self.tracks))

    @property
    def onset_columns(self) -> frozenset[str]:
        """Columns that say when something happens once."""
        return frozenset(shape.column for shape in self.entry.shapes if shape.once)

    @property
    def sharers(self) -> tuple[Robots, ...]:
        """Robots that share their amplitudes: all where these are of the water, else each alone."""
        if self.entry.water:
            return (Robots(self.robots, self.everybody),)
        return tuple(Robots((robot,), tracks) for robot, tracks in zip(self.robots, self.tracks, strict=True))

    def owns(self, unknown: Unknown) -> bool:
        """Whether an unknown is a number of this entry on these robots."""
        owner = unknown.owner
        same = (owner.effect, owner.topic) == (self.entry.id, self.entry.topic)
        return same and set(owner.robots) <= set(self.robots)

    def places_among(self, unknowns: Sequence[Unknown]) -> list[int]:
        """Which of the unknowns, by number, are this candidate's."""
        return [number for number, unknown in enumerate(unknowns) if self.owns(unknown)]

    def amplitudes(self) -> list[Unknown]:
        """The amplitudes as unknowns, one of each for those that share it."""
        neutral = tuple(amplitude.neutral for amplitude in self.entry.amplitudes)
        bases = self.known or (neutral,) * len(self.sharers)
        return [
            self._amplitude(amplitude, robots, base)
            for robots, own in zip(self.sharers, bases, strict=True)
            for amplitude, base in zip(self.entry.amplitudes, own, strict=True)
        ]

    def _amplitude(self, amplitude: Amplitude, robots: Robots, base: float) -> Unknown:
        large, step = self.large(amplitude), amplitude.step
        shift = (amplitude.neutral - base) / large
        bounds = (amplitude.least + shift, amplitude.most + shift)
        owner = self._owner(amplitude, robots.names)
        return Unknown(owner, amplitude.column, robots.tracks, base, large, prior=1.0, step=step, bounds=bounds)

    def _owner(self, number: Amplitude | Shape, robots: tuple[str, ...]) -> Owner:
        return Owner(self.entry.id, robots, number.name, number.unit, self.entry.topic)

    def searched(self) -> list[Floats]:
        """Amplitudes, in q, at which a fit of it may begin as well: all robots' at the same of the entry's values."""
        (amplitude, *others), sharers = self.entry.amplitudes, len(self.sharers)
        return [] if others or self.known else [np.full(sharers, value) for value in amplitude.searched]

    def large(self, amplitude: Amplitude) -> float:
        """What is large of an amplitude for this vehicle; that of a law is so already."""
        return amplitude.large if self.entry.law is not None else amplitude.large * self.sizes[amplitude.unit]

    def shape_unknowns(self, values: dict[str, float], scene: Scene) -> list[Unknown]:
        """The shapes that are not fixed, around these values, shared by all robots."""
        if self.known:
            return []
        return [
            _shape(shape, self._owner(shape, self.robots), self.everybody, values[shape.column], shape.grid(scene))
            for shape in self.entry.shapes
            if not shape.fixed
        ]

    def settings(self, scene: Scene) -> Iterator[dict[str, float]]:
        """Every point of the grid of shapes, with what is given."""
        if self.known:
            yield {}
            return
        given = {column: value(scene) for column, value in self.entry.fixed.items()}
        for point in itertools.product(*(shape.grid(scene) for shape in self.entry.shapes)):
            yield given | {shape.column: value for shape, value in zip(self.entry.shapes, point, strict=True)}

    def write(self, rows: Floats, values: dict[str, float]) -> Floats:
        """(tracks, columns) a copy of the rows with these values on the candidate's tracks."""
        filled = rows.copy()
        for column, value in values.items():
            filled[list(self.everybody), COLUMN[column]] = value
        return filled


def _shape(shape: Shape, owner: Owner, tracks: tuple[int, ...], value: float, grid: list[float]) -> Unknown:
    """Around one point of its grid; it does not leave the grid by more than half a spacing."""
    ends = (min(grid), max(grid))
    if shape.logarithmic:
        spacing = math.log(ends[1] / ends[0]) / (len(grid) - 1) if len(grid) > 1 else 0.5
        reach = (math.log(ends[0] / value) - spacing, math.log(ends[1] / value) + OVER)
        return Unknown(
            owner, shape.column, tracks, value, 1.0, True, prior=3.0 * spacing, step=0.1 * spacing, bounds=reach
        )
    spacing = (ends[1] - ends[0]) / (len(grid) - 1) if len(grid) > 1 else 1.0
    reach = ((ends[0] - value) / spacing - 0.5, (ends[1] - value) / spacing + 0.5)
    bounds = (-math.inf, math.inf) if shape.periodic else reach
    return Unknown(owner, shape.column, tracks, value, spacing, prior=3.0, step=0.1, bounds=bounds)


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
        alone = [(name,) for name in concerned] if len(concerned) > 1 and not entry.water else []
        for robots in [concerned, *alone]:
            places = tuple(numbers[name] for name in robots)
            first = [own[0] for own in (places[:1] if entry.water else places)]
            found.append(Candidate(entry, robots, places, scaling, duration, _known(entry, rows[first])))
    return found


def _known(entry: Entry, rows: Floats) -> tuple[tuple[float, ...], ...]:
    """The amplitudes of an entry in the base model's rows, one of each owner, if any is not neutral."""
    values = rows[:, [COLUMN[amplitude.column] for amplitude in entry.amplitudes]]
    there = (values != [amplitude.neutral for amplitude in entry.amplitudes]).any()
    return tuple(tuple(own) for own in values.tolist()) if there else ()


def _has_topic(entry: Entry, tracks: Sequence[Track]) -> bool:
    topic = entry.topic
    return topic is None or any(topic in track.log.streams and len(track.log.streams[topic].time) for track in tracks)
