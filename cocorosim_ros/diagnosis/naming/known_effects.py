"""Effects that the base model has already, with the nats that they are worth: they leave rests as named ones do.

An effect in the water rarely has exactly the form of its law. Of what is left over, a search that named it asks more
(`needed_evidence`). A search that begins with the model that the other one found has to ask the same, or it would name
the rests that the other one passed over.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES
from cocorosim_ros.diagnosis.catalogue.open_set import open_set
from cocorosim_ros.diagnosis.fitting.candidate import Candidate, expand
from cocorosim_ros.diagnosis.fitting.climbing import improved, with_noise
from cocorosim_ros.diagnosis.fitting.fit import Fit, evaluated
from cocorosim_ros.diagnosis.fitting.held_out import HeldOutGain
from cocorosim_ros.diagnosis.fitting.smoothed import smoothed_tracks
from cocorosim_ros.diagnosis.naming.named_effect import NamedEffect
from cocorosim_ros.diagnosis.naming.residual import scene_of
from cocorosim_ros.diagnosis.naming.single_thrusters import looked_for_alone, thruster_of
from cocorosim_ros.diagnosis.naming.steering_trims import trim_entries, trimmed
from cocorosim_ros.diagnosis.tracks.columns import COLUMN, WATER_RANDOM
from cocorosim_ros.diagnosis.tracks.own_numbers import gain_key, trim_key
from cocorosim_ros.world.effects import LAWS
from cocorosim_ros.world.sensors.law import SENSOR_LAWS


def known_effects(base: Fit) -> tuple[NamedEffect, ...]:
    """Effects that act in the rows of the recalibrated model, each with what it explains there that no noise does.

    They are found before if the platform's file gives 95 % intervals of them, as the model of a diagnosis does; of a
    law, which has none there, if it gives any.
    """
    every = (*ENTRIES, *looked_for_alone(base.tracks), *trim_entries(base.tracks))
    having = _having(expand(every, base.tracks, base.rows))
    if any(base.rows[:, COLUMN[f"{place}.coefficient"]].any() for place in (*LAWS, *SENSOR_LAWS)):
        scene = scene_of(base.tracks, smoothed_tracks(base))
        having += _having(expand(open_set(scene, [], base.rows, water=False), base.tracks, base.rows))
    nothing = HeldOutGain(np.zeros(0), 1.0)
    return tuple(
        NamedEffect(
            each, base.objective - _without(base, each).objective, (), nothing, found_before=_is_found(base, each)
        )
        for each in having
    )


def _is_found(base: Fit, candidate: Candidate) -> bool:
    """Tell whether the platform's file has an effect from a diagnosis."""
    thruster, steering = thruster_of(candidate.entry.id), trimmed(candidate.entry.id)
    begin = gain_key(thruster) if thruster else trim_key(steering) if steering else f"effects.{candidate.entry.id}."
    begin = begin if candidate.entry.law is None else ""
    return any(key.startswith(begin) for track in base.tracks for key in track.vehicle.intervals)


def _having(candidates: Sequence[Candidate]) -> list[Candidate]:
    """Choose the candidates that act in the base model, each for the most robots for which it is looked for."""
    found: dict[tuple[str, str | None], Candidate] = {}
    for each in candidates:
        key = each.entry.id, each.entry.topic
        if each.known and (key not in found or len(each.robots) > len(found[key].robots)):
            found[key] = each
    return list(found.values())


def _without(base: Fit, candidate: Candidate) -> Fit:
    """Fit the base model anew with the amplitudes of a candidate at their neutral values."""
    neutral = {amplitude.column: amplitude.neutral for amplitude in candidate.entry.amplitudes}
    start = evaluated(replace(base, rows=candidate.write(base.rows, neutral)))
    return improved(with_noise(start, 2, WATER_RANDOM), 2)
