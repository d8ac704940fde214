"""`--foxglove PORT`: refusals before anything is touched, and a replay that a WebSocket client follows."""

from __future__ import annotations

import itertools
import json
import os
import re
import signal
import socket
import struct
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from click.testing import CliRunner
from websockets.sync.client import ClientConnection, connect

from cocorosim_ros.commands.interruption import INTERRUPTED
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


@contextmanager
def started(free_domain: str, *arguments: str) -> Iterator[tuple[subprocess.Popen[str], str]]:
    """A command that viewers can follow, and the address that it tells; killed in the end, if it has not ended."""
    script = "from cocorosim_ros.commands.main import main; main()"
    program = [sys.executable, "-u", "-c", script, *arguments, "--foxglove", "0"]
    environment = {**os.environ, "ROS_DOMAIN_ID": free_domain, "COLUMNS": "200"}
    with subprocess.Popen(program, stdout=subprocess.PIPE, text=True, env=environment) as process:
        try:
            assert process.stdout is not None
            yield process, next(found[0] for line in process.stdout if (found := re.search(r"ws://\S+", line)))
        finally:
            process.kill()


def test_a_run_shows_poses(free_domain: str, tmp_path: Path) -> None:
    """The graph's own nodes, live: a client reads poses while the robots swim, and Ctrl-C ends the run as ever."""
    run = ("run", "one_lily", "--rate", "10", "--duration", "1 h", "--out", str(tmp_path / "run"))
    with started(free_domain, *run) as (process, address):
        poses = poses_seen(address, "/lily_01/pose", 5)
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=LIMIT)
    assert process.returncode == INTERRUPTED
    stamps = [stamp for stamp, _ in poses]
    assert stamps == sorted(set(stamps))
    position, _ = decode_poses([data for _, data in poses])
    assert (position[:, 2] <= 0.0).all()


def test_a_replay_shows_poses(free_domain: str) -> None:
    """A client subscribes to a pose of a replay in a loop, and reads where the robot was at each stamp."""
    with started(free_domain, "replay", str(BAG), "--loop", "--rate", "20") as (_, address):
        poses = poses_seen(address, "/lily_03/pose", 5)
    stamps = [stamp for stamp, _ in poses]
    assert stamps == sorted(stamps)
    assert len(set(stamps)) > 1
    position, _ = decode_poses([data for _, data in poses])
    assert (abs(position[:, :2]) < 3.0).all()
    assert (position[:, 2] <= 0.0).all()


def connected(address: str) -> ClientConnection:
    """A client of an address that is told before its server, a node of the run, is there."""
    deadline = time.monotonic() + LIMIT
    while True:
        try:
            return connect(address, subprotocols=["foxglove.sdk.v1"], open_timeout=LIMIT)  # type: ignore[list-item]
        except ConnectionRefusedError:
            assert time.monotonic() < deadline, f"nobody listens at {address}"
            time.sleep(0.05)


def poses_seen(address: str, topic: str, count: int) -> list[tuple[int, bytes]]:
    """Log time [ns] and bytes of so many messages of a topic, which is asked for until something comes."""
    seen: list[tuple[int, bytes]] = []
    channel = None
    deadline = time.monotonic() + LIMIT
    with connected(address) as client:
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
