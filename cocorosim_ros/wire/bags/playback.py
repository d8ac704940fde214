"""What a replay publishes, and when: the messages of a recording on the axis of its log times, and a clock."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from fnmatch import fnmatchcase
from typing import NamedTuple

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.wire.bags.bag_reader import Bag
from cocorosim_ros.wire.cdr.primitives import ENCAPSULATION, NANOSECONDS, pack_stamp

CLOCK_TOPIC, CLOCK_TYPE = "/clock", "rosgraph_msgs/msg/Clock"
_LAST_SECOND = 2**31 - 1


class Playing(NamedTuple):
    """One message to be published."""

    after_ns: int  # since the beginning of the span, on the axis of the log times
    topic: str
    data: bytes  # CDR


@dataclass(frozen=True)
class Span:
    """The part of a recording that is played: log times [ns], both included."""

    start_ns: int
    end_ns: int

    @property
    def seconds(self) -> float:
        """How long it is."""
        return (self.end_ns - self.start_ns) / NANOSECONDS


@dataclass(frozen=True)
class Playback:
    """The choice of what is played."""

    bag: Bag
    span: Span
    types: Mapping[str, str]  # the topics to be played, each with the type of its messages
    latched: frozenset[str] = field(default=frozenset())  # their messages before the span are played at its beginning
    clock_step_ns: int = 0  # how often a clock is made from the log times; 0: the recording has its own
    clock_in_gaps: bool = True  # made also between messages, not only with them

    def messages(self) -> Iterator[Playing]:
        """The messages in the order of their log times."""
        next_tick = self.span.start_ns
        for message in self.bag.messages(self.types, in_time_order=True):
            time_ns = message.log_time_ns
            if message.type_name != self.types[message.topic]:
                continue
            if time_ns > self.span.end_ns:
                break
            if time_ns < self.span.start_ns:
                if message.topic in self.latched:
                    yield Playing(0, message.topic, message.data)
                continue
            while self.clock_step_ns and next_tick <= time_ns:
                tick = next_tick if self.clock_in_gaps else time_ns
                yield self._tick(tick)
                next_tick = tick + self.clock_step_ns
            yield Playing(time_ns - self.span.start_ns, message.topic, message.data)

    def _tick(self, time_ns: int) -> Playing:
        seconds, nanoseconds = divmod(time_ns, NANOSECONDS)
        # After 2038 the clock of ROS stands still.
        shown = pack_stamp(min(seconds, _LAST_SECOND) * NANOSECONDS + nanoseconds)
        return Playing(time_ns - self.span.start_ns, CLOCK_TOPIC, ENCAPSULATION + shown)


def choose_span(bag: Bag, start: float | None, end: float | None) -> Span:
    """The part from `start` to `end` [s since the recording's first message]; None: from its first, to its last.

    Raises CocorosimError if nothing lies there.
    """
    summary = bag.summary
    if not summary.message_count:
        raise CocorosimError(f"{bag.path} holds no messages, so there is nothing to replay. {summary.damage}".strip())
    length = (summary.end_ns - summary.start_ns) / NANOSECONDS
    begin, stop = start or 0.0, length if end is None else end
    if not 0.0 <= begin <= min(stop, length):
        raise CocorosimError(
            f"{bag.path} is {length:g} s long, and nothing lies between --from {begin:g} and --to {stop:g}; "
            f"give seconds from 0 to {length:g}, the first of them smaller."
        )
    first_ns = summary.start_ns + round(begin * NANOSECONDS)
    last_ns = summary.end_ns if end is None else min(summary.end_ns, summary.start_ns + round(stop * NANOSECONDS))
    return Span(first_ns, last_ns)


def choose_topics(bag: Bag, patterns: Sequence[str]) -> list[str]:
    """The recorded topics that fit any of the patterns (`/lily_01/*`), all if there are none, sorted.

    Raises CocorosimError for a pattern that nothing fits.
    """
    recorded = [topic for topic, count in bag.summary.counts.items() if count]
    for pattern in patterns:
        if not _fitting(recorded, [pattern]):
            raise CocorosimError(f"{bag.path} has no topic '{pattern}'; it has {', '.join(recorded) or 'none'}.")
    return _fitting(recorded, patterns) if patterns else recorded


def _fitting(topics: Collection[str], patterns: Sequence[str]) -> list[str]:
    return [topic for topic in topics if any(fnmatchcase(topic, pattern) for pattern in patterns)]
