"""Pods, rudders and fins that turn slowly, which late commands and a lag of thrusters stand for.

An angle that is commanded is there only after its servo has turned, at a rate that no platform's file tells. What it
pushes meanwhile is that of an older command.
"""

from __future__ import annotations

from collections.abc import Iterator

from cocorosim_ros.diagnosis.against.numbers import DELAY
from cocorosim_ros.diagnosis.showing.actuator_names import LAG
from cocorosim_ros.diagnosis.showing.case import Case, Objection, effects_of
from cocorosim_ros.diagnosis.tracks.track import Track


def slow_steering(case: Case) -> Iterator[Objection]:
    """Object to late commands and lags of vehicles whose thrust or hull is steered by angles that nothing reports."""
    if case.base is None:  # against other recordings, whose angles turned as slowly
        return
    for found, named in effects_of(case):
        tracks = (case.final.tracks[number] for number in named.candidate.everybody)
        if found.id in (DELAY, LAG) and any(map(_turns_unseen, tracks)):
            yield Objection(
                "This vehicle steers by angles of pods, rudders or fins, which no actuator reports: if they turn "
                "slowly, that looks like commands that act late. Record the angles, or measure how fast they turn.",
                effect=found,
            )


def _turns_unseen(track: Track) -> bool:
    """Tell whether actuators are commanded by angles, and no angle is among what they report."""
    return bool(track.vehicle.is_steering.any()) and not any(each.quantity == "angle" for each in track.log.feedback)
