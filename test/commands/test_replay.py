"""`cocorosim replay`: the recorded bytes on their topics again, at their time, for all that listen."""

from __future__ import annotations

import json
import re
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from rosbags.rosbag2 import StoragePlugin, Writer
from rosbags.typesys import Stores, get_types_from_msg, get_typestore

from cocorosim_ros.wire.bags.bag_reader import read_bag
from cocorosim_ros.wire.bags.comparison import bag_digest, difference
from cocorosim_ros.wire.cdr.stamps import stamp_ns
from cocorosim_ros.wire.cdr.type_store import build, serialize, type_store

from .conftest import PROGRAM

POSE, CLOCK = "geometry_msgs/msg/PoseStamped", "rosgraph_msgs/msg/Clock"
PATIENCE = 200.0  # s; a busy machine is slow
METRICS_NODE = (
    "import sys; from cocorosim_ros.graph.nodes.metrics_node import main; sys.argv[0] = 'metrics_node'; main()"
)
Command = Callable[..., SimpleNamespace]
Start = Callable[..., "subprocess.Popen[str]"]


class Ears:
    """Subscriptions in plain rclpy, and what each has heard."""

    def __init__(self) -> None:
        import rclpy
        from rclpy.executors import SingleThreadedExecutor

        self.context = rclpy.Context()
        rclpy.init(context=self.context)
        self.node = rclpy.create_node("ears", context=self.context)
        self._executor = SingleThreadedExecutor(context=self.context)
        self._executor.add_node(self.node)
        self.heard: dict[str, list[bytes]] = {}

    def listen(self, topic: str, kind: Any, quality: Any) -> None:
        """Listen to a topic from now on."""
        heard = self.heard.setdefault(topic, [])
        self.node.create_subscription(kind, topic, lambda data: heard.append(bytes(data)), quality, raw=True)

    def until(self, condition: Callable[[], bool]) -> None:
        """Listen until something is so, and fail if it does not become so."""
        end = time.monotonic() + PATIENCE
        while not condition():
            assert time.monotonic() < end, {topic: len(heard) for topic, heard in self.heard.items()}
            self._executor.spin_once(timeout_sec=0.05)

    def close(self) -> None:
        """End listening."""
        import rclpy

        self._executor.shutdown()
        self.node.destroy_node()
        rclpy.shutdown(context=self.context)


@pytest.fixture
def ears(domain: int) -> Iterator[Ears]:
    """Somebody who listens in the test's domain."""
    listener = Ears()
    yield listener
    listener.close()


def ended(process: subprocess.Popen[str]) -> SimpleNamespace:
    """Exit status and all words of a process that is about to end."""
    words, _ = process.communicate(timeout=PATIENCE)
    return SimpleNamespace(status=process.returncode, words=words)


def recorded(bag: Path, topic: str) -> list[bytes]:
    """The messages of a topic."""
    return [message.data for message in read_bag(bag).messages([topic])]


def test_metrics_node_over_a_replay(domain: int, start: Start, run_of_20_seconds: Any, tmp_path: Path) -> None:
    """A metrics node that hears a replay, as fast as it goes, records the same bag, and measures the same numbers.

    Equal digests mean: every message of every topic, and the statistics of every stamp, bit for bit.
    """
    parameters = {
        "robots": " ".join(run_of_20_seconds.robots),
        "out": str(tmp_path / "again"),
        "summary": str(tmp_path / "again.json"),
        "lock_step": "false",
    }
    arguments = [part for name, value in parameters.items() for part in ("-p", f"{name}:={value}")]
    node = start("--ros-args", *arguments, program=METRICS_NODE)
    heard = len(run_of_20_seconds.topics) - 1
    replay = ended(start("replay", run_of_20_seconds.bag, "--fast", "--wait", heard))
    assert replay.status == 0, replay.words
    assert ended(node).status == 0
    assert difference(run_of_20_seconds.bag, tmp_path / "again") == []
    assert bag_digest(tmp_path / "again").hexdigest() == run_of_20_seconds.digest
    assert json.loads((tmp_path / "again.json").read_text()) == run_of_20_seconds.live
    # The statistics were left to the node.
    assert f"{read_bag(run_of_20_seconds.bag).summary.message_count - 40} messages in " in replay.words


