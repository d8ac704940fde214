"""What is believed of delays, and how long ones are looked for, follow from the recordings."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest

from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES


@pytest.fixture
def track(swim: Any) -> Any:
    """A Lily's track."""
    from cocorosim_ros.diagnosis.fitting.recalibration import first_fit
    from cocorosim_ros.scenario.parts.platform import load_platform

    return first_fit(swim(load_platform("lily"), 20.0, seed=1)).tracks[0]


def slowed(track: Any, gap: float) -> Any:
    """The track as if its compass were read once in `gap` [s]."""
    stream = track.log.streams["compass"]
    slow = replace(stream, time=gap * (stream.time - stream.time[0]) / (stream.time[1] - stream.time[0]))
    return replace(track, log=replace(track.log, streams={**track.log.streams, "compass": slow}))


def late_compass(track: Any) -> tuple[Any, Any]:
    """The delay of the compass as the catalogue has it, and as it is looked for in a track."""
    from cocorosim_ros.diagnosis.against.delays import with_delays

    entry = next(each for each in ENTRIES if (each.id, each.topic) == ("sensor_latency", "compass"))
    (found,) = with_delays([entry], [track])
    return entry.amplitudes[0], found.amplitudes[0]


def test_a_stream_that_is_read_once_a_second_is_late_by_seconds(track: Any) -> None:
    """Starts lie there, and where they were before."""
    plain, found = late_compass(slowed(track, 1.0))
    assert found.large == pytest.approx(5.0)
    starts = [start * found.large for start in found.searched]
    assert max(starts) == pytest.approx(20.0)
    for start in plain.searched:
        assert min(abs(start * plain.large - each) for each in starts) < 1e-9


def test_a_quick_stream_is_looked_at_as_in_the_catalogue(track: Any) -> None:
    """But for what is believed: no less than a step of the filter."""
    plain, found = late_compass(slowed(track, 0.02))
    assert (found.large, found.searched) == (plain.large, plain.searched)
    step = track.timeline.grid.step
    assert found.negligible == (-step, step)


def test_what_is_no_delay_is_left(track: Any) -> None:
    """Entries without a search come back as they are."""
    from cocorosim_ros.diagnosis.against.delays import with_delays

    entries = [each for each in ENTRIES if not any(amplitude.searched for amplitude in each.amplitudes)]
    assert with_delays(entries, [track]) == entries
