"""What is written is a rosbag2 recording that independent readers open, whatever happens on the way."""

from __future__ import annotations

import io
import os
import signal
import subprocess
import sys
import textwrap
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from mcap.reader import make_reader
from mcap_ros2.decoder import DecoderFactory
from rosbags.rosbag2 import Reader
from ruamel.yaml import YAML

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.wire.bags.bag_reader import read_bag
from cocorosim_ros.wire.bags.bag_writer import BagWriter, Channel
from cocorosim_ros.wire.bags.comparison import bag_digest
from cocorosim_ros.wire.cdr.type_store import build, schema_text, serialize, type_hash

POSE = "geometry_msgs/msg/PoseStamped"
Rows = Callable[..., list[tuple[str, int, int, bytes]]]
Record = Callable[..., str]


def read_back(folder: Path) -> list[tuple[str, int, int, bytes]]:
    """Messages by our own reader, as they were given to the writer."""
    return [(entry[0], *entry[2:]) for entry in read_bag(folder).messages()]


def child(text: str, folder: Path, *arguments: str) -> list[str]:
    """The command of a Python process that runs a text with this folder."""
    return [sys.executable, "-c", textwrap.dedent(text), str(folder), *arguments]


def test_what_is_written_is_read(tmp_path: Path, pose_rows: Rows, record: Record) -> None:
    """Topics, times and bytes come back in their order, over many chunks, and nothing is missing."""
    rows = pose_rows(500)
    record(tmp_path / "bag", rows, chunk_bytes=4096)
    bag = read_bag(tmp_path / "bag")
    assert read_back(tmp_path / "bag") == rows
    assert bag.summary.complete
    assert bag.summary.counts == {"/lily_01/pose": 500, "/lily_02/pose": 500}
    assert (bag.summary.start_ns, bag.summary.end_ns) == (1_000_000, 249_501_000_000)


def test_rosbags_reads_it(tmp_path: Path, pose_rows: Rows, record: Record) -> None:
    """The independent rosbag2 reader finds the same messages, schemas, hashes and quality of service."""
    rows = pose_rows(300)
    digest = record(tmp_path / "bag", rows, metadata={"seed": "7"}, chunk_bytes=8192)
    with Reader(tmp_path / "bag") as reader:
        read = [(connection.topic, time, bytes(data)) for connection, time, data in reader.messages()]
        connection = reader.topics["/lily_02/pose"].connections[0]
        assert connection.msgdef.data == schema_text(POSE)
        assert connection.digest == type_hash(POSE)
        assert connection.ext.offered_qos_profiles[0].depth == 1000
        assert reader.message_count == len(rows)
        assert reader.storage.metadata.custom == {"seed": "7", "digest": digest}
    assert read == [(topic, log_time, data) for topic, log_time, _, data in rows]


def test_mcap_decodes_it(tmp_path: Path, pose_rows: Rows, record: Record) -> None:
    """The MCAP project's reader, by index and with all checksums, decodes by the recorded schema alone."""
    rows = pose_rows(100)
    record(tmp_path / "bag", rows, chunk_bytes=2000)
    with (tmp_path / "bag" / "bag_0.mcap").open("rb") as file:
        reader = make_reader(file, validate_crcs=True, decoder_factories=[DecoderFactory()])
        assert reader.get_header().profile == "ros2"
        decoded = [entry.decoded_message for entry in reader.iter_decoded_messages(topics=["/lily_01/pose"])]
        statistics = reader.get_summary().statistics
    assert len(decoded) == 100
    assert decoded[3].header.frame_id == "world"
    assert decoded[3].header.stamp.sec == 1 and decoded[3].header.stamp.nanosec == 500_000_000
    assert (statistics.message_count, statistics.channel_count, statistics.schema_count) == (200, 2, 1)
    assert statistics.chunk_count > 5