def test_part_at_a_rate(ears: Ears, start: Start, run_of_20_seconds: Any) -> None:
    """From 5 s to 10 s at 5 times the pace: these bytes, in one second and not less."""
    from geometry_msgs.msg import PoseStamped
    from rclpy.qos import QoSProfile
    from rosgraph_msgs.msg import Clock

    pose = "/lily_02/pose"
    ears.listen(pose, PoseStamped, QoSProfile(depth=100))
    ears.listen("/clock", Clock, QoSProfile(depth=100))
    options = ("--from", 5, "--to", 10, "--rate", 5, "--topics", "/lily_0[23]/*", "--wait", 2)
    process = start("replay", run_of_20_seconds.bag, *options)
    ears.until(lambda: len(ears.heard[pose]) >= 11 and len(ears.heard["/clock"]) >= 11)
    replay = ended(process)
    assert replay.status == 0, replay.words
    assert "19 topics" in replay.words  # nine of each robot, and the clock
    for topic in (pose, "/clock"):
        assert ears.heard[topic] == recorded(run_of_20_seconds.bag, topic)[10:21]
    lasted = re.search(r"messages in ([\d.]+) s", replay.words)
    assert lasted is not None, replay.words
    assert 1.0 <= float(lasted[1]) < 4.0, "a busy machine may be late, but 5 s would be another pace"


def foreign_recording(folder: Path) -> Path:
    """By the independent writer: 1 s of poses at 20 Hz, a type that is not installed, something latched at the start.

    It has no clock; poses were offered with best effort.
    """
    from rosbags.interfaces import Qos, QosDurability, QosHistory, QosLiveliness, QosReliability, QosTime

    def quality(reliability: QosReliability, durability: QosDurability) -> list[Qos]:
        never = QosTime(9223372036, 854775807)
        history = (QosHistory.KEEP_LAST, 7, reliability, durability)
        return [Qos(*history, never, never, QosLiveliness.AUTOMATIC, never, False)]

    store = get_typestore(Stores.ROS2_JAZZY)
    store.register(get_types_from_msg("float64 depth\n", "plankton_msgs/msg/Bloom"))
    with Writer(folder, version=9, storage_plugin=StoragePlugin.MCAP) as writer:
        loose = quality(QosReliability.BEST_EFFORT, QosDurability.VOLATILE)
        latched = quality(QosReliability.RELIABLE, QosDurability.TRANSIENT_LOCAL)
        name = writer.add_connection("/name", "std_msgs/msg/String", typestore=store, offered_qos_profiles=latched)
        pose = writer.add_connection("/fish/pose", POSE, typestore=store, offered_qos_profiles=loose)
        bloom = writer.add_connection("/bloom", "plankton_msgs/msg/Bloom", typestore=store)
        writer.write(name, 10**9, serialize(build("std_msgs/msg/String", {"data": "a trout"})))
        for k in range(21):
            stamp = {"sec": 1 + k // 20, "nanosec": k % 20 * 50_000_000}
            writer.write(pose, 10**9 + k * 50_000_000, serialize(build(POSE, {"header": {"stamp": stamp}})))
        writer.write(bloom, 2 * 10**9, b"\x00\x01\x00\x00" + bytes(8))
    return folder


def test_foreign_recording(ears: Ears, start: Start, tmp_path: Path) -> None:
    """What cannot be published is said; a clock is made from the log times; offers are the recorded ones; what was
    latched before the beginning is there.
    """
    from geometry_msgs.msg import PoseStamped
    from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy, qos_profile_sensor_data
    from rosgraph_msgs.msg import Clock
    from std_msgs.msg import String

    ears.listen("/fish/pose", PoseStamped, qos_profile_sensor_data)
    ears.listen("/clock", Clock, QoSProfile(depth=100))
    ears.listen("/name", String, QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL))
    process = start(
        "replay", foreign_recording(tmp_path / "foreign"), "--from", 0.5, "--wait", 3, "--loop", "--rate", 2
    )
    ears.until(lambda: min(map(len, ears.heard.values())) >= 1 and len(ears.heard["/clock"]) >= 30)
    offers = {topic: ears.node.get_publishers_info_by_topic(topic)[0].qos_profile for topic in ears.heard}
    process.send_signal(signal.SIGINT)
    replay = ended(process)
    assert replay.status == 130, replay.words
    assert "/bloom is not published: its type plankton_msgs/msg/Bloom is not installed here." in replay.words
    assert "3 topics, /clock made from the log times" in replay.words
    assert "(interrupted)" in replay.words
    assert offers["/fish/pose"].reliability == ReliabilityPolicy.BEST_EFFORT
    assert offers["/name"].durability == DurabilityPolicy.TRANSIENT_LOCAL
    assert offers["/clock"].reliability == ReliabilityPolicy.RELIABLE
    ticks = [stamp_ns(CLOCK, data) for data in ears.heard["/clock"]]
    # 40 times a second of wall clock at twice the pace; after one round it begins again.
    assert ticks[:11] == [1_500_000_000 + k * 50_000_000 for k in range(11)]
    assert ticks[11] == 1_500_000_000
    stamps = {stamp_ns(POSE, data) for data in ears.heard["/fish/pose"]}
    assert stamps <= {1_500_000_000 + k * 50_000_000 for k in range(11)}
    assert set(ears.heard["/name"]) == set(recorded(tmp_path / "foreign", "/name"))


