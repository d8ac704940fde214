"""Streams whose stamps are of another clock than those of the same streams when the vehicle was well.

The log times show it, so that the stamps were put right before anything was fitted: no fit finds it any more.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from cocorosim_ros.diagnosis.against.twins import LATE_READINGS
from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES
from cocorosim_ros.diagnosis.criteria.evidence import CLOCKS
from cocorosim_ros.diagnosis.criteria.showing import FRAMING
from cocorosim_ros.diagnosis.evidence.streams.log import Evidence
from cocorosim_ros.diagnosis.findings import Estimate, FoundEffect


def other_clocks(bad: Evidence, good: Evidence) -> Iterator[FoundEffect]:
    """Make a found effect of each stream whose stamps had to be shifted in other recordings by another time [s].

    A stream that is stamped late is `sensor_latency`, known as well as log times can tell it.
    """
    before = _shifts(good)
    for (robot, topic), shift in sorted(_shifts(bad).items()):
        latency = before.get((robot, topic), 0.0) - shift
        if abs(latency) > CLOCKS.far:
            yield _late(robot, topic, latency)


def _shifts(evidence: Evidence) -> dict[tuple[str, str], float]:
    """Median by robot and topic of the time [s] by which the stamps of each recording were set later."""
    found: dict[tuple[str, str], list[float]] = {}
    for recording in evidence.recordings:
        for log in recording.robots:
            for topic, stream in log.streams.items():
                found.setdefault((log.name, topic), []).append(stream.shifted)
    return {key: float(np.median(values)) for key, values in found.items()}


def _late(robot: str, topic: str, latency: float) -> FoundEffect:
    entry = next(entry for entry in ENTRIES if entry.id == LATE_READINGS and entry.topic == topic)
    told = Estimate(latency, latency - CLOCKS.far, latency + CLOCKS.far, "s")
    words = (
        f"by the log times its stamps are {abs(latency):.3g} s {'later' if latency > 0.0 else 'earlier'} than in the "
        "other recordings"
    )
    return FoundEffect(
        entry.id, entry.name, entry.equation, (robot,), "confirmed", {"latency": told}, FRAMING.certain, topic=topic,
        correction=words,
    )  # fmt: skip
