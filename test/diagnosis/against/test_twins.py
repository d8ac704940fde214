"""Late commands and late readings of the only stream are told as one another's rivals."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.against.twins import with_twin
from cocorosim_ros.diagnosis.fitting.held_out import HeldOutGain
from cocorosim_ros.diagnosis.naming.named_effect import NamedEffect


def candidate(name: str, topic: str | None = None) -> Any:
    """A candidate for the one robot."""
    return SimpleNamespace(entry=SimpleNamespace(id=name, topic=topic), robots=("a",), everybody=(0,))


def track(*topics: str) -> Any:
    """A track with one reading in each of these streams, and a stream without any."""
    streams = {topic: SimpleNamespace(time=np.zeros(1)) for topic in topics}
    return SimpleNamespace(log=SimpleNamespace(streams={**streams, "pressure": SimpleNamespace(time=np.zeros(0))}))


CANDIDATES = [candidate("command_delay"), candidate("sensor_latency", "pose"), candidate("thruster_lag")]


@pytest.mark.parametrize(("name", "topic", "rival"), [("command_delay", None, 1), ("sensor_latency", "pose", 0)])
def test_one_stream_has_no_time_of_its_own(name: str, topic: str | None, rival: int) -> None:
    """Each delay has the other as a rival that is not behind; with a second stream it has none."""
    effect = NamedEffect(candidate(name, topic), 50.0, (), HeldOutGain(np.zeros(1), 1.0))
    (found,) = with_twin(effect, CANDIDATES, [track("pose")]).rivals
    assert (found.candidate, found.behind) == (CANDIDATES[rival], 0.0)
    assert with_twin(effect, CANDIDATES, [track("pose", "imu")]).rivals == ()


def test_a_lag_has_no_twin() -> None:
    """It blurs what a delay moves."""
    effect = NamedEffect(candidate("thruster_lag"), 50.0, (), HeldOutGain(np.zeros(1), 1.0))
    assert with_twin(effect, CANDIDATES, [track("pose")]).rivals == ()
