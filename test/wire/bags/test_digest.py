"""Equal digests mean equal stamps and bytes, topic by topic, and nothing else."""

from __future__ import annotations

import hashlib
import re
import struct
from collections.abc import Callable
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as some
from rosbags.rosbag2 import StoragePlugin, Writer

from cocorosim_ros.wire.bags.comparison import bag_digest, difference
from cocorosim_ros.wire.bags.digest import Digest
from cocorosim_ros.wire.cdr.type_store import build, serialize, type_store

POSE = "geometry_msgs/msg/PoseStamped"
Row = tuple[str, int, int, bytes]
Rows = Callable[..., list[Row]]
Record = Callable[..., str]


EXAMPLE: list[Row] = [
    (
        f"/lily_{robot}/pose",
        tick,
        tick,
        serialize(build(POSE, {"header": {"stamp": {"sec": tick}, "frame_id": "world"}})),
    )
    for tick in range(20)
    for robot in range(2)
]


def digest_of(rows: list[Row]) -> str:
    """The digest of poses."""
    digest = Digest()
    for topic, log_time, _, data in rows:
        digest.add(topic, POSE, log_time, data)
    return digest.hexdigest()


def test_digest_is_the_sha256_that_it_says(pose_rows: Rows) -> None:
    """The digest of two messages, computed by hand from the definition."""
    first, second = pose_rows(2, 1)
    content = b""
    for row, stamp in ((first, 0), (second, 500_000_000)):
        content += struct.pack("<qQ", stamp, len(row[3])) + row[3]
    line = f"/lily_01/pose {POSE} 2 {hashlib.sha256(content).hexdigest()}"
    assert digest_of([first, second]) == hashlib.sha256(line.encode()).hexdigest()


def test_order_between_topics_and_time_of_receipt_do_not_matter(pose_rows: Rows) -> None:
    """How topics interleave and when a message arrived leave the digest as it is."""
    rows = pose_rows(20)
    later = [(topic, log_time + 7, publish_time + 7, data) for topic, log_time, publish_time, data in rows]
    assert digest_of(sorted(later, key=lambda row: row[0])) == digest_of(rows)


@given(some.integers(0, 39), some.integers(16, 83), some.integers(1, 255))
def test_every_changed_byte_changes_the_digest(index: int, place: int, change: int) -> None:
    """One byte of one message is enough, and so is a lost or doubled message."""
    rows = EXAMPLE
    data = bytearray(rows[index][3])
    data[place] ^= change
    changed = [*rows[:index], (*rows[index][:3], bytes(data)), *rows[index + 1 :]]
    variants = [rows, changed, rows[:index] + rows[index + 1 :], [*rows, rows[index]]]
    assert len({digest_of(variant) for variant in variants}) == len(variants)


def test_order_within_a_topic_matters(pose_rows: Rows) -> None:
    """Two messages of a topic in the other order are another recording."""
    rows = pose_rows(2, 1)
    assert digest_of(rows[::-1]) != digest_of(rows)


def test_name_and_type_of_a_topic_matter() -> None:
    """The same bytes under another topic or type have another digest."""
    data = serialize(build(POSE))
    keys = [("/a", POSE), ("/b", POSE), ("/a", "geometry_msgs/msg/PointStamped")]
    digests = set()
    for topic, type_name in keys:
        digest = Digest()
        digest.add(topic, type_name, 0, data)
        digests.add(digest.hexdigest())
    assert len(digests) == len(keys)


def test_log_time_stands_in_for_a_missing_stamp() -> None:
    """For a type without a stamp the log time counts."""
    digests = set()
    for log_time in (1, 2):
        digest = Digest()
        digest.add("/word", "std_msgs/msg/String", log_time, serialize(build("std_msgs/msg/String", {"data": "hi"})))
        digests.add(digest.hexdigest())
    assert len(digests) == 2


def test_topic_without_messages_does_not_count(pose_rows: Rows) -> None:
    """A channel that nobody used leaves the digest as it is."""
    digest = Digest()
    digest.topic("/silent", POSE)
    for topic, log_time, _, data in pose_rows(3):
        digest.add(topic, POSE, log_time, data)
    assert digest.hexdigest() == digest_of(pose_rows(3))


def test_same_digest_from_another_writer(tmp_path: Path, pose_rows: Rows, record: Record) -> None:
    """The same messages recorded by the independent writer have the same digest and no difference."""
    rows = pose_rows(30)
    digest = record(tmp_path / "ours", rows)
    with Writer(tmp_path / "theirs", version=9, storage_plugin=StoragePlugin.MCAP) as writer:
        connections = {
            topic: writer.add_connection(topic, POSE, typestore=type_store())
            for topic in sorted({row[0] for row in rows})
        }
        for topic, log_time, _, data in rows:
            writer.write(connections[topic], log_time, data)
    assert bag_digest(tmp_path / "theirs").hexdigest() == digest
    assert difference(tmp_path / "ours", tmp_path / "theirs") == []


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (lambda rows: [*rows[:5], (*rows[5][:3], rows[5][3][:-1] + b"\x07"), *rows[6:]],
         r"^/lily_02/pose: message 2, stamp 1000000000 ns, differs from byte 83 on"),
        (lambda rows: rows[:-1],
         r"^/lily_02/pose: \S+two ends after 9 messages; \S+one goes on .* 4500000000 ns"),
        (lambda rows: rows[2:],
         r"^/lily_01/pose: message 0 has stamp 0 ns in \S+one, 500000000 ns in \S+two"),
        (lambda rows: [row for row in rows if row[0] == "/lily_01/pose"],
         r"^/lily_02/pose: \S+two ends after 0 messages"),
    ],
)  # fmt: skip
def test_first_difference_is_said(
    change: Callable[[list[Row]], list[Row]], words: str, tmp_path: Path, pose_rows: Rows, record: Record
) -> None:
    """The sentence names the topic, the place in it and the stamp."""
    rows = pose_rows(10)
    digests = record(tmp_path / "one", rows), record(tmp_path / "two", change(rows))
    sentences = difference(tmp_path / "one", tmp_path / "two")
    assert digests[0] != digests[1]
    assert re.search(words, sentences[0]), sentences


def test_many_differing_topics_are_summed_up(tmp_path: Path, pose_rows: Rows, record: Record) -> None:
    """Five topics are told in full, the rest by name."""
    record(tmp_path / "one", pose_rows(2, 8))
    record(tmp_path / "two", pose_rows(1, 8))
    sentences = difference(tmp_path / "one", tmp_path / "two")
    assert len(sentences) == 6
    assert sentences[-1] == "3 further topics differ: /lily_06/pose, /lily_07/pose, /lily_08/pose."
