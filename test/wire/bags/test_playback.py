"""What a replay publishes, and when."""

from __future__ import annotations

import struct
from collections.abc import Callable
from pathlib import Path

import pytest

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.wire.bags.bag_reader import Bag, read_bag
from cocorosim_ros.wire.bags.playback import Playback, Playing, Span, choose_span, choose_topics

Row = tuple[str, int, int, bytes]
Rows = Callable[..., list[Row]]
Record = Callable[..., str]
POSE = "geometry_msgs/msg/PoseStamped"
TYPES = {"/lily_01/pose": POSE, "/lily_02/pose": POSE}
MS = 1_000_000


@pytest.fixture
def bag(tmp_path: Path, pose_rows: Rows, record: Record) -> Bag:
    """Two robots at 2 Hz for 4.5 s, received 1 ms after each stamp, recorded in the wrong order."""
    record(tmp_path / "bag", pose_rows(10)[::-1])
    return read_bag(tmp_path / "bag")


def test_order_and_time(bag: Bag, pose_rows: Rows) -> None:
    """Messages come by their log times, counted from the beginning of the span."""
    played = list(Playback(bag, choose_span(bag, None, None), TYPES).messages())
    assert [entry.after_ns for entry in played] == [500 * MS * (index // 2) for index in range(20)]
    assert {entry.data for entry in played} == {row[3] for row in pose_rows(10)}


def test_span_and_topics(bag: Bag) -> None:
    """Both ends of the span count; other topics are left out."""
    playback = Playback(bag, choose_span(bag, 1.0, 2.0), {"/lily_02/pose": POSE})
    assert [(entry.after_ns, entry.topic) for entry in playback.messages()] == [
        (after * 500 * MS, "/lily_02/pose") for after in range(3)
    ]


def test_latched_messages_before_the_span(bag: Bag) -> None:
    """What was latched before the beginning is played at the beginning."""
    playback = Playback(bag, choose_span(bag, 4.2, None), TYPES, latched=frozenset({"/lily_01/pose"}))
    played = [(entry.after_ns, entry.topic) for entry in playback.messages()]
    assert played[:9] == [(0, "/lily_01/pose")] * 9
    assert sorted(played[9:]) == [(300 * MS, "/lily_01/pose"), (300 * MS, "/lily_02/pose")]


def test_clock_from_the_log_times(bag: Bag) -> None:
    """A clock of 0.2 s steps from the beginning of the span on, each tick before what is not earlier."""
    playback = Playback(bag, Span(1 * MS, 1001 * MS), {"/lily_01/pose": POSE}, clock_step_ns=200 * MS)
    played = list(playback.messages())
    ticks = [entry for entry in played if entry.topic == "/clock"]
    assert [struct.unpack("<4xiI", entry.data) for entry in ticks] == [
        (0, (1 + 200 * step) * MS) for step in range(5)
    ] + [(1, 1 * MS)]
    assert [entry.after_ns for entry in played] == [after * MS for after in (0, 0, 200, 400, 500, 600, 800, 1000, 1000)]
    assert [entry.topic for entry in played[:2]] == ["/clock", "/lily_01/pose"]


def test_clock_with_the_messages_alone(bag: Bag) -> None:
    """Without ticks in gaps there is one where a message is, a step apart at least."""
    playback = Playback(bag, choose_span(bag, None, None), TYPES, clock_step_ns=700 * MS, clock_in_gaps=False)
    ticks = [entry.after_ns for entry in playback.messages() if entry.topic == "/clock"]
    assert ticks == [after * MS for after in (0, 1000, 2000, 3000, 4000)]


def test_topics_by_pattern(bag: Bag) -> None:
    """Names, wildcards, and all; a pattern that fits nothing is refused with what there is."""
    assert choose_topics(bag, []) == list(TYPES)
    assert choose_topics(bag, ["/lily_02/pose"]) == ["/lily_02/pose"]
    assert choose_topics(bag, ["/*_01/*", "/lily_02/*"]) == list(TYPES)
    with pytest.raises(CocorosimError, match=r"bag has no topic 'pose'; it has /lily_01/pose, /lily_02/pose\."):
        choose_topics(bag, ["pose"])


@pytest.mark.parametrize(("start", "end"), [(-1.0, None), (4.6, None), (3.0, 2.0), (float("nan"), None)])
def test_spans_that_hold_nothing(start: float, end: float | None, bag: Bag) -> None:
    """They are refused with the length of the recording."""
    with pytest.raises(CocorosimError, match=r"is 4\.5 s long, and nothing lies between"):
        choose_span(bag, start, end)


def test_end_beyond_the_recording(bag: Bag) -> None:
    """It means the end."""
    assert choose_span(bag, None, 1e9) == choose_span(bag, None, None) == Span(1 * MS, 4501 * MS)


def test_message_of_another_type(bag: Bag) -> None:
    """Of a topic with several types only the one that is asked for is played."""
    playback = Playback(bag, choose_span(bag, None, None), {"/lily_01/pose": "std_msgs/msg/String"})
    assert list[Playing](playback.messages()) == []
