"""Recordings of any origin and in any state are read as far as they go, and what is missing is said."""

from __future__ import annotations

import random
import tempfile
from collections.abc import Callable
from functools import cache
from pathlib import Path

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as some
from mcap.writer import CompressionType
from mcap.writer import Writer as McapLibraryWriter
from rosbags.rosbag2 import CompressionFormat, CompressionMode, StoragePlugin, Writer

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.wire.bags import mcap_format as mcap
from cocorosim_ros.wire.bags.bag_reader import read_bag
from cocorosim_ros.wire.bags.bag_writer import BagWriter, Channel
from cocorosim_ros.wire.cdr.type_store import schema_text, type_store

POSE = "geometry_msgs/msg/PoseStamped"
Row = tuple[str, int, int, bytes]
Rows = Callable[..., list[Row]]
Record = Callable[..., str]


def read_back(path: Path, *, in_time_order: bool = False) -> list[Row]:
    """Topic, log time, publish time and bytes of all messages."""
    return [(entry[0], *entry[2:]) for entry in read_bag(path).messages(in_time_order=in_time_order)]


def write_with_rosbags(folder: Path, rows: list[Row], mode: CompressionMode) -> None:
    """Record with the independent writer, which keeps the log time alone."""
    writer = Writer(folder, version=9, storage_plugin=StoragePlugin.MCAP)
    if mode != CompressionMode.NONE:
        writer.set_compression(mode, CompressionFormat.ZSTD)
    with writer:
        topics = sorted({row[0] for row in rows})
        connections = {topic: writer.add_connection(topic, POSE, typestore=type_store()) for topic in topics}
        for topic, log_time, _, data in rows:
            writer.write(connections[topic], log_time, data)


def write_with_mcap(
    file: Path, rows: list[Row], compression: CompressionType = CompressionType.NONE, *, chunked: bool = True
) -> None:
    """Record with the writer of the MCAP project."""
    with file.open("wb") as stream:
        writer = McapLibraryWriter(stream, chunk_size=2048, compression=compression, use_chunking=chunked)
        writer.start("ros2", "test")
        schema = writer.register_schema(POSE, "ros2msg", schema_text(POSE).encode())
        channels = {topic: writer.register_channel(topic, "cdr", schema) for topic in sorted({row[0] for row in rows})}
        for topic, log_time, publish_time, data in rows:
            writer.add_message(channels[topic], log_time, data, publish_time)
        writer.finish()


@pytest.mark.parametrize("mode", CompressionMode, ids=lambda mode: mode.name)
def test_bags_of_rosbags_are_read(mode: CompressionMode, tmp_path: Path, pose_rows: Rows) -> None:
    """A bag by the independent writer is read in each of its compression modes."""
    rows = pose_rows(40)
    write_with_rosbags(tmp_path / "bag", rows, mode)
    bag = read_bag(tmp_path / "bag")
    assert [(entry.topic, entry.log_time_ns, entry.data) for entry in bag.messages()] == [
        (topic, log_time, data) for topic, log_time, _, data in rows
    ]
    assert bag.summary.complete
    assert bag.summary.types == {"/lily_01/pose": POSE, "/lily_02/pose": POSE}


@pytest.mark.parametrize("compression", CompressionType, ids=lambda compression: compression.name)
@pytest.mark.parametrize("chunked", [True, False])
def test_files_of_the_mcap_project_are_read(
    compression: CompressionType, chunked: bool, tmp_path: Path, pose_rows: Rows
) -> None:
    """A bare file is read with chunks of each compression and without chunks."""
    rows = pose_rows(60)
    write_with_mcap(tmp_path / "bare.mcap", rows, compression, chunked=chunked)
    assert read_back(tmp_path / "bare.mcap") == rows
    assert read_bag(tmp_path / "bare.mcap").summary.complete


