"""What a recording holds, and in one sentence what is missing from it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from cocorosim_ros.foundation.counted import counted
from cocorosim_ros.wire.bags.mcap_file import Contents

METADATA_NAME = "cocorosim"  # of the record that says what a recording was made from
METADATA_AT_BEGIN = "cocorosim_begun"  # of the same, written before the first message, without the digest


@dataclass(frozen=True)
class RecordedTopic:
    """One topic of a recording."""

    topic: str
    type_name: str
    count: int
    schema: str  # text of the type, as recorded
    schema_encoding: str  # ros2msg | ros2idl
    type_hash: str
    offered_qos_profiles: str  # YAML, as recorded


@dataclass(frozen=True)
class BagSummary:
    """What a recording holds. Times are log times [ns], zero for an empty recording."""

    topics: tuple[RecordedTopic, ...]  # sorted by topic and type
    message_count: int
    start_ns: int
    end_ns: int
    metadata: dict[str, dict[str, str]]  # by record name: "cocorosim" has scenario, seed, versions, digest
    damage: str  # what is missing, in one sentence; empty if nothing is

    @property
    def complete(self) -> bool:
        """Whether the recording was closed and nothing in it is damaged."""
        return not self.damage

    @property
    def types(self) -> dict[str, str]:
        """Type by topic."""
        return {topic.topic: topic.type_name for topic in self.topics}

    @property
    def counts(self) -> dict[str, int]:
        """Number of messages by topic."""
        names = {topic.topic for topic in self.topics}
        return {name: sum(topic.count for topic in self.topics if topic.topic == name) for name in sorted(names)}


def summarize(path: Path, files: Sequence[Contents], problems: Sequence[str]) -> BagSummary:
    """The summary of a recording from the contents of its files and what else is wrong with it."""
    topics: dict[tuple[str, str], RecordedTopic] = {}
    metadata: dict[str, dict[str, str]] = {}
    for contents in files:
        for entry in _topics_of(contents):
            key = (entry.topic, entry.type_name)
            known = topics.get(key)
            topics[key] = replace(known, count=known.count + entry.count) if known else entry
        for name, values in contents.metadata.items():
            metadata.setdefault(METADATA_NAME if name == METADATA_AT_BEGIN else name, {}).update(values)
    count = sum(contents.message_count for contents in files)
    start_ns = min((contents.start_ns for contents in files if contents.message_count), default=0)
    end_ns = max((contents.end_ns for contents in files if contents.message_count), default=0)
    damage = _damage(path, files, problems, count, end_ns)
    return BagSummary(tuple(topics[key] for key in sorted(topics)), count, start_ns, end_ns, metadata, damage)


def _topics_of(contents: Contents) -> list[RecordedTopic]:
    return [
        RecordedTopic(
            channel.topic,
            channel.type_name,
            contents.counts.get(number, 0),
            channel.schema,
            channel.schema_encoding,
            channel.metadata.get("topic_type_hash", ""),
            channel.metadata.get("offered_qos_profiles", ""),
        )
        for number, channel in contents.channels.items()
    ]


def _damage(path: Path, files: Sequence[Contents], problems: Sequence[str], count: int, end_ns: int) -> str:
    parts = list(problems)
    if not all(contents.closed for contents in files):
        until = f" until t = {end_ns / 1e9:.3f} s" if count else ""
        goes_on = any(contents.being_written for contents in files)
        state = "is still being recorded" if goes_on else "was not closed"
        parts.append(f"{path} {state}: read up to its last whole chunk, {counted(count, 'message')}{until}")
    parts.extend(f"in {path} {damage}" for contents in files for damage in contents.damage)
    return "; ".join(parts) + "." if parts else ""
