"""`--foxglove PORT`: refusals before anything is touched, and a replay that a WebSocket client follows."""

from __future__ import annotations

import itertools
import json
import os
import re
import socket
import struct
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import pytest
from click.testing import CliRunner
from websockets.sync.client import connect

from cocorosim_ros.commands.main import cocorosim
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.wire.bags.tracks import decode_poses

BAG = Path(__file__).parents[2] / "bags/five_lilys"
LIMIT = 120.0  # s; only a hang takes so long
ASKED_EVERY = 50  # frames


@pytest.fixture
def taken_port() -> Iterator[int]:
    """A port where something listens."""
    with socket.socket() as listener:
        listener.bind(("127.0.0.1", 0))
        listener.listen()
        yield int(listener.getsockname()[1])


@pytest.mark.parametrize("command", [("run", "one_lily", "--in-process", "--duration", "1 s"), ("run", "one_lily")])
def test_a_port_in_use_ends_a_run_before_it_begins(command: tuple[str, ...], taken_port: int, tmp_path: Path) -> None:
    """A sentence, and no folder."""
    done = CliRunner().invoke(cocorosim, [*command, "--out", str(tmp_path / "run"), "--foxglove", str(taken_port)])
    assert isinstance(done.exception, CocorosimError)
    assert str(done.exception).startswith(f"--foxglove has {taken_port}, where no server can listen (")
    assert list(tmp_path.iterdir()) == []


def test_a_replay_shows_poses(free_domain: str) -> None:
    """A client subscribes to a pose of a replay in a loop, and reads where the robot was at each stamp."""
    script = "from cocorosim_ros.commands.main import main; main()"
    program = [sys.executable, "-u", "-c", script, "replay", str(BAG), "--loop", "--rate", "20", "--foxglove", "0"]
    environment = {**os.environ, "ROS_DOMAIN_ID": free_domain, "COLUMNS": "200"}
    with subprocess.Popen(program, stdout=subprocess.PIPE, text=True, env=environment) as replay:
        try:
            assert replay.stdout is not None
            address = next(found[0] for line in replay.stdout if (found := re.search(r"ws://\S+", line)))
            poses = poses_seen(address, "/lily_03/pose", 5)
        finally:
            replay.kill()
    stamps = [stamp for stamp, _ in poses]
    assert stamps == sorted(stamps)
    assert len(set(stamps)) > 1
    position, _ = decode_poses([data for _, data in poses])
    assert (abs(position[:, :2]) < 3.0).all()
    assert (position[:, 2] <= 0.0).all()


def poses_seen(address: str, topic: str, count: int) -> list[tuple[int, bytes]]:
    """Log time [ns] and bytes of so many messages of a topic, which is asked for until something comes."""
    seen: list[tuple[int, bytes]] = []
    channel = None
    deadline = time.monotonic() + LIMIT
    with connect(address, subprotocols=["foxglove.sdk.v1"], open_timeout=LIMIT) as client:  # type: ignore[list-item]
        for number in itertools.count():
            frame = client.recv(LIMIT)
            assert time.monotonic() < deadline, f"{number} frames and {len(seen)} poses in {LIMIT:g} s"
            if isinstance(frame, str):
                content = json.loads(frame)
                offered = content["channels"] if content["op"] == "advertise" else ()
                channel = next((each["id"] for each in offered if each["topic"] == topic), channel)
            elif frame[0] == 1:
                seen.append((struct.unpack_from("<Q", frame, 5)[0], frame[13:]))
                if len(seen) == count:
                    return seen
            if channel is not None and not seen and number % ASKED_EVERY == 0:
                asked = [{"id": number, "channelId": channel}]
                client.send(json.dumps({"op": "subscribe", "subscriptions": asked}))
    return seen
