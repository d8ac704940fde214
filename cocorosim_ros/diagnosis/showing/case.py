"""A finished diagnosis as the hard stops look at it, and their objections."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

from cocorosim_ros.diagnosis.findings import FoundEffect, HeldOut
from cocorosim_ros.diagnosis.fitting.fit import Fit
from cocorosim_ros.diagnosis.naming.named_effect import NamedEffect
from cocorosim_ros.diagnosis.tracks.passes import Smoothed


@dataclass(frozen=True)
class Case:
    """A finished diagnosis as the stops look at it.

    final: the fit with all named effects; courses: its smoothed course for each track; table: errors of free runs.
    base: the fit before any was named, where it may be asked. declared_form: whether the form of the drag was taken
    from the platform's file, and not chosen by these recordings.
    """

    final: Fit
    named: Sequence[NamedEffect]
    found: Sequence[FoundEffect]
    courses: Sequence[Smoothed]
    table: Mapping[str, HeldOut]
    base: Fit | None = None
    declared_form: bool = False


class Objection(NamedTuple):
    """A sentence against all effects of some robots, () for all robots, but for spared ones; or against one alone."""

    sentence: str
    robots: tuple[str, ...] = ()
    effect: FoundEffect | None = None
    spared: tuple[FoundEffect, ...] = ()

    def concerns(self, found: FoundEffect) -> bool:
        """Tell whether an effect is concerned; one that was put right before any fit is never."""
        if found.correction is not None or any(each is found for each in self.spared):
            return False
        if self.effect is not None:
            return self.effect is found
        return not self.robots or not set(self.robots).isdisjoint(found.robots)


Stop = Callable[[Case], Iterator[Objection]]


def effects_of(case: Case) -> Iterator[tuple[FoundEffect, NamedEffect]]:
    """Effects as they are reported, each with the named effect that it is of."""
    for found in case.found:
        for named in case.named:
            entry = named.candidate.entry
            if (entry.id, entry.topic) == (found.id, found.topic) and set(found.robots) <= set(named.candidate.robots):
                yield found, named
