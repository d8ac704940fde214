"""Under which tick the recorder writes the commands of an external controller that come late, or without a stamp."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Mapping
from typing import cast

import pytest
from rclpy.node import Node

from cocorosim_ros.graph.nodes import tick_recorder
from cocorosim_ros.graph.nodes.tick_recorder import MISSING, TickRecorder
from cocorosim_ros.graph.runs.run_record import STATUS_TOPIC, RunRecord
from cocorosim_ros.wire.cdr.primitives import ENCAPSULATION, pack_stamp
from cocorosim_ros.wire.cdr.status import WARN, status_bytes

TICK = 500_000_000  # ns
COMMAND = "/mule_0/thruster_command"
POSE = "/mule_0/pose"
Say = Callable[..., None]


class Stream:
    """Stands for a subscription: what was put into it is taken in order."""

    def __init__(self, _: Node, type_name: str, topic: str, __: object) -> None:
        self.type_name, self.topic = type_name, topic
        self.publishers = 1
        self.waiting: deque[bytes] = deque()

    def take(self) -> bytes | None:
        """The next message, or None."""
        return self.waiting.popleft() if self.waiting else None


class Mouth:
    """Stands for the way back to the physics node."""

    is_heard = True

    def __init__(self, _: Node) -> None:
        self.said: list[int] = []

    def say(self, ticks: int) -> None:
        """Keep what was said."""
        self.said.append(ticks)


class Record:
    """Stands for the bag: topic and stamp of all that is written, in order."""

    def __init__(self) -> None:
        rows = ("/clock", "/tf", POSE, COMMAND, STATUS_TOPIC)
        self.topics = {topic: topic.removeprefix("/mule_0/") for topic in rows}
        self.owed = {"/clock", "/tf", POSE, COMMAND}
        self.written: list[tuple[str, int]] = []

    def write(self, topic: str, stamp_ns: int, _: bytes) -> None:
        """One message beside the ticks."""
        self.written.append((topic, stamp_ns))

    def write_tick(self, stamp_ns: int, messages: Mapping[str, bytes]) -> dict[str, bytes]:
        """The messages of a whole tick."""
        self.written += [(topic, stamp_ns) for topic in messages]
        return {}

    @property
    def commands(self) -> list[int]:
        """Stamps under which commands were written."""
        return [stamp for topic, stamp in self.written if topic == COMMAND]


@pytest.fixture
def record() -> Record:
    """What is written."""
    return Record()


@pytest.fixture
def recorder(record: Record, monkeypatch: pytest.MonkeyPatch) -> TickRecorder:
    """The recorder of a run whose one robot has an external controller."""
    monkeypatch.setattr(tick_recorder, "Listener", Stream)
    monkeypatch.setattr(tick_recorder, "RecorderMouth", Mouth)
    monkeypatch.setattr(tick_recorder, "speakers_of_recorder", lambda _: {})
    return TickRecorder([cast(Node, None)], cast(RunRecord, record), ["mule_0"])


@pytest.fixture
def say(recorder: TickRecorder) -> Say:
    """Function of topics and a stamp [ns]: the recorder gets a message of that stamp on each topic."""

    def bring(*topics: str, stamp: int) -> None:
        for topic in topics:
            stream = cast(Stream, recorder._listeners[topic])
            stream.waiting.append(ENCAPSULATION + pack_stamp(stamp) + bytes(8))
        recorder.drain()

    return bring


def test_an_answer_of_the_first_tick_may_come_while_that_tick_is_not_whole(record: Record, say: Say) -> None:
    """The recorder has heard the clock of later ticks, and still the command belongs to tick zero."""
    say("/clock", POSE, stamp=0)
    say("/clock", stamp=TICK)
    say(COMMAND, stamp=0)
    say("/tf", stamp=0)
    assert record.commands == [0]


def test_an_answer_of_the_first_tick_may_come_after_that_tick(record: Record, recorder: TickRecorder, say: Say) -> None:
    """It is written under tick zero, and is not said to be absent."""
    say("/clock", "/tf", POSE, stamp=0)
    say("/clock", stamp=TICK)
    assert recorder.unheard_commands() == {"mule_0": 1}
    say(COMMAND, stamp=0)
    assert record.commands == [0]
    assert recorder.unheard_commands() == {}


@pytest.mark.parametrize("first_is_written", [True, False])
def test_a_command_without_a_stamp_belongs_to_the_newest_tick(
    record: Record, recorder: TickRecorder, say: Say, *, first_is_written: bool
) -> None:
    """As soon as tick zero has its answer, zero in the stamp says nothing; what is absent is then not known."""
    say("/clock", POSE, COMMAND, stamp=0)
    if first_is_written:
        say("/tf", stamp=0)
    say("/clock", stamp=TICK)
    say(COMMAND, stamp=0)
    say("/clock", stamp=2 * TICK)
    say(COMMAND, stamp=0)
    assert [stamp for stamp in record.commands if stamp] == [TICK, 2 * TICK]
    assert recorder.unheard_commands() == {}


@pytest.mark.parametrize("first_is_written", [True, False])
def test_no_command_answers_a_first_tick_that_was_given_up(
    record: Record, recorder: TickRecorder, say: Say, *, first_is_written: bool
) -> None:
    """The physics node has said that tick zero has no answer: what comes later without a stamp is of a later tick."""
    cast(Stream, recorder._listeners[STATUS_TOPIC]).waiting.append(
        status_bytes(0, WARN, "mule_0", "no answer", {MISSING: "mule_0"})
    )
    say("/clock", POSE, stamp=0)
    if first_is_written:
        say("/tf", stamp=0)
    say("/clock", stamp=TICK)
    say(COMMAND, stamp=0)
    assert record.commands == [TICK]
