"""What a WebSocket client sees that speaks Foxglove's protocol, read by `websockets` and decoded by `rosbags`."""

from __future__ import annotations

import json
import socket
import struct
from collections.abc import Iterator
from typing import Any

import pytest
from rosbags.typesys import Stores, get_types_from_msg, get_typestore
from websockets.sync.client import ClientConnection, connect

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.wire.cdr.type_store import build, serialize
from cocorosim_ros.wire.live.foxglove_server import HOST, FoxgloveServer, check_port

LIMIT = 30.0  # s; only a hang takes so long
POSE, TEXT, CLOCK = "geometry_msgs/msg/PoseStamped", "std_msgs/msg/String", "rosgraph_msgs/msg/Clock"
MESSAGE, TIME = 1, 2  # operation codes of binary frames


@pytest.fixture
def server() -> Iterator[FoxgloveServer]:
    """One with a pose, a clock, and a description that was said before anyone listened."""
    with FoxgloveServer(0, "test") as server:
        for topic, type_name in (("/fish/pose", POSE), ("/clock", CLOCK), ("/fish/robot_description", TEXT)):
            server.add(topic, type_name)
        server.send("/fish/robot_description", 0, serialize(build(TEXT, {"data": "<robot/>"})), latched=True)
        yield server


@pytest.fixture
def client(server: FoxgloveServer) -> Iterator[ClientConnection]:
    """A client that has asked for nothing yet."""
    with connect(f"ws://{HOST}:{server.port}", subprotocols=["foxglove.sdk.v1"], open_timeout=LIMIT) as connection:  # type: ignore[list-item]
        yield connection


def words(client: ClientConnection, operation: str) -> dict[str, Any]:
    """The next JSON of that operation."""
    while True:
        frame = client.recv(LIMIT)
        if isinstance(frame, str) and (content := json.loads(frame))["op"] == operation:
            return dict(content)


def next_frame(client: ClientConnection, operation: int) -> bytes:
    """The next binary frame of that operation, without its code."""
    while True:
        frame = client.recv(LIMIT)
        if isinstance(frame, bytes) and frame[0] == operation:
            return frame[1:]


def subscribe(client: ClientConnection) -> dict[int, dict[str, Any]]:
    """Ask for every channel; the channels by the numbers of their subscriptions."""
    channels: dict[int, dict[str, Any]] = {}
    while len(channels) < 3:
        for channel in words(client, "advertise")["channels"]:
            channels[channel["id"]] = channel
    asked = [{"id": number, "channelId": number} for number in channels]
    client.send(json.dumps({"op": "subscribe", "subscriptions": asked}))
    return channels


def test_messages_come_with_schema_and_stamp(server: FoxgloveServer, client: ClientConnection) -> None:
    """A late client gets what is latched, then poses that the schema alone decodes, and the clock as server time."""
    channels = subscribe(client)
    number, stamp = struct.unpack_from("<IQ", frame := next_frame(client, MESSAGE))
    assert channels[number]["topic"] == "/fish/robot_description"
    assert b"<robot/>" in frame[12:]
    place = {"x": 1.5, "y": -2.0, "z": -0.25}
    data = serialize(build(POSE, {"pose": {"position": place}}))
    server.send("/fish/pose", 2_500_000_000, data)
    number, stamp = struct.unpack_from("<IQ", frame := next_frame(client, MESSAGE))
    channel = channels[number]
    assert (channel["topic"], channel["encoding"], channel["schemaEncoding"]) == ("/fish/pose", "cdr", "ros2msg")
    assert stamp == 2_500_000_000
    store = get_typestore(Stores.EMPTY)
    store.register(get_types_from_msg(channel["schema"], channel["schemaName"]))
    pose = store.deserialize_cdr(frame[12:], channel["schemaName"]).pose
    assert (pose.position.x, pose.position.y, pose.position.z) == (1.5, -2.0, -0.25)
    server.send("/clock", 3_000_000_000, serialize(build(CLOCK, {"clock": {"sec": 3}})))
    assert struct.unpack("<Q", next_frame(client, TIME)) == (3_000_000_000,)


def test_a_port_in_use_is_a_sentence(server: FoxgloveServer) -> None:
    """By the check before a run, and by the server itself."""
    for begin in (check_port, lambda port: FoxgloveServer(port, "second")):
        with pytest.raises(CocorosimError, match=f"--foxglove has {server.port}, where no server can listen .*another"):
            begin(server.port)


@pytest.mark.parametrize("port", [-1, 65536])
def test_a_port_that_does_not_exist_is_a_sentence(port: int) -> None:
    """Not a traceback of the socket."""
    with pytest.raises(CocorosimError, match="give another port from 1024 to 65535"):
        check_port(port)


def test_a_free_port_passes() -> None:
    """The check leaves it free, and finds one."""
    assert check_port(0) > 0
    with socket.socket() as probe:
        probe.bind((HOST, 0))
        port = probe.getsockname()[1]
    assert check_port(port) == port
    with FoxgloveServer(port, "first") as server:
        assert server.port == port
