"""What actuators report, taken from recordings: their names, their clock, and what is left out."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.evidence.gather import gather_recording
from cocorosim_ros.diagnosis.evidence.reported import Commanded, with_reports
from cocorosim_ros.diagnosis.evidence.streams.log import RobotLog
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.parts.platform import Platform

Record = Callable[..., Path]
TOPIC = "/lily_01/actuator_feedback"


def reports(topic: type[Any], names: tuple[str, ...], *, late: float = 0.0, offset: float = 0.0) -> Any:
    """Reports every 0.2 s for 40 s; logged `late` seconds after their stamps, which are off by `offset`."""
    time = np.arange(0.0, 40.0, 0.2)
    numbers = np.column_stack([np.sin(time + place) for place in range(len(names))])
    fields = {"name": list(names), "value": [0.0] * len(names)}
    return topic(time + offset, numbers, log=time + late, names=names, extra=fields)


def test_series_by_actuator_and_quantity(
    record: Record, circle: dict[str, Any], topic: type[Any], lily_platform: Platform
) -> None:
    """At the stamps of the messages, on the clock of the commands."""
    bag = record(circle | {TOPIC: reports(topic, ("right.rotation", "left.current"))})
    log = gather_recording(bag, lily_platform).robots[0]
    assert [(each.actuator, each.quantity) for each in log.feedback] == [("left", "current"), ("right", "rotation")]
    np.testing.assert_allclose(log.feedback[1].time, np.arange(0.0, 40.0, 0.2), atol=1e-9)
    np.testing.assert_allclose(log.feedback[1].value, np.sin(np.arange(0.0, 40.0, 0.2)), atol=1e-12)


def test_all_else_stays_as_it_is(
    record: Record, circle: dict[str, Any], topic: type[Any], lily_platform: Platform
) -> None:
    """Reports that begin earlier move no stamp of the readings, and add no remark."""
    plain = gather_recording(record(circle), lily_platform)
    told = gather_recording(
        record(circle | {TOPIC: reports(topic, ("left.rotation",), offset=-0.5)}, "told"), lily_platform
    )
    assert told.remarks == plain.remarks and told.duration == plain.duration
    one, other = plain.robots[0], told.robots[0]
    assert one.feedback == () and len(other.feedback) == 1
    np.testing.assert_array_equal(one.command_time, other.command_time)
    for name, stream in one.streams.items():
        np.testing.assert_array_equal(stream.time, other.streams[name].time)
        np.testing.assert_array_equal(stream.value, other.streams[name].value)


def test_an_actuator_that_the_platform_lacks(
    record: Record, circle: dict[str, Any], topic: type[Any], lily_platform: Platform
) -> None:
    """If all are strange the names are others, and nothing could be compared; one sentence with file and way out."""
    bag = record(circle | {TOPIC: reports(topic, ("port.rotation", "rudder.angle"))})
    sentence = r"bag: /lily_01/actuator_feedback reports of the actuators port, rudder, and the platform has none of"
    with pytest.raises(CocorosimError, match=sentence) as caught:
        gather_recording(bag, lily_platform)
    assert "left, right, buoyancy; give the platform" in str(caught.value) and "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("names", "said"),
    [
        (("left.rotation", "rudder.angle"), "the platform has no actuator rudder; what it reports is not used."),
        (("left.rotation", "left.torque"), "left.torque names no quantity that is known (fraction, rotation, angle"),
    ],
)
def test_what_is_not_used_is_said(
    names: tuple[str, ...], said: str, record: Record, circle: dict[str, Any], topic: type[Any], lily_platform: Platform
) -> None:
    """Beside what is known, one strange name costs its own numbers alone."""
    recording = gather_recording(record(circle | {TOPIC: reports(topic, names)}), lily_platform)
    assert [each.actuator for each in recording.robots[0].feedback] == ["left"]
    assert any(said in remark for remark in recording.remarks)


def test_stamps_of_another_clock_tell_no_lateness(
    record: Record, circle: Mapping[str, Any], topic: type[Any], lily_platform: Platform
) -> None:
    """Stamps 30 s behind, by the log times, are left out, for by when anything follows is what is asked."""
    bag = record({**circle, TOPIC: reports(topic, ("left.rotation",), offset=-30.0)})
    recording = gather_recording(bag, lily_platform)
    assert recording.robots[0].feedback == ()
    assert any("of another clock than those of the commands" in remark for remark in recording.remarks)


def test_reports_of_another_type_are_not_read() -> None:
    """A topic of that name with the messages of somebody else is said, with the way out; the log stays as it is."""
    topics = [SimpleNamespace(topic=TOPIC, type_name="std_msgs/msg/String")]
    bag: Any = SimpleNamespace(summary=SimpleNamespace(topics=topics), messages=lambda wanted: iter(()))
    log = RobotLog("lily_01", np.zeros(1), np.zeros((1, 3)), {})
    logs, remarks = with_reports([log], bag, Commanded({}, ("left",), 0))
    assert logs[0] is log
    assert len(remarks) == 1 and "is of type std_msgs/msg/String instead of cocorosim_msgs/msg/Actuator" in remarks[0]