def test_index_finds_messages_by_time(tmp_path: Path, pose_rows: Rows, record: Record) -> None:
    """Reading a span of time through the message indexes gives exactly the messages of that span."""
    rows = pose_rows(200)
    record(tmp_path / "bag", rows[::-1], chunk_bytes=3000)
    with (tmp_path / "bag" / "bag_0.mcap").open("rb") as file:
        found = [
            message.log_time
            for _, _, message in make_reader(file).iter_messages(starting_at=10**10, ending_before=2 * 10**10)
        ]
    assert found == sorted(time for _, time, _, _ in rows if 10**10 <= time < 2 * 10**10)


def test_metadata_of_the_run_is_kept(tmp_path: Path, pose_rows: Rows, record: Record) -> None:
    """Scenario and seed are in the file from its beginning, the digest is added at its end."""
    digest = record(tmp_path / "bag", pose_rows(3), metadata={"scenario": "tank: {}\nrobots: 2\n", "seed": "5"})
    summary = read_bag(tmp_path / "bag").summary
    assert summary.metadata["cocorosim"] == {
        "scenario": "tank: {}\nrobots: 2\n",
        "seed": "5",
        "digest": digest,
    }
    with (tmp_path / "bag" / "bag_0.mcap").open("rb") as file:
        names = [metadata.name for metadata in make_reader(file).iter_metadata()]
    assert sorted(names) == ["cocorosim", "cocorosim_begun", "rosbag2"], "a name that comes twice is warned of"


def test_metadata_yaml_has_the_fields_of_jazzy(tmp_path: Path, pose_rows: Rows, record: Record) -> None:
    """metadata.yaml is version 9 with every key that rosbag2 of Jazzy reads."""
    record(tmp_path / "bag", pose_rows(4))
    content = YAML(typ="safe").load((tmp_path / "bag" / "metadata.yaml").read_text())["rosbag2_bagfile_information"]
    assert list(content) == [
        "version", "storage_identifier", "duration", "starting_time", "message_count",
        "topics_with_message_count", "compression_format", "compression_mode",
        "relative_file_paths", "files", "custom_data", "ros_distro",
    ]  # fmt: skip
    assert (content["version"], content["storage_identifier"], content["ros_distro"]) == (9, "mcap", "jazzy")
    assert content["duration"]["nanoseconds"] == 3 * 500_000_000
    assert content["files"][0] == {
        "path": "bag_0.mcap",
        "starting_time": {"nanoseconds_since_epoch": 1_000_000},
        "duration": {"nanoseconds": 1_500_000_000},
        "message_count": 8,
    }
    topic = content["topics_with_message_count"][0]
    assert topic["topic_metadata"]["name"] == "/lily_01/pose"
    assert topic["topic_metadata"]["offered_qos_profiles"][0]["reliability"] == "reliable"
    assert topic["message_count"] == 4


def test_bare_file_tells_rosbag2_its_version(tmp_path: Path, pose_rows: Rows, record: Record) -> None:
    """The file alone holds the same metadata, which rosbag2 needs to understand what is in it."""
    record(tmp_path / "bag", pose_rows(4))
    text = read_bag(tmp_path / "bag" / "bag_0.mcap").summary.metadata["rosbag2"]["serialized_metadata"]
    in_folder = YAML(typ="safe").load((tmp_path / "bag" / "metadata.yaml").read_text())
    assert YAML(typ="safe").load(text) == in_folder["rosbag2_bagfile_information"]


def test_recording_without_messages(tmp_path: Path) -> None:
    """A run of no ticks is a complete recording with its topics and no messages."""
    BagWriter(tmp_path / "bag", [Channel("/lily_01/pose", POSE)]).close()
    summary = read_bag(tmp_path / "bag").summary
    assert (summary.complete, summary.message_count, summary.types) == (True, 0, {"/lily_01/pose": POSE})
    with Reader(tmp_path / "bag") as reader:
        assert (reader.message_count, reader.connections[0].topic) == (0, "/lily_01/pose")


