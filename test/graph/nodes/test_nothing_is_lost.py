"""Thirty robots in lock-step: every topic has a message of every tick, and independent readers find them."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

from mcap.reader import make_reader
from mcap_ros2.decoder import DecoderFactory
from rosbags.highlevel import AnyReader

TICKS = 10
ROBOTS = [f"lily_{number:02d}" for number in range(1, 31)]
PER_ROBOT = {"pose", "compass", "pressure", "imu", "blss", "velocity", "radio_rx", "radio_tx", "thruster_command"}


def test_thirty_robots_lose_nothing(
    start: Callable[..., Any], counts: Callable[[Path], dict[str, int]], tmp_path: Path
) -> None:
    """The count per topic is exactly the number of ticks; `rosbags` and `mcap_ros2` decode the recording."""
    run = start("cocorosim", "run", "thirty_lilys", "--duration", f"{TICKS * 0.5} s", "--out", tmp_path / "run")
    assert run.finish() == 0, run.output
    bag = tmp_path / "run" / "bag"
    expected = {f"/{robot}/{name}": TICKS for robot in ROBOTS for name in PER_ROBOT}
    expected |= {"/clock": TICKS, "/tf": TICKS, "/shoal_statistics": TICKS, "/diagnostics": 1}
    expected |= {"/tf_static": 1, "/markers/tank": 1, **{f"/{robot}/robot_description": 1 for robot in ROBOTS}}
    expected |= {"/markers/swarm": math.ceil(TICKS * 0.5 / 2.0)}  # one every 2 s
    assert counts(bag) == expected

    with (bag / "bag_0.mcap").open("rb") as file:
        decoded = [
            (channel.topic, message)
            for _, channel, _, message in make_reader(
                file, decoder_factories=[DecoderFactory()]
            ).iter_decoded_messages()
        ]
    assert len(decoded) == sum(expected.values())
    clock = [message.clock for topic, message in decoded if topic == "/clock"]
    assert [time.sec * 10**9 + time.nanosec for time in clock] == [tick * 500_000_000 for tick in range(TICKS)]

    with AnyReader([bag]) as reader:
        connections = [c for c in reader.connections if c.topic in ("/tf", "/lily_07/pose")]
        messages = [(c.topic, reader.deserialize(data, c.msgtype)) for c, _, data in reader.messages(connections)]
    first = next(message for topic, message in messages if topic == "/tf").transforms
    assert {transform.header.frame_id for transform in first} == {"world"}
    assert [transform.child_frame_id for transform in first] == [f"{robot}/base_link" for robot in ROBOTS]
    pose = next(message for topic, message in messages if topic == "/lily_07/pose")
    assert pose.header.frame_id == "world"
    assert first[6].transform.translation.x == pose.pose.position.x
    assert first[6].transform.rotation.z == pose.pose.orientation.z
