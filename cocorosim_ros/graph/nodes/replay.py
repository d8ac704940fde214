"""Publishes a recording on its topics again: the recorded bytes, types and offers, and a clock."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

from rclpy.node import Node

from cocorosim_ros.graph.nodes.wiring import Speaker
from cocorosim_ros.graph.runs.run_record import MADE_BY_RECORDER
from cocorosim_ros.wire.bags.bag_reader import Bag
from cocorosim_ros.wire.bags.bag_summary import RecordedTopic
from cocorosim_ros.wire.bags.offered_quality import offered_quality
from cocorosim_ros.wire.bags.playback import CLOCK_TOPIC, CLOCK_TYPE, Playback, Playing, Span
from cocorosim_ros.wire.cdr.primitives import NANOSECONDS
from cocorosim_ros.wire.cdr.type_store import is_known, type_hash
from cocorosim_ros.wire.live.viewers import Viewers
from cocorosim_ros.wire.topics.service_quality import CLOCK, ServiceQuality

CLOCK_RATE = 40  # Hz of wall clock, of a clock that the recording does not have; with fast pace of recorded time
LEAST_DEPTH = 1000  # messages that a publisher keeps until they are acknowledged
MOST_IN_FLIGHT = 2000  # messages of all topics together that a fast replay has out without acknowledgement
SETTLED = 0.5  # s without a new subscription after which discovery counts as over
LAST_WORDS = 10.0  # s that subscribers get to receive the end of a replay in time
LONGEST_NAP = 0.1  # s; signals are looked at in between
SHOWN_EVERY = 256  # messages


@dataclass(frozen=True)
class Pace:
    """How fast, how often, for whom."""

    rate: float = 1.0  # seconds of recording per second of wall clock; 0: as fast as subscribers acknowledge
    loop: bool = False
    subscriptions: int = 0  # to wait for before the first message
    reliable: bool = False  # offer every topic reliably, whatever was recorded

    @property
    def clock_step_ns(self) -> int:
        """How often a clock is made, on the axis of the recording."""
        return max(1, round((self.rate or 1.0) * NANOSECONDS / CLOCK_RATE))


@dataclass
class Position:
    """How far a replay is."""

    after_ns: int = 0  # on the axis of the log times, since the beginning of the span
    messages: int = 0
    rounds: int = 0  # that are over, while another one is being played
    late: float = 0.0  # s; the most by which a message was behind its time
    held_up: bool = False  # a subscriber does not keep up, and is waited for


class Replay:
    """One replay, which ends within a fraction of a second when `stop` is set from outside."""

    def __init__(
        self, node: Node, bag: Bag, topics: list[str], span: Span, pace: Pace, viewers: Viewers | None = None
    ) -> None:
        """`viewers` are sent every message that is published."""
        self.stop = False
        self.position = Position()
        self.left_out: list[str] = []  # sentences: which topics are not published, and why
        self._node = node
        self._viewers = viewers
        self._pace = pace
        self._show: Callable[[Position], None] = lambda position: None
        self._speakers: dict[str, Speaker] = {}
        self._in_flight: dict[str, int] = {}
        self._all_in_flight = 0
        self._limits: dict[str, int] = {}
        recorded = self._one_type_each(bag.summary.topics)
        has_clock = CLOCK_TOPIC in recorded and recorded[CLOCK_TOPIC].type_name == CLOCK_TYPE
        for topic in sorted({*topics, CLOCK_TOPIC} if has_clock else {*topics} - {CLOCK_TOPIC}):
            self._open(recorded[topic])
        latched = frozenset(topic for topic, entry in recorded.items() if _offer(entry, pace).durability != "volatile")
        step = 0 if has_clock else pace.clock_step_ns
        self.makes_clock = not has_clock
        types = {topic: speaker.type_name for topic, speaker in self._speakers.items()}
        self._latched = latched
        self._playback = Playback(bag, span, types, latched, step, pace.rate > 0.0)
        if self.makes_clock:
            self._speak_on(CLOCK_TOPIC, CLOCK_TYPE, CLOCK)

    @property
    def topics(self) -> list[str]:
        """The topics that are published."""
        return sorted(self._speakers)

    @property
    def subscriptions(self) -> int:
        """How many subscriptions the topics have by now."""
        return sum(speaker.subscribers for speaker in self._speakers.values())

    def wait_for_subscriptions(self, show: Callable[[int], None] = lambda count: None) -> None:
        """Return when as many subscriptions as asked for are there and no more are coming."""
        known, since = -1, time.monotonic()
        while not self.stop and (known < self._pace.subscriptions or time.monotonic() - since < SETTLED):
            count = self.subscriptions
            if count != known:
                known, since = count, time.monotonic()
                show(count)
            time.sleep(0.02)

    def run(self, show: Callable[[Position], None] = lambda position: None) -> None:
        """Publish everything; `show` is called a few times a second."""
        self._show = show
        begin = time.monotonic()
        while self._play_round(begin) and self._pace.loop:
            self.position.rounds += 1
            if self._pace.rate:
                begin += self._playback.span.seconds / self._pace.rate
        self._wait_for_acknowledgements(time.monotonic() + LAST_WORDS if self._pace.rate else None)

    def _play_round(self, begin: float) -> bool:
        """Play the span once, from `begin` on; False if that was ended from outside."""
        for message in self._playback.messages():
            self._wait_until(begin, message.after_ns)
            if self.stop:
                return False
            self._publish(message)
        return True

    def _one_type_each(self, entries: Sequence[RecordedTopic]) -> dict[str, RecordedTopic]:
        """The recorded topics; of one that was recorded with several types the type with the most messages."""
        chosen: dict[str, RecordedTopic] = {}
        for entry in sorted(entries, key=lambda entry: -entry.count):
            if entry.topic in chosen:
                self.left_out.append(
                    f"{entry.count} messages of {entry.topic} are not published: their type is {entry.type_name}, "
                    f"that of the others {chosen[entry.topic].type_name}."
                )
            elif entry.count:
                chosen[entry.topic] = entry
        return chosen

    def _open(self, recorded: RecordedTopic) -> None:
        """Publish this topic, or say why not."""
        reason = _unusable(recorded)
        try:
            if not reason:
                self._speak_on(recorded.topic, recorded.type_name, _offer(recorded, self._pace), recorded.schema)
        except (ImportError, AttributeError):
            reason = f"its type {recorded.type_name} is not installed here"
        except (ValueError, RuntimeError) as error:
            reason = str(error).partition(", at ")[0]
        if reason:
            self.left_out.append(f"{recorded.topic} is not published: {reason}.")

    def _speak_on(self, topic: str, type_name: str, offer: ServiceQuality, schema: str = "") -> None:
        # How many messages a volatile publisher keeps is nobody's business but its own.
        depth = max(offer.depth, LEAST_DEPTH) if offer.durability == "volatile" else offer.depth
        self._speakers[topic] = Speaker(self._node, type_name, topic, replace(offer, depth=depth))
        if self._viewers is not None:
            self._viewers.add(topic, type_name, schema)
        self._in_flight[topic] = 0
        self._limits[topic] = max(1, depth // 4)

    def _wait_until(self, begin: float, after_ns: int) -> None:
        """Sleep until a message is due. Moments are absolute, so that nothing adds up."""
        self.position.after_ns = after_ns
        if not self._pace.rate:
            return
        due = begin + after_ns / NANOSECONDS / self._pace.rate
        while not self.stop and (left := due - time.monotonic()) > 0.0:
            self._show(self.position)
            time.sleep(min(left, LONGEST_NAP))
        self.position.late = max(self.position.late, time.monotonic() - due)

    def _publish(self, message: Playing) -> None:
        topic = message.topic
        if topic in MADE_BY_RECORDER and self._node.count_publishers(topic) > 1:
            return  # a metrics node measures the replay
        self._speakers[topic].publish(message.data)
        if self._viewers is not None:
            moment = self._playback.span.start_ns + message.after_ns
            self._viewers.send(topic, moment, message.data, latched=topic in self._latched)
        self.position.messages += 1
        if self.position.messages % SHOWN_EVERY == 0:
            self._show(self.position)
        if not self._pace.rate:
            self._in_flight[topic] += 1
            self._all_in_flight += 1
            if self._in_flight[topic] >= self._limits[topic] or self._all_in_flight >= MOST_IN_FLIGHT:
                self._wait_for_acknowledgements(None)

    def _wait_for_acknowledgements(self, deadline: float | None) -> None:
        """Return when every reliable subscription has received everything, or at the deadline."""
        for topic, speaker in self._speakers.items():
            while not self.stop and not speaker.all_received():
                if deadline is not None and time.monotonic() > deadline:
                    return
                self.position.held_up = True
                self._show(self.position)
            self._in_flight[topic] = 0
        self._all_in_flight = 0
        self.position.held_up = False
        self._show(self.position)


def _unusable(recorded: RecordedTopic) -> str:
    """Why messages of this topic cannot be published here; empty if they can."""
    known = is_known(recorded.type_name)
    if known and recorded.type_hash and recorded.type_hash != type_hash(recorded.type_name):
        return f"its type {recorded.type_name} had another definition when it was recorded"
    if recorded.type_name.count("/") != 2:
        return f"its type '{recorded.type_name}' is not written as package/msg/Type"
    return ""


def _offer(recorded: RecordedTopic, pace: Pace) -> ServiceQuality:
    offer = offered_quality(recorded.offered_qos_profiles)
    return replace(offer, reliability="reliable") if pace.reliable else offer