def test_type_that_only_the_caller_knows(tmp_path: Path) -> None:
    """A foreign type is recorded with the schema that is given for it."""
    channel = Channel("/odd", "their_msgs/msg/Odd", schema="float64 x\n", type_hash="RIHS01_00")
    with BagWriter(tmp_path / "bag", [channel]) as bag:
        bag.write("/odd", 1, 1, b"\x00\x01\x00\x00" + bytes(8))
    topic = read_bag(tmp_path / "bag").summary.topics[0]
    assert (topic.type_name, topic.schema, topic.type_hash) == (
        "their_msgs/msg/Odd",
        "float64 x\n",
        "RIHS01_00",
    )


def test_existing_folder_is_refused(tmp_path: Path, pose_rows: Rows, record: Record) -> None:
    """Nothing existing is overwritten without force; with force the old recording is replaced."""
    record(tmp_path / "bag", pose_rows(9))
    with pytest.raises(CocorosimError, match=r"exists already.*'force'"):
        record(tmp_path / "bag", pose_rows(2))
    assert len(read_back(tmp_path / "bag")) == 18
    record(tmp_path / "bag", pose_rows(2), force=True)
    assert len(read_back(tmp_path / "bag")) == 4


def test_force_never_removes_other_files(tmp_path: Path, pose_rows: Rows, record: Record) -> None:
    """A folder that holds anything but a recording is left as it is, even with force."""
    record(tmp_path / "bag", pose_rows(1))
    (tmp_path / "bag" / "thesis.tex").write_text("years of work")
    before = sorted(file.name for file in (tmp_path / "bag").iterdir())
    with pytest.raises(CocorosimError, match=r"thesis\.tex"):
        record(tmp_path / "bag", pose_rows(1), force=True)
    assert sorted(file.name for file in (tmp_path / "bag").iterdir()) == before


def test_a_file_in_the_way_is_refused(tmp_path: Path) -> None:
    """A file where the folder should be is neither replaced nor entered."""
    (tmp_path / "bag").write_text("mine")
    with pytest.raises(CocorosimError, match="is a file"):
        BagWriter(tmp_path / "bag", force=True)
    with pytest.raises(CocorosimError, match="choose"):
        BagWriter(tmp_path / "bag" / "inner")
    assert (tmp_path / "bag").read_text() == "mine"


def test_unwritable_place_is_said() -> None:
    """Where no folder can be made, the sentence names it."""
    with pytest.raises(CocorosimError, match="/proc/recording"):
        BagWriter(Path("/proc/recording"))


def test_unknown_and_doubled_topics_are_refused(tmp_path: Path) -> None:
    """A message of a topic that is no channel, a topic given twice and an unknown type are said."""
    bag = BagWriter(tmp_path / "bag", [Channel("/a/pose", POSE)])
    with pytest.raises(CocorosimError, match="/b/pose"):
        bag.write("/b/pose", 0, 0, b"")
    with pytest.raises(CocorosimError, match="twice"):
        bag.add_channel(Channel("/a/pose", POSE))
    with pytest.raises(CocorosimError, match="no_msgs/msg/No"):
        bag.add_channel(Channel("/c", "no_msgs/msg/No"))
    with pytest.raises(CocorosimError, match="-1 ns"):
        bag.write("/a/pose", -1, 0, b"")
    bag.close()
    assert read_back(tmp_path / "bag") == []


def test_nothing_is_recorded_after_the_end(tmp_path: Path, pose_rows: Rows) -> None:
    """After close, abort or discard a message is refused, not lost; a second close changes nothing."""
    (row,) = pose_rows(1, 1)
    for number, end in enumerate((BagWriter.close, BagWriter.abort, BagWriter.discard)):
        bag = BagWriter(tmp_path / f"bag{number}", [Channel(row[0], POSE)])
        bag.write(*row)
        end(bag)
        with pytest.raises(CocorosimError, match="was closed before"):
            bag.write(*row)
        with pytest.raises(CocorosimError, match="was closed before"):
            bag.flush()
        assert bag.close() == bag.digest.hexdigest()
    assert read_bag(tmp_path / "bag0").summary.complete
    assert read_bag(tmp_path / "bag1").summary.message_count == 1
    assert not (tmp_path / "bag2").exists()


