"""Candidates: an entry of the catalogue, or a law outside it, for certain robots, as unknowns of a fit."""

from __future__ import annotations

import itertools
import math
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import NamedTuple

import numpy as np

from cocorosim_ros.diagnosis.catalogue.entry import Amplitude, Entry, Shape
from cocorosim_ros.diagnosis.catalogue.shown_by import can_be_told
from cocorosim_ros.diagnosis.criteria.fitting import STEPS
from cocorosim_ros.diagnosis.evidence.clocks import has_clock_of_commands
from cocorosim_ros.diagnosis.fitting.unknowns import Owner, Unknown
from cocorosim_ros.diagnosis.fitting.vehicle_needs import has_all
from cocorosim_ros.diagnosis.tracks.by_robot import tracks_by_robot
from cocorosim_ros.diagnosis.tracks.columns import COLUMN
from cocorosim_ros.diagnosis.tracks.track import Track
from cocorosim_ros.diagnosis.tracks.vehicle_size import LILY_SIZES, sizes
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.world.sensors import KINDS
from cocorosim_ros.world.sensors.errors import ERRORS
from cocorosim_ros.world.terms.search import Scene

_SKEW, _DELAY = "clock_skew", "command_delay"


class Robots(NamedTuple):
    """Names of some robots, and the numbers of all their tracks."""

    names: tuple[str, ...]
    tracks: tuple[int, ...]