@pytest.mark.usefixtures("domain")
def test_for_programs(run_of_20_seconds: Any) -> None:
    """What was published as JSON, alone on standard output: of /clock one message a tick."""
    words = ["replay", str(run_of_20_seconds.bag), "--fast", "--topics", "/clock"]
    line = [sys.executable, "-c", PROGRAM, *words, "--json", "-"]
    done = subprocess.run(line, capture_output=True, text=True, timeout=PATIENCE, check=True)
    told = json.loads(done.stdout)
    assert (told["topics"], told["messages"], told["interrupted"]) == (["/clock"], 40, False)
    assert "40 messages in " in done.stderr


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("--rate", 0), "--rate has 0; give a positive number, or --fast."),
        (("--rate", 2, "--fast"), "--rate and --fast exclude each other"),
        (("--wait", -1), "--wait has -1"),
        (("--from", 30), "is 19.5 s long, and nothing lies between --from 30 and --to 19.5"),
        (("--from", 3, "--to", 2), "nothing lies between --from 3 and --to 2"),
        (("--topics", "/shark/*"), "has no topic '/shark/*'; it has /clock"),
    ],
)
def test_unusable_options(arguments: tuple[Any, ...], words: str, cocorosim: Command, run_of_20_seconds: Any) -> None:
    """Each is one sentence on standard error and status 2, before ROS is started."""
    result = cocorosim("replay", run_of_20_seconds.bag, *arguments)
    assert result.status == 2
    assert words in result.err
    assert result.err.count("\n") == 1


def test_empty_recording(cocorosim: Command, tmp_path: Path) -> None:
    """There is nothing to replay, which is said."""
    with Writer(tmp_path / "empty", version=9, storage_plugin=StoragePlugin.MCAP) as writer:
        writer.add_connection("/fish/pose", POSE, typestore=type_store())
    result = cocorosim("replay", tmp_path / "empty")
    assert result.status == 2
    assert f"{tmp_path}/empty holds no messages, so there is nothing to replay." in result.err