def test_only_wanted_topics(tmp_path: Path, pose_rows: Rows, record: Record) -> None:
    """Messages can be asked for by topic; a topic that is not there gives none."""
    rows = pose_rows(5)
    record(tmp_path / "bag", rows)
    bag = read_bag(tmp_path / "bag")
    assert [entry.data for entry in bag.messages(["/lily_02/pose", "/none"])] == [
        row[3] for row in rows if row[0] == "/lily_02/pose"
    ]


@given(some.lists(some.tuples(some.integers(0, 20), some.integers(0, 5)), max_size=60), some.integers(60, 2000))
@settings(max_examples=40, deadline=None)
def test_any_order_and_duplicates(entries: list[tuple[int, int]], chunk_bytes: int) -> None:
    """Out-of-order and doubled messages are all read; sorted, those of equal time stay as recorded."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "bag")
        with BagWriter(path, [Channel("/a", "std_msgs/msg/UInt8")], chunk_bytes=chunk_bytes) as bag:
            for time, value in entries:
                bag.write("/a", time, time, b"\x00\x01\x00\x00" + bytes([value]))
        assert [(row[1], row[3][-1]) for row in read_back(path)] == entries
        in_order = [(row[1], row[3][-1]) for row in read_back(path, in_time_order=True)]
        assert in_order == sorted(entries, key=lambda entry: entry[0])


def test_several_files_in_order_of_time(tmp_path: Path, pose_rows: Rows) -> None:
    """A recording split into files is read in their order of time, whatever their names say."""
    rows = pose_rows(30)
    (tmp_path / "bag").mkdir()
    write_with_mcap(tmp_path / "bag" / "bag_9.mcap", rows[:20])
    write_with_mcap(tmp_path / "bag" / "bag_10.mcap", rows[20:50])
    write_with_mcap(tmp_path / "bag" / "bag_0.mcap", rows[50:])
    assert read_back(tmp_path / "bag") == rows
    assert read_back(tmp_path / "bag", in_time_order=True) == rows
    assert read_bag(tmp_path / "bag").summary.counts == {"/lily_01/pose": 30, "/lily_02/pose": 30}


def chunk_ends(file: Path) -> list[tuple[int, int]]:
    """Where each chunk record of a file ends, and how many messages were recorded until then."""
    data, place, ends, messages = file.read_bytes(), 8, [], 0
    while place < len(data) - 8:
        opcode, length = mcap.RECORD_HEAD.unpack_from(data, place)
        place += 9 + length
        if opcode == mcap.CHUNK:
            ends.append([place, messages])
        if opcode == mcap.MESSAGE_INDEX:
            entries = int.from_bytes(data[place - length + 2 : place - length + 6], "little") // 16
            messages += entries
            ends[-1][1] = messages
    return [(end, count) for end, count in ends]


def test_file_cut_off_anywhere(tmp_path: Path, pose_rows: Rows, record: Record) -> None:
    """Cut at any byte, a file gives just the messages of its whole chunks, and says: not closed."""
    rows = pose_rows(60)
    record(tmp_path / "bag", rows, chunk_bytes=1500)
    data = (tmp_path / "bag" / "bag_0.mcap").read_bytes()
    ends = chunk_ends(tmp_path / "bag" / "bag_0.mcap")
    assert len(ends) > 5 and ends[-1][1] == len(rows)
    borders = {end + shift for end, _ in ends for shift in (-1, 0, 1, 9)}
    places = sorted(borders | set(random.Random(2).sample(range(9, len(data)), 150)) | {len(data) - 1})
    for place in places:
        cut = tmp_path / "cut.mcap"
        cut.write_bytes(data[:place])
        whole = max((count for end, count in ends if end <= place), default=0)
        bag = read_bag(cut)
        assert [(entry[0], *entry[2:]) for entry in bag.messages()] == rows[:whole], place
        until = f" until t = {rows[whole - 1][1] / 1e9:.3f} s" if whole else ""
        messages = "1 message" if whole == 1 else f"{whole} messages"
        sentence = f"{cut} was not closed: read up to its last whole chunk, {messages}{until}."
        assert bag.summary.damage == sentence
        cut.unlink()


def test_unchunked_file_cut_off(tmp_path: Path, pose_rows: Rows) -> None:
    """Without chunks every whole message before the cut is read."""
    rows = pose_rows(50)
    write_with_mcap(tmp_path / "whole.mcap", rows, chunked=False)
    data = (tmp_path / "whole.mcap").read_bytes()
    starts = [data.index(row[3]) for row in rows]
    cut = tmp_path / "cut.mcap"
    for place in [starts[0] - 1, starts[0] + len(rows[0][3]), starts[20] + 5, starts[-1] + 1]:
        cut.write_bytes(data[:place])
        whole = sum(start + len(row[3]) <= place for start, row in zip(starts, rows, strict=True))
        assert read_back(cut) == rows[:whole]
        cut.unlink()


def test_file_that_ends_in_zeros(tmp_path: Path, pose_rows: Rows, record: Record) -> None:
    """After a power cut the end of a file may be zeros; what stands before them is read."""
    rows = pose_rows(60)
    record(tmp_path / "bag", rows, chunk_bytes=1500)
    file = tmp_path / "bag" / "bag_0.mcap"
    end, whole = chunk_ends(file)[3]
    file.write_bytes(file.read_bytes()[:end] + bytes(5000))
    assert read_back(tmp_path / "bag") == rows[:whole]
    assert not read_bag(tmp_path / "bag").summary.complete


def test_damaged_chunk_is_left_out_and_said(tmp_path: Path, pose_rows: Rows, record: Record) -> None:
    """A chunk with a wrong byte is left out, the others are read, and the sentence says where it is."""
    rows = pose_rows(60)
    record(tmp_path / "bag", rows, chunk_bytes=1500)
    file = tmp_path / "bag" / "bag_0.mcap"
    ends = chunk_ends(file)
    data = bytearray(file.read_bytes())
    data[ends[2][0] - 5] ^= 0xFF
    file.write_bytes(data)
    bag = read_bag(tmp_path / "bag")
    assert read_back(tmp_path / "bag") == rows[: ends[1][1]] + rows[ends[2][1] :]
    assert bag.summary.message_count == len(rows) - (ends[2][1] - ends[1][1])
    assert "is damaged" in bag.summary.damage and "left out" in bag.summary.damage


def test_a_damaged_first_chunk_costs_its_own_messages_alone(tmp_path: Path, pose_rows: Rows, record: Record) -> None:
    """The first chunk defines all channels; the summary repeats them, so the others are read after one flipped bit."""
    rows = pose_rows(60)
    record(tmp_path / "bag", rows, chunk_bytes=1500)
    file = tmp_path / "bag" / "bag_0.mcap"
    end, lost = chunk_ends(file)[0]
    data = bytearray(file.read_bytes())
    data[end - 5] ^= 0x04
    file.write_bytes(data)
    bag = read_bag(tmp_path / "bag")
    assert read_back(tmp_path / "bag") == rows[lost:]
    assert bag.summary.message_count == len(rows) - lost
    assert bag.summary.types == {"/lily_01/pose": POSE, "/lily_02/pose": POSE}
    assert bag.summary.damage.count("is damaged") == 1


@given(some.lists(some.tuples(some.integers(0), some.integers(0, 255)), min_size=1, max_size=4))
@example([(106, 128)])  # a chunk that says it holds 2 ** 63 bytes
@settings(max_examples=80, deadline=None)
def test_no_damage_escapes_as_another_error(changes: list[tuple[int, int]]) -> None:
    """With any bytes changed, a file is read in part or refused in a sentence; what is read was recorded."""
    rows, whole = small_recording()
    changed = bytearray(whole)
    for place, value in changes:
        changed[place % len(changed)] = value
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "changed.mcap").write_bytes(changed)
        try:
            read = [row[3] for row in read_back(Path(folder, "changed.mcap"))]
        except CocorosimError:
            return
    recorded = {row[3] for row in rows}
    assert all(entry in recorded for entry in read)


@cache
def small_recording() -> tuple[list[Row], bytes]:
    """Messages and the bytes of a file that holds them."""
    rows = [("/a", time, time, b"\x00\x01\x00\x00" + bytes([time])) for time in range(200)]
    with tempfile.TemporaryDirectory() as folder:
        with BagWriter(Path(folder, "bag"), [Channel("/a", "std_msgs/msg/UInt8")], chunk_bytes=1000) as bag:
            for row in rows:
                bag.write(*row)
        return rows, Path(folder, "bag", "bag_0.mcap").read_bytes()


def test_one_unreadable_file_of_several(tmp_path: Path, pose_rows: Rows) -> None:
    """When one file of a split recording is empty, the others are read and the sentence names it."""
    rows = pose_rows(10)
    (tmp_path / "bag").mkdir()
    write_with_mcap(tmp_path / "bag" / "bag_0.mcap", rows)
    (tmp_path / "bag" / "bag_1.mcap").touch()
    assert read_back(tmp_path / "bag") == rows
    assert "bag_1.mcap is empty" in read_bag(tmp_path / "bag").summary.damage


def test_file_that_metadata_names_but_is_gone(tmp_path: Path, pose_rows: Rows, record: Record) -> None:
    """A missing file is said; without any file there is nothing to read."""
    record(tmp_path / "bag", pose_rows(3))
    (tmp_path / "bag" / "bag_0.mcap").unlink()
    with pytest.raises(CocorosimError, match=r"bag_0\.mcap cannot be read: No such file"):
        read_bag(tmp_path / "bag")


def test_folder_without_metadata_yaml(tmp_path: Path, pose_rows: Rows, record: Record) -> None:
    """A closed file is complete also where metadata.yaml was lost."""
    rows = pose_rows(3)
    record(tmp_path / "bag", rows)
    (tmp_path / "bag" / "metadata.yaml").unlink()
    assert read_back(tmp_path / "bag") == rows
    assert read_bag(tmp_path / "bag").summary.complete


@pytest.mark.parametrize("text", ["", "just words", "a: [", "rosbag2_bagfile_information: {}", "\x00"])
def test_metadata_yaml_of_something_else(text: str, tmp_path: Path, pose_rows: Rows, record: Record) -> None:
    """A metadata.yaml that makes no sense is said, with the way around it."""
    record(tmp_path / "bag", pose_rows(3))
    (tmp_path / "bag" / "metadata.yaml").write_text(text)
    with pytest.raises(CocorosimError, match=r"metadata\.yaml.*give the \.mcap file itself"):
        read_bag(tmp_path / "bag")


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b"", "is empty"),
        (b"\x89MCA", "ends after 4 bytes"),
        (b"PK\x03\x04 a zip file", "is not an MCAP file"),
        (b"\x00" * 100, "is not an MCAP file"),
    ],
)
def test_files_that_are_no_recording(content: bytes, words: str, tmp_path: Path) -> None:
    """Empty and foreign files are refused in a sentence that names them."""
    (tmp_path / "thing.mcap").write_bytes(content)
    with pytest.raises(CocorosimError, match=rf"thing\.mcap {words}"):
        read_bag(tmp_path / "thing.mcap")


def test_places_without_a_recording(tmp_path: Path) -> None:
    """A missing path and a folder without recordings are said."""
    with pytest.raises(CocorosimError, match="does not exist"):
        read_bag(tmp_path / "nowhere")
    (tmp_path / "holiday.jpg").touch()
    with pytest.raises(CocorosimError, match=r"holds no \.mcap file"):
        read_bag(tmp_path)


@pytest.mark.parametrize("keep_metadata", [True, False])
def test_sqlite_recording(keep_metadata: bool, tmp_path: Path) -> None:
    """A recording in SQLite storage is refused with the command that converts it."""
    with Writer(tmp_path / "bag", version=9) as writer:
        writer.add_connection("/a/pose", POSE, typestore=type_store())
    if not keep_metadata:
        (tmp_path / "bag" / "metadata.yaml").unlink()
    for path in (tmp_path / "bag", tmp_path / "bag" / "bag.db3"):
        with pytest.raises(CocorosimError, match="rosbags-convert"):
            read_bag(path)
