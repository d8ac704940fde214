"""Two models on recordings that neither was fitted to: free runs from the same starts over the same seconds."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

SETTLING = 0.1  # share of a recording in which the filter finds the state


class OnUnseen(NamedTuple):
    """Root mean square errors of a channel, over windows of so many seconds, by the platform's file and a found model.

    worse: share of the windows in which the found model errs more.
    """

    nominal: float
    found: float
    seconds: float
    windows: int
    worse: float


def on_unseen(nominal: str, found: Path, bags: Sequence[Path]) -> dict[str, OnUnseen]:
    """Errors by channel that readings show; empty where the recordings cannot be used.

    Starts, and how long models run, are those of the platform's file, recalibrated on these very recordings: the only
    thing that is fitted here, and no part of either model. Both are driven by reported angles where a diagnosis of
    these recordings would be, else by those ordered. As neither model has seen anything of these recordings, free runs
    go through all of each, but for the share at its beginning in which the filter finds the state.
    """
    from cocorosim_ros.diagnosis.evidence.gather import gather_evidence
    from cocorosim_ros.diagnosis.evidence.intake import take_in
    from cocorosim_ros.diagnosis.fitting.acting_angles import driven_as_shown
    from cocorosim_ros.diagnosis.fitting.recalibration import base_fit
    from cocorosim_ros.diagnosis.foretelling.foreseeable import foreseeable_parts
    from cocorosim_ros.diagnosis.foretelling.gains import FreeRuns
    from cocorosim_ros.diagnosis.foretelling.unseen import Unseen, starts_of
    from cocorosim_ros.scenario.parts.platform import load_platform

    intake = take_in(gather_evidence(bags, load_platform(nominal)))
    if intake.reasons:
        return {}
    base = driven_as_shown(intake.evidence, base_fit).base
    starts = starts_of(base.tracks, base.filled)
    unseen = Unseen(base, _whole(base.tracks), foreseeable_parts(base).seconds, base.filled, (), starts, ())
    runs = FreeRuns(unseen, unseen.rows)
    by_file = runs.errors_from_given_starts(unseen.base.rows)
    tracks = tuple(_tracks(unseen.tracks, load_platform(found)))
    rows = np.array([track.vehicle.row for track in tracks])
    by_model = FreeRuns(
        replace(unseen, base=replace(unseen.base, tracks=tracks)), unseen.rows
    ).errors_from_given_starts(rows)
    return {
        channel: OnUnseen(*_roots(one, other), unseen.seconds, int(seen.sum()), float(np.mean(other[seen] > one[seen])))
        for channel, one, other in zip(runs.channels, by_file.T, by_model.T, strict=True)
        if (seen := np.isfinite(one)).any()
    }


def _whole(tracks: Sequence[Any]) -> tuple[Any, ...]:
    """Hold out all of each track but its beginning."""
    from cocorosim_ros.diagnosis.foretelling.held_out_parts import Span, Split

    points = [track.timeline.grid.points for track in tracks]
    return tuple(Split((Span(round(SETTLING * count), count - round(SETTLING * count)),), ()) for count in points)


def _roots(*squares: Any) -> Iterator[float]:
    for each in squares:
        yield float(np.sqrt(np.nanmean(each)))


def _tracks(tracks: Sequence[Any], platform: Any) -> Iterator[Any]:
    """The same tracks, on the same grid, with the vehicle of another platform file."""
    from cocorosim_ros.diagnosis.tracks.actuation import Actuation
    from cocorosim_ros.diagnosis.tracks.vehicle_model import vehicle_model

    for track in tracks:
        own = vehicle_model(platform.of_robot(track.name))
        vehicle = replace(own, surroundings=track.vehicle.surroundings, tilts=track.vehicle.tilts)
        actuation = Actuation(vehicle, track.log, track.timeline.grid)
        yield replace(track, vehicle=vehicle, actuation=actuation, filter=track.filter.over(track.timeline, actuation))
