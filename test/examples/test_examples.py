"""The examples do what they say, on topics alone: they import nothing of ours but cocorosim_msgs."""

from __future__ import annotations

import ast
import math
import os
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import suppress
from pathlib import Path

import pytest
from rosbags.highlevel import AnyReader

BIN = Path(sys.executable).parent
HERE = Path(__file__).parent
LIMIT = 200.0  # s; only a hang takes so long
ALLOWED = {"math", "sys", "rclpy", "cocorosim_msgs", "sensor_msgs"}


@pytest.fixture
def start(tmp_path: Path) -> Iterator[Callable[..., tuple[subprocess.Popen[bytes], Path]]]:
    """Function of a command: its process and the file with its output; it ends with the test."""
    running: list[subprocess.Popen[bytes]] = []

    def begin(*command: object, env: dict[str, str]) -> tuple[subprocess.Popen[bytes], Path]:
        log = tmp_path / f"output_{len(running)}.txt"
        with log.open("wb") as file:
            environment = {**os.environ, "COLUMNS": "400", **env}
            words = [str(part) for part in command]
            running.append(subprocess.Popen(words, stdout=file, stderr=subprocess.STDOUT, env=environment))
        return running[-1], log

    yield begin
    for process in running:
        process.terminate()  # in order, so that nothing is left in shared memory
    for process in running:
        with suppress(subprocess.TimeoutExpired):
            process.wait(20.0)
        process.kill()
        process.wait(LIMIT)


def wait_for(log: Path, is_there: Callable[[str], bool]) -> str:
    """The output of a process as soon as it fulfils the condition."""
    deadline = time.monotonic() + LIMIT
    while not is_there(text := log.read_text()):
        assert time.monotonic() < deadline, text
        time.sleep(0.05)
    return text


@pytest.mark.parametrize("name", ["external_controller.py", "toy_robot.py"])
def test_an_example_needs_only_ros_and_the_messages(name: str) -> None:
    """What it imports is a short list, and it has a main() and says how it is used."""
    tree = ast.parse((HERE / name).read_text())
    imported = {alias.name for node in ast.walk(tree) if isinstance(node, ast.Import) for alias in node.names}
    imported |= {str(node.module) for node in ast.walk(tree) if isinstance(node, ast.ImportFrom)}
    assert {module.split(".")[0] for module in imported} <= ALLOWED
    assert "main" in {node.name for node in tree.body if isinstance(node, ast.FunctionDef)}
    assert f"python {name} lily_" in (ast.get_docstring(tree) or "")


def test_the_external_controller_drives_its_robot_in_lock_step(
    start: Callable[..., tuple[subprocess.Popen[bytes], Path]], free_domain: str, tmp_path: Path
) -> None:
    """Each tick has its command, the heading follows the circle, and the script ends with the run."""
    run, log = start(
        *(BIN / "cocorosim", "run", "eleven_lilys", "--duration", "60 s", "--external", "lily_03"),
        *("--out", tmp_path / "run"),
        env={"ROS_DOMAIN_ID": free_domain},
    )
    here = {"ROS_DOMAIN_ID": free_domain, "ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST"}
    script, words = start(sys.executable, HERE / "external_controller.py", "lily_03", env=here)
    assert run.wait(LIMIT) == 0, log.read_text()
    assert script.wait(LIMIT) == 0, words.read_text()
    assert "warning" not in words.read_text().lower()
    with AnyReader([tmp_path / "run" / "bag"]) as reader:
        chosen = [c for c in reader.connections if c.topic in ("/lily_03/thruster_command", "/lily_03/compass")]
        read = [(c.topic, reader.deserialize(data, c.msgtype)) for c, _, data in reader.messages(chosen)]
    commands = [message for topic, message in read if topic.endswith("command")]
    stamps = [message.header.stamp.sec * 2 + message.header.stamp.nanosec // 500_000_000 for message in commands]
    assert stamps == list(range(120))
    headings = [message.heading for topic, message in read if topic.endswith("compass")]
    assert headings[1] != headings[0], "the first command acts"
    wanted = 2 * math.pi * 59.5 / 120.0
    assert abs(math.remainder(headings[-1] - wanted, 2 * math.pi)) < 0.3, headings


def test_controller_node_turns_a_robot_that_is_not_ours(
    start: Callable[..., tuple[subprocess.Popen[bytes], Path]], free_domain: str
) -> None:
    """On wall-clock time, without blue light and velocity, heading_hold brings it to the wanted heading and depth."""
    env = {"ROS_DOMAIN_ID": free_domain, "ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST"}
    robot, log = start(sys.executable, HERE / "toy_robot.py", "lily_01", env=env)
    first = wait_for(log, lambda text: text.count("\n") >= 1).split()
    assert abs(float(first[1]) + 1.0) < 1e-3, "nobody steers yet"
    settings = ("controller:=heading_hold", "period:=0.2", "setting.heading:=1.5708", "setting.speed:=0.3")
    given = [word for setting in settings for word in ("-p", setting)]
    controller, words = start(
        BIN / "controller_node", "--ros-args", "-r", "__ns:=/lily_01", *given, "-p", "setting.depth:=1.0", env=env
    )

    def has_turned(text: str) -> bool:
        lines = [line.split() for line in text.splitlines()[-5:]]
        return len(lines) == 5 and all(abs(float(line[1]) - math.pi / 2) < 0.15 for line in lines)

    wait_for(log, lambda text: has_turned(text) or controller.poll() is not None)
    assert controller.poll() is None, words.read_text()
    wait_for(log, lambda text: abs(float(text.splitlines()[-1].split()[2]) - 1.0) < 0.1)
    assert "no recent blss, velocity" in wait_for(words, lambda text: "no recent" in text)
    controller.terminate()
    assert controller.wait(LIMIT) == 0, words.read_text()
    robot.terminate()
