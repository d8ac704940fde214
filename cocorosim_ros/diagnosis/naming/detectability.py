"""Detectability: the nats that each effect of the catalogue would yield in these recordings, had it been there."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES, IDS, WHERE_RECORDED
from cocorosim_ros.diagnosis.catalogue.entry import Entry
from cocorosim_ros.diagnosis.criteria.naming import DETECTABILITY, NAMING
from cocorosim_ros.diagnosis.findings import ScreenedEffect
from cocorosim_ros.diagnosis.fitting.screening import Screened
from cocorosim_ros.diagnosis.fitting.vehicle_needs import has_all
from cocorosim_ros.diagnosis.naming.named_effect import Naming
from cocorosim_ros.diagnosis.tracks.track import Track
from cocorosim_ros.world.sensors.errors import ERRORS

OF_EVERY_STREAM = {name for name, error in ERRORS.items() if error.streams is not None}


def screened_effects(screened: Sequence[Screened]) -> tuple[ScreenedEffect, ...]:
    """List every entry with its evidence and the smallest values that would be seen, most evidence first.

    An entry that was screened for several topics or robots appears once, for those with the most evidence.
    """
    best: dict[str, Screened] = {}
    for each in screened:
        known = best.get(each.candidate.entry.id)
        if known is None or each.nats > known.nats:
            best[each.candidate.entry.id] = each
    return tuple(
        ScreenedEffect(name, each.nats, _smallest(each), _seen_from(each))
        for name, each in sorted(best.items(), key=lambda entry: -entry[1].nats)
    )


def _smallest(screened: Screened) -> dict[str, float]:
    """Smallest visible value of each parameter, in the unit of the parameter, for the first robot.

    It is the value that would yield the threshold if no other parameter were fitted: 1/2 information q^2 = threshold.
    Infinite where that is far beyond a bad case: such a value would be visible, but no vehicle has it.
    """
    found: dict[str, float] = {}
    for unknown, known in zip(screened.candidate.amplitudes(), np.diag(screened.information).tolist(), strict=True):
        share = math.sqrt(2.0 * NAMING.threshold / known) if known > 0.0 else math.inf
        value = unknown.scale * share if share <= DETECTABILITY.most else math.inf
        found.setdefault(unknown.owner.parameter, value)
    return found


def _seen_from(screened: Screened) -> float:
    """Size, as a share of `large`, of all amplitudes together from which an entry would yield the threshold."""
    at_large = expected_nats(screened, 1.0)
    return math.sqrt(NAMING.threshold / at_large) if at_large > 0.0 else math.inf


def expected_nats(screened: Screened, size: float) -> float:
    """Expected evidence [nats] of an entry if each of its amplitudes were `size` times its `large`.

    Between recordings that should be alike it counts as much as evidence does.
    """
    by_slopes = 0.5 * size**2 * float(np.trace(screened.information))
    return felt_share(screened) * by_slopes / screened.candidate.spread


def felt_share(screened: Screened) -> float:
    """Share (0 to 1) of the information by slopes that is felt: less than 1 for a delay that was tried."""
    at_medium = 0.5 * DETECTABILITY.medium**2 * float(np.trace(screened.information))
    if math.isnan(screened.felt) or not at_medium > 0.0:
        return 1.0
    return min(1.0, screened.felt / at_medium)


def not_shown(screened: Sequence[Screened]) -> tuple[str, ...]:
    """Identifiers of effects whose evidence would stay below the threshold even at medium size."""
    seen, tried = _seen(screened), {each.candidate.entry.id for each in screened}
    asked = (*IDS, *(name for name in WHERE_RECORDED if name in tried))
    return tuple(name for name in asked if name not in seen and name != "frame_mixup")


def streams_and_numbers_not_shown(screened: Sequence[Screened]) -> tuple[str, ...]:
    """Names of what would stay unseen beside `not_shown`: effects of single streams, as effect:topic, and numbers.

    Numbers are those of the platform that may differ, such as the thrust of a single thruster.
    """
    names = dict.fromkeys(own_name(each) for each in screened if each.candidate.entry.law is None)
    seen = {own_name(each) for each in screened if _is_seen(each)}
    whole = not_shown(screened)
    return tuple(name for name in names if name not in IDS and name not in seen and name.split(":")[0] not in whole)


def own_name(screened: Screened) -> str:
    """Name of a screened candidate: its entry's, or effect:topic for an entry that each stream may have by itself."""
    return name_of(screened.candidate.entry.id, screened.candidate.entry.topic)


def name_of(effect: str, topic: str | None) -> str:
    """Name of an effect: its own, or effect:topic for one that each stream may have by itself."""
    return f"{effect}:{topic}" if effect in OF_EVERY_STREAM else effect


def _seen(screened: Sequence[Screened]) -> set[str]:
    return {each.candidate.entry.id for each in screened if _is_seen(each)}


def _is_seen(screened: Screened) -> bool:
    return expected_nats(screened, DETECTABILITY.medium) >= NAMING.threshold


def is_blind(unseen: Sequence[str], tracks: Sequence[Track]) -> bool:
    """Tell whether so little of the catalogue could be seen that a diagnosis without effects says nothing.

    Effects of what none of the vehicles has, as of a cable, are no part of what could be seen, nor are errors of
    instruments that were not recorded: silence is not about them.
    """
    had = {entry.id for entry in ENTRIES if any(_has(track, entry) for track in tracks)}
    possible = had & set(IDS)
    return len(possible & set(unseen)) > DETECTABILITY.blind * len(possible)


def _has(track: Track, entry: Entry) -> bool:
    """Tell whether a vehicle has what an effect needs, and the recording the stream whose error it is."""
    return has_all(track.vehicle, entry.needs) and (entry.topic is None or entry.topic in track.log.streams)


def shows_known(naming: Naming) -> bool:
    """Tell whether the recordings show an effect that the model has already as clearly as one that would be named.

    Such recordings tell something, however little else of the catalogue they would show.
    """
    return any(effect.nats >= NAMING.threshold for effect in naming.known)
