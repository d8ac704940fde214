"""The digest of a bag, and where two bags differ, in sentences."""

from __future__ import annotations

from itertools import zip_longest
from pathlib import Path

from cocorosim_ros.wire.bags.bag_reader import Bag, RecordedMessage, read_bag
from cocorosim_ros.wire.bags.digest import Digest
from cocorosim_ros.wire.cdr.stamps import stamp_ns

TOPICS_IN_DETAIL = 5


def bag_digest(bag: Bag | Path | str) -> Digest:
    """The digest of what a bag holds; the same as its writer made of the same messages."""
    opened = _opened(bag)
    digest = Digest()
    adders = {
        (topic.topic, topic.type_name): digest.topic(topic.topic, topic.type_name, topic.schema).add
        for topic in opened.summary.topics
    }
    for message in opened.messages():
        adders[message.topic, message.type_name](message.log_time_ns, message.data)
    return digest


def difference(first: Bag | Path | str, second: Bag | Path | str) -> list[str]:
    """One sentence per difference between two bags, topic by topic: none if their digests are equal."""
    one, other = _opened(first), _opened(second)
    lines = [set(bag_digest(bag).lines()) for bag in (one, other)]
    topics = sorted({line.split(" ", 1)[0] for line in lines[0] ^ lines[1]})
    sentences = [_first_difference(one, other, topic) for topic in topics[:TOPICS_IN_DETAIL]]
    if len(topics) > TOPICS_IN_DETAIL:
        sentences.append(
            f"{len(topics) - TOPICS_IN_DETAIL} further topics differ: {', '.join(topics[TOPICS_IN_DETAIL:])}."
        )
    return sentences


def _opened(bag: Bag | Path | str) -> Bag:
    return bag if isinstance(bag, Bag) else read_bag(bag)


def _first_difference(one: Bag, other: Bag, topic: str) -> str:
    pairs = zip_longest(one.messages([topic]), other.messages([topic]))
    for index, (left, right) in enumerate(pairs):
        if left is None or right is None:
            shorter, longer, message = (one, other, right) if left is None else (other, one, left)
            return (
                f"{topic}: {shorter.path} ends after {index} messages; {longer.path} goes on with the one "
                f"of stamp "
                f"{_stamp(longer, message)} ns."
            )
        if left.type_name != right.type_name:
            types = f"{left.type_name} in {one.path}, a {right.type_name} in {other.path}"
            return f"{topic}: message {index} is a {types}."
        stamps = _stamp(one, left), _stamp(other, right)
        if stamps[0] != stamps[1]:
            found = f"{stamps[0]} ns in {one.path}, {stamps[1]} ns in {other.path}"
            return f"{topic}: message {index} has stamp {found}."
        if left.data != right.data:
            place = f"differs from byte {_first_byte(left.data, right.data)} on"
            sizes = f"{len(left.data)} bytes in {one.path}, {len(right.data)} in {other.path}"
            return f"{topic}: message {index}, stamp {stamps[0]} ns, {place} ({sizes})."
    return f"{topic}: the same messages under different types."


def _stamp(bag: Bag, message: RecordedMessage) -> int:
    schemas = {(topic.topic, topic.type_name): topic.schema for topic in bag.summary.topics}
    stamp = stamp_ns(message.type_name, message.data, schemas[message.topic, message.type_name])
    return message.log_time_ns if stamp is None else stamp


def _first_byte(one: bytes, other: bytes) -> int:
    differing = (index for index, pair in enumerate(zip(one, other, strict=False)) if pair[0] != pair[1])
    return next(differing, min(len(one), len(other)))