def test_recording_ended_by_an_error_reads_as_not_closed(tmp_path: Path, pose_rows: Rows) -> None:
    """An exception inside the with block leaves all messages readable; the summary says: not closed."""
    rows = pose_rows(3)
    with (
        pytest.raises(RuntimeError, match="ended by"),
        BagWriter(tmp_path / "bag", [Channel(f"/lily_0{k}/pose", POSE) for k in (1, 2)]) as bag,
    ):
        for row in rows:
            bag.write(*row)
        raise RuntimeError("ended by")
    assert read_back(tmp_path / "bag") == rows
    assert "was not closed" in read_bag(tmp_path / "bag").summary.damage
    assert not (tmp_path / "bag" / "metadata.yaml").exists()


WRITE_FOR_EVER = """
    import sys
    from cocorosim_ros.wire.cdr.type_store import build, serialize
    from cocorosim_ros.wire.bags.bag_writer import BagWriter, Channel
    bag = BagWriter(sys.argv[1], [Channel("/clock", "rosgraph_msgs/msg/Clock")], metadata={"seed": "9"})
    for tick in range(10_000_000):
        data = serialize(build("rosgraph_msgs/msg/Clock", {"clock": {"sec": tick}}))
        bag.write("/clock", tick * 1_000_000_000, tick * 1_000_000_000, data)
        if tick % 6000 == 5999:
            print(tick + 1, flush=True)
"""