@dataclass(frozen=True)
class Candidate:
    """An entry of the catalogue, or a law outside it, that acts on certain robots and all their tracks."""

    entry: Entry
    robots: tuple[str, ...]
    tracks: tuple[tuple[int, ...], ...]  # numbers of the tracks of each robot
    sizes: Mapping[str, float] = field(default_factory=lambda: LILY_SIZES)  # by unit: the vehicle relative to a Lily
    duration: float = math.inf  # of the longest recording [s]
    known: tuple[tuple[float, ...], ...] = ()  # by sharer: amplitudes of the base model, if any acts; shapes then stay
    over: frozenset[str] = frozenset()  # columns whose numbers other tracks share: the candidate is a difference there
    spread: float = 1.0  # its nats are divided by that: it differs so much among recordings that should be alike

    @property
    def key(self) -> tuple[str, str | None, tuple[str, ...]]:
        """Identity of the candidate: effect, topic and robots."""
        return self.entry.id, self.entry.topic, self.robots

    def widens(self, other: Candidate) -> bool:
        """Tell whether the entry is another one, with all amplitudes of the other candidate's and more, on its robots.

        A pressure sensor's drift begins with an offset, so that it widens the offset.
        """
        more, one = ({each.column for each in of.entry.amplitudes} for of in (self, other))
        return one < more and self.entry.id != other.entry.id and self.robots == other.robots

    @property
    def everybody(self) -> tuple[int, ...]:
        """Numbers of all tracks on which the candidate acts."""
        return tuple(itertools.chain.from_iterable(self.tracks))

    @property
    def onset_columns(self) -> frozenset[str]:
        """Columns of shapes that hold the moment of an event that happens once."""
        return frozenset(shape.column for shape in self.entry.shapes if shape.once)

    @property
    def sharers(self) -> tuple[Robots, ...]:
        """Groups of robots with the same amplitudes: all together for effects of the water, else each alone."""
        if self.entry.water:
            return (Robots(self.robots, self.everybody),)
        return tuple(Robots((robot,), tracks) for robot, tracks in zip(self.robots, self.tracks, strict=True))

    def of_robots(self, robots: Collection[str]) -> Candidate:
        """Copy the candidate for those of its robots alone; for all where they share its amplitudes."""
        if self.entry.water:
            return self
        kept = [place for place, name in enumerate(self.robots) if name in robots]
        names, tracks = tuple(self.robots[place] for place in kept), tuple(self.tracks[place] for place in kept)
        known = tuple(self.known[place] for place in kept) if self.known else ()
        return replace(self, robots=names, tracks=tracks, known=known)

    def owns(self, unknown: Unknown) -> bool:
        """Tell whether an unknown belongs to this entry, and to no robot but those of the candidate."""
        owner = unknown.owner
        same = (owner.effect, owner.topic) == (self.entry.id, self.entry.topic)
        return same and set(owner.robots) <= set(self.robots)

    def places_among(self, unknowns: Sequence[Unknown]) -> list[int]:
        """Places, in a sequence of unknowns, of those that the candidate owns."""
        return [number for number, unknown in enumerate(unknowns) if self.owns(unknown)]

    def amplitudes(self) -> list[Unknown]:
        """Make the amplitudes into unknowns: one of each for every group of robots that shares it, in that order."""
        neutral = tuple(amplitude.neutral for amplitude in self.entry.amplitudes)
        bases = self.known or (neutral,) * len(self.sharers)
        return [
            self._amplitude(amplitude, robots, base)
            for robots, own in zip(self.sharers, bases, strict=True)
            for amplitude, base in zip(self.entry.amplitudes, own, strict=True)
        ]

    def _amplitude(self, amplitude: Amplitude, robots: Robots, base: float) -> Unknown:
        """Make one amplitude into an unknown around `base`, in units of its `large`; on top in columns of `over`."""
        large, step = self.large(amplitude), amplitude.step
        shift = (amplitude.neutral - base) / large
        bounds = (amplitude.least + shift, amplitude.most + shift)
        owner = self._owner(amplitude, robots.names)
        if amplitude.factor:
            return Unknown(
                owner, amplitude.column, robots.tracks, 1.0, large, logarithmic=True, prior=1.0, step=step,
                bounds=(amplitude.least, amplitude.most), on_top=True,
            )  # fmt: skip
        if amplitude.column in self.over:
            return Unknown(
                owner, amplitude.column, robots.tracks, 0.0, large, prior=1.0, step=step, bounds=bounds, on_top=True
            )
        return Unknown(owner, amplitude.column, robots.tracks, base, large, prior=1.0, step=step, bounds=bounds)

    def _owner(self, number: Amplitude | Shape, robots: tuple[str, ...]) -> Owner:
        return Owner(self.entry.id, robots, number.name, number.unit, self.entry.topic)

    def searched(self) -> list[Floats]:
        """Further starts of a fit: q of the amplitudes (n,), the same for all robots; empty where a slope is enough.

        A difference on top of a number may be of either sign.
        """
        (amplitude, *others), sharers = self.entry.amplitudes, len(self.sharers)
        if others or not amplitude.searched:
            return []
        if amplitude.column not in self.over:
            return [] if self.known else [np.full(sharers, value) for value in amplitude.searched]
        lowest = max(unknown.bounds[0] for unknown in self.amplitudes())
        both = sorted({*amplitude.searched, *(-value for value in amplitude.searched)})
        return [np.full(sharers, value) for value in both if value > lowest]

    def large(self, amplitude: Amplitude) -> float:
        """Large value of an amplitude for this vehicle, in the amplitude's unit.

        Entries of the catalogue give it for a Lily, laws outside the catalogue for the vehicle at hand. However strong
        the vehicle is, no error of its instruments is larger than they can err by.
        """
        if self.entry.law is not None:
            return amplitude.large
        return min(amplitude.large * self.sizes[amplitude.unit], _most_of_instrument(self.entry.id, amplitude))

    def negligible(self, amplitude: Amplitude) -> tuple[float, float]:
        """Distances of an amplitude from neutral between which it is not believed, in its unit; delays of slow ones."""
        low, high = amplitude.negligible
        scale = self.sizes["s"] if amplitude.unit == "s" else 1.0
        return scale * low, scale * high

    def shape_unknowns(self, values: dict[str, float], scene: Scene) -> list[Unknown]:
        """Make the shapes that are not fixed into unknowns around `values` (by column), shared by all robots."""
        if self.known:
            return []
        return [
            self._shape(shape, values[shape.column], shape.grid(scene))
            for shape in self.entry.shapes
            if not shape.fixed
        ]

    def _shape(self, shape: Shape, value: float, grid: list[float]) -> Unknown:
        """Make a shape into an unknown; of a swing, with a step for slopes that hardly moves its phase at the end."""
        unknown = _shape(shape, self._owner(shape, self.robots), self.everybody, value, grid)
        if not shape.swing or math.isinf(self.duration):
            return unknown
        rate = value if shape.unit == "rad/s" else 2.0 * math.pi / value
        return replace(unknown, step=min(unknown.step, STEPS.of_phase / (rate * self.duration)))

    def settings(self, scene: Scene) -> Iterator[dict[str, float]]:
        """Iterate over the grid of shapes: values by column, those that the entry fixes included."""
        if self.known:
            yield {}
            return
        given = {column: value(scene) for column, value in self.entry.fixed.items()}
        for point in itertools.product(*(shape.grid(scene) for shape in self.entry.shapes)):
            yield given | {shape.column: value for shape, value in zip(self.entry.shapes, point, strict=True)}

    def write(self, rows: Floats, values: dict[str, float]) -> Floats:
        """Copy rows (tracks, columns), with `values` by column written into the rows of the candidate's tracks."""
        filled = rows.copy()
        for column, value in values.items():
            filled[list(self.everybody), COLUMN[column]] = value
        return filled


