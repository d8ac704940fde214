"""Effects that lose their name: as they would have been told, and the fit without them."""

from __future__ import annotations

from collections.abc import Collection
from typing import NamedTuple

from cocorosim_ros.diagnosis.findings import FoundEffect
from cocorosim_ros.diagnosis.naming.named_effect import NamedEffect, Naming
from cocorosim_ros.diagnosis.naming.pruning import taken_back
from cocorosim_ros.diagnosis.showing.estimates import fitted, found_effects


class Withdrawn(NamedTuple):
    """Result of a withdrawal: the rest, the effect with what the fit loses by it, and how it would have been told."""

    left: Naming
    effect: NamedEffect
    told: tuple[FoundEffect, ...]


def withdrawn(naming: Naming, effect: NamedEffect, robots: Collection[str]) -> Withdrawn:
    """Take an effect back from some robots or from all, and fit the rest anew."""
    numbers = fitted(naming.fit)
    left, gone = taken_back(naming, effect, robots)
    return Withdrawn(left, gone, found_effects(naming.fit, [gone], numbers))