def test_killed_recording_is_readable(tmp_path: Path) -> None:
    """After SIGKILL all but the last chunk (256 KiB) is there, and the summary says how far it goes."""
    with subprocess.Popen(child(WRITE_FOR_EVER, tmp_path / "bag"), stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        written = [int(process.stdout.readline()) for _ in range(5)][-1]
        process.send_signal(signal.SIGKILL)
    bag = read_bag(tmp_path / "bag")
    stamps = [message.publish_time_ns for message in bag.messages()]
    bytes_per_message = 31 + 12
    assert len(stamps) >= written - 256 * 1024 // bytes_per_message - 1
    assert stamps == [tick * 10**9 for tick in range(len(stamps))]
    assert not bag.summary.complete
    end = f"{len(stamps)} messages until t = {len(stamps) - 1}.000 s"
    assert bag.summary.damage == f"{tmp_path / 'bag'} was not closed: read up to its last whole chunk, {end}."
    assert bag.summary.metadata["cocorosim"] == {"seed": "9"}


def damage(folder: Path) -> str:
    """What a recording says that it lacks."""
    return read_bag(folder).summary.damage


def test_flush_saves_the_chunk_in_progress(tmp_path: Path, pose_rows: Rows) -> None:
    """What was flushed is read by others while the recording goes on."""
    (row,) = pose_rows(1, 1)
    bag = BagWriter(tmp_path / "bag", [Channel(row[0], POSE)])
    bag.write(*row)
    assert read_back(tmp_path / "bag") == []
    bag.flush()
    assert read_back(tmp_path / "bag") == [row]
    assert "is still being recorded: read up to its last whole chunk, 1 message" in damage(tmp_path / "bag")
    bag.close()
    assert damage(tmp_path / "bag") == ""


def test_full_disk_is_said_and_what_was_written_is_kept(small_disk: Path, pose_rows: Rows) -> None:
    """On a full disk the sentence says until when the recording goes, and so far it is readable."""
    rows = pose_rows(20_000, 1)
    bag = BagWriter(small_disk / "bag", [Channel(rows[0][0], POSE)], chunk_bytes=16_384)
    with pytest.raises(CocorosimError, match=r"No space left on device.*are kept and readable") as caught:
        for row in rows:
            bag.write(*row)
    read = read_back(small_disk / "bag")
    assert 1000 < len(read) < len(rows)
    assert read == rows[: len(read)]
    assert f"its first {len(read)} messages" in str(caught.value)
    with pytest.raises(CocorosimError, match="No space left"):
        bag.write(*rows[0])


def test_disk_that_is_full_at_the_end(small_disk: Path, pose_rows: Rows) -> None:
    """When only closing fails, every whole chunk stays readable and no metadata.yaml claims more."""
    rows = pose_rows(2000, 1)
    bag = BagWriter(small_disk / "bag", [Channel(rows[0][0], POSE)], chunk_bytes=16_384)
    for row in rows:
        bag.write(*row)
    bag.flush()
    fill(small_disk / "ballast")
    with pytest.raises(CocorosimError, match="No space left"):
        bag.close()
    (small_disk / "ballast").unlink()
    assert read_back(small_disk / "bag") == rows
    assert sorted(file.name for file in (small_disk / "bag").iterdir()) == ["bag_0.mcap"]


def fill(file: Path) -> None:
    """Take all the room that is left on a disk."""
    try:
        with file.open("wb", buffering=0) as ballast:
            for size in (4096, 1):
                while ballast.write(bytes(size)) == size:
                    pass
    except OSError:
        return


@pytest.fixture
def small_disk(tmp_path: Path) -> Iterator[Path]:
    """A folder on a disk of 1 MiB."""
    disk = tmp_path / "disk"
    disk.mkdir()
    mount = ["mount", "-t", "tmpfs", "-o", "size=1m", "tmpfs", str(disk)]
    if os.geteuid() != 0 or subprocess.run(mount, capture_output=True, check=False).returncode != 0:
        pytest.skip("only root can mount a small disk")
    yield disk
    subprocess.run(["umount", str(disk)], check=True)


WRITE_UNTIL_THE_LIMIT = """
    import resource, sys
    from cocorosim_ros.foundation.errors import CocorosimError
    from cocorosim_ros.wire.cdr.type_store import build, serialize
    from cocorosim_ros.wire.bags.bag_writer import BagWriter, Channel
    resource.setrlimit(resource.RLIMIT_FSIZE, (20_000, 20_000))
    bag = BagWriter(sys.argv[1], [Channel("/clock", "rosgraph_msgs/msg/Clock")], chunk_bytes=10_000)
    data = serialize(build("rosgraph_msgs/msg/Clock"))
    try:
        for tick in range(100_000):
            bag.write("/clock", tick, tick, data)
    except CocorosimError as error:
        print(error)
"""


def test_file_that_may_not_grow_any_more(tmp_path: Path) -> None:
    """A limit of the system in the middle of a chunk ends the recording at the chunk before it."""
    command = child(WRITE_UNTIL_THE_LIMIT, tmp_path / "bag")
    result = subprocess.run(command, capture_output=True, text=True, check=True)
    assert "File too large" in result.stdout
    times = [message.log_time_ns for message in read_bag(tmp_path / "bag").messages()]
    assert f"its first {len(times)} messages" in result.stdout
    assert len(times) > 200 and times == list(range(len(times)))


def test_digest_of_the_writer_is_that_of_the_bag(tmp_path: Path, pose_rows: Rows, record: Record) -> None:
    """What the writer hashed while writing is what the reader hashes from the file."""
    digest = record(tmp_path / "bag", pose_rows(50))
    assert bag_digest(tmp_path / "bag").hexdigest() == digest


def test_every_own_type_is_decoded_by_its_schema(tmp_path: Path) -> None:
    """A reader that knows none of our types decodes nested ones by the recorded schema."""
    message: Any = build(
        "cocorosim_msgs/msg/BlssScan", {"readings": [{"sensor": "front", "obstacle_range": float("inf")}]}
    )
    with BagWriter(tmp_path / "bag", [Channel("/lily_01/blss", "cocorosim_msgs/msg/BlssScan")]) as bag:
        bag.write("/lily_01/blss", 5, 5, serialize(message))
    data = io.BytesIO((tmp_path / "bag" / "bag_0.mcap").read_bytes())
    ((_, _, _, decoded),) = make_reader(data, decoder_factories=[DecoderFactory()]).iter_decoded_messages()
    assert (decoded.readings[0].sensor, decoded.readings[0].obstacle_range) == ("front", float("inf"))
