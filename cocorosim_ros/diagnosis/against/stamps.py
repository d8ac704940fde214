"""Streams and commands whose stamps are of another clock than those of the same ones when the vehicle was well.

The log times show it, so that the stamps were put right before anything was fitted: no fit finds it any more.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from cocorosim_ros.diagnosis.against.numbers import delay_entry
from cocorosim_ros.diagnosis.against.twins import LATE_READINGS
from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES
from cocorosim_ros.diagnosis.catalogue.entry import Entry
from cocorosim_ros.diagnosis.criteria.evidence import CLOCKS
from cocorosim_ros.diagnosis.criteria.showing import FRAMING
from cocorosim_ros.diagnosis.evidence.frames.correction import COMMAND
from cocorosim_ros.diagnosis.evidence.streams.log import Evidence
from cocorosim_ros.diagnosis.findings import Estimate, FoundEffect


def other_clocks(bad: Evidence, good: Evidence) -> Iterator[FoundEffect]:
    """Make a found effect of each topic whose stamps had to be shifted in other recordings by another time [s].

    A stream that is stamped late is `sensor_latency`, and commands that are stamped early are `command_delay`: they act
    later than they are logged. Each is known as well as log times can tell it.
    """
    before = _shifts(good)
    for (robot, topic), shift in sorted(_shifts(bad).items()):
        later = before.get((robot, topic), 0.0) - shift
        if abs(later) > CLOCKS.far:
            yield _told(robot, topic, later)


def _shifts(evidence: Evidence) -> dict[tuple[str, str], float]:
    """Median by robot and topic of the time [s] by which the stamps of each recording were set later."""
    found: dict[tuple[str, str], list[float]] = {}
    for recording in evidence.recordings:
        for log in recording.robots:
            for topic, stream in log.streams.items():
                found.setdefault((log.name, topic), []).append(stream.shifted)
            if len(log.command_time):
                found.setdefault((log.name, COMMAND), []).append(log.command_shifted)
    return {key: float(np.median(values)) for key, values in found.items()}


def _told(robot: str, topic: str, later: float) -> FoundEffect:
    """Make the effect of a topic that is stamped so much later [s] than in the other recordings."""
    words = (
        f"by the log times its stamps are {abs(later):.3g} s {'later' if later > 0.0 else 'earlier'} than in the "
        "other recordings"
    )
    is_command = topic == COMMAND
    entry = delay_entry() if is_command else latency_entry(topic)
    late = -later if is_command else later
    told = {entry.amplitudes[0].name: Estimate(late, late - CLOCKS.far, late + CLOCKS.far, "s")}
    return FoundEffect(
        entry.id, entry.name, entry.whole_equation, (robot,), "confirmed", told, FRAMING.certain, topic=entry.topic,
        correction=words,
    )  # fmt: skip


def latency_entry(topic: str) -> Entry:
    """The catalogue's entry of a stream that comes late."""
    return next(entry for entry in ENTRIES if entry.id == LATE_READINGS and entry.topic == topic)