def _shape(shape: Shape, owner: Owner, tracks: tuple[int, ...], value: float, grid: list[float]) -> Unknown:
    """Make a shape into an unknown around `value`, a point of its grid.

    q counts spacings of the grid, or is the logarithm of the shape over `value` where the shape is logarithmic. Bounds
    keep the shape near the grid: within half a spacing; on a logarithmic grid a spacing below and a little above it. A
    periodic shape is not bounded.
    """
    ends = (min(grid), max(grid))
    if shape.logarithmic:
        spacing = math.log(ends[1] / ends[0]) / (len(grid) - 1) if len(grid) > 1 else 0.5
        reach = (math.log(ends[0] / value) - spacing, math.log(ends[1] / value) + STEPS.beyond_grid)
        return Unknown(
            owner, shape.column, tracks, value, 1.0, True, prior=3.0 * spacing, step=0.1 * spacing, bounds=reach
        )
    spacing = (ends[1] - ends[0]) / (len(grid) - 1) if len(grid) > 1 else 1.0
    reach = ((ends[0] - value) / spacing - 0.5, (ends[1] - value) / spacing + 0.5)
    bounds = (-math.inf, math.inf) if shape.periodic else reach
    return Unknown(owner, shape.column, tracks, value, spacing, prior=3.0, step=0.1, bounds=bounds)


def expand(
    entries: Sequence[Entry], tracks: Sequence[Track], rows: Floats, known: Collection[str] = ()
) -> list[Candidate]:
    """Make entries into candidates: for all robots together, and for each alone where there are several.

    Effects of the water act on all robots together only. Entries that need neighbours, or a stream, are left out where
    the recordings have none; errors of readings where no other reading shows what they depend on (`shown_by`).
    rows (tracks, columns): the base model, in which some of the effects may act already. known: states that are shown
    by something else than readings.
    """
    numbers = tracks_by_robot(tracks)
    scaling = sizes(tracks[0].vehicle)
    duration = max(track.timeline.grid.duration for track in tracks)
    found = []
    for entry in entries:
        if entry.needs_neighbours and len(numbers) < 2:
            continue
        if not has_all(tracks[0].vehicle, entry.needs):
            continue
        concerned = tuple(name for name in numbers if _shows(entry, [tracks[each] for each in numbers[name]], known))
        if not concerned:
            continue
        alone = [(name,) for name in concerned] if len(concerned) > 1 and not entry.water else []
        for robots in [concerned, *alone]:
            places = tuple(numbers[name] for name in robots)
            first = [own[0] for own in (places[:1] if entry.water else places)]
            found.append(Candidate(entry, robots, places, scaling, duration, _known(entry, rows[first])))
    return found


def _known(entry: Entry, rows: Floats) -> tuple[tuple[float, ...], ...]:
    """Amplitudes of an entry in `rows` (owners, columns) of the base model; () if all are neutral."""
    values = rows[:, [COLUMN[amplitude.column] for amplitude in entry.amplitudes]]
    there = (values != [amplitude.neutral for amplitude in entry.amplitudes]).any()
    return tuple(tuple(own) for own in values.tolist()) if there else ()


def _shows(entry: Entry, tracks: Sequence[Track], known: Collection[str] = ()) -> bool:
    """Tell whether any of these tracks has readings of the entry's stream, and others by which its error is told.

    known: states that are shown by something else. A skew of the stream's clock is told by commands that have another
    clock. Commands that were measured act when they are logged.
    """
    topic = entry.topic
    if entry.id == _DELAY:
        return not all(track.log.measured for track in tracks)
    if topic is None:
        return True
    having = [track for track in tracks if topic in track.log.streams and len(track.log.streams[topic].time)]
    if entry.id == _SKEW:
        having = [track for track in having if not has_clock_of_commands(track.log, topic)]
    return bool(having) and can_be_told(entry, [track.timeline.kinds for track in having], known)


def _most_of_instrument(effect: str, amplitude: Amplitude) -> float:
    """The most that an instrument errs by, for an amplitude that is added to its reading; infinite for all others."""
    error = ERRORS.get(effect)
    if error is None or error.most_error is not None:
        return math.inf
    kinds = [KINDS[change.kind] for change in error.changes if amplitude.name in change.numbers]
    return min((kind.most_error.amount for kind in kinds if kind.unit == amplitude.unit), default=math.inf)
