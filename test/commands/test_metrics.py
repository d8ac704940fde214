"""`cocorosim metrics`: the live numbers again, from any recording that has poses, without ROS."""

from __future__ import annotations

import json
import math
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from rosbags.rosbag2 import StoragePlugin, Writer

from cocorosim_ros.study.metrics import METRICS, PAPER_METRICS
from cocorosim_ros.wire.cdr.type_store import build, serialize, type_store

POSE, WORD = "geometry_msgs/msg/PoseStamped", "std_msgs/msg/String"
Command = Callable[..., SimpleNamespace]
SHIPPED = Path(__file__).parents[2] / "bags" / "five_lilys"
BLOCKED = """
import sys
for name in ("rclpy", "rosidl_runtime_py", "geometry_msgs", "std_msgs", "cocorosim_msgs", "builtin_interfaces"):
    sys.modules[name] = None
from cocorosim_ros.commands.main import main
main()
"""


def pose(time: float, x: float, y: float, yaw: float = 0.0) -> bytes:
    """The bytes of a pose 1 m deep."""
    stamp = {"sec": int(time), "nanosec": round(time % 1 * 1e9)}
    return serialize(
        build(
            POSE,
            {
                "header": {"stamp": stamp, "frame_id": "world"},
                "pose": {
                    "position": {"x": x, "y": y, "z": -1.0},
                    "orientation": {"z": math.sin(yaw / 2), "w": math.cos(yaw / 2)},
                },
            },
        )
    )


def write_foreign(folder: Path, poses: dict[str, list[tuple[float, bytes]]], extra: tuple[str, ...] = ()) -> Path:
    """A recording by the independent writer: (time [s], bytes) of each robot, and topics that nobody asked for."""
    with Writer(folder, version=9, storage_plugin=StoragePlugin.MCAP) as writer:
        for robot, rows in poses.items():
            connection = writer.add_connection(f"/{robot}/pose", POSE, typestore=type_store())
            for time, data in rows:
                writer.write(connection, round(time * 1e9), data)
        for topic in extra:
            connection = writer.add_connection(topic, WORD, typestore=type_store())
            writer.write(connection, 5, serialize(build(WORD, {"data": "hello"})))
    return folder


def formation(gap: tuple[float, float] = (math.inf, math.inf)) -> dict[str, list[tuple[float, bytes]]]:
    """Two robots abreast, 0.3 m apart, at 0.05 m/s along x for 12 s, seen at 10 Hz and (with jitter) about 7 Hz.

    The second is not seen inside `gap` [s].
    """
    jitter = np.random.default_rng(1).uniform(-0.02, 0.02, 85)
    second = [(k / 7 + shift if 0 < k < 84 else k / 7) for k, shift in enumerate(jitter)]
    return {
        "left": [(k / 10, pose(k / 10, 0.05 * k / 10, 0.3)) for k in range(121)],
        "right": [(time, pose(time, 0.05 * time, 0.0)) for time in second if not gap[0] < time < gap[1]],
    }


def read_json(file: Path) -> Any:
    """The content of a JSON file that has no NaN."""

    def refuse(word: str) -> None:
        raise AssertionError(word)

    return json.loads(file.read_text(), parse_constant=refuse)


def test_json_on_standard_output_is_nothing_but_json(
    cocorosim: Command, run_of_20_seconds: SimpleNamespace, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """`--json -` can be piped on; the table goes to standard error, and no file is called `-`."""
    monkeypatch.chdir(tmp_path)
    ended = cocorosim("metrics", run_of_20_seconds.bag, "--json", "-")
    assert ended.status == 0
    assert json.loads(ended.out)["metrics"] == run_of_20_seconds.live["metrics"]
    assert "polarisation" in ended.err
    assert list(tmp_path.iterdir()) == []


def test_numbers_are_those_measured_live(cocorosim: Command, run_of_20_seconds: Any, tmp_path: Path) -> None:
    """From the recording of a lock-step run every number comes back bit for bit."""
    ended = cocorosim("metrics", run_of_20_seconds.bag, "--json", tmp_path / "metrics.json")
    assert ended.status == 0, ended.err
    content = read_json(tmp_path / "metrics.json")
    assert content["metrics"] == run_of_20_seconds.live["metrics"]
    assert (content["ticks"], content["start_ns"], content["end_ns"]) == (40, 0, 19_500_000_000)
    assert content["digest"] == run_of_20_seconds.digest
    assert content["robots"] == run_of_20_seconds.robots
    assert content["findings"] == []


def test_ros_is_not_needed(run_of_20_seconds: Any, tmp_path: Path) -> None:
    """With rclpy and all message packages out of reach the command works, also on the folder of a run."""
    line = [sys.executable, "-c", BLOCKED, "metrics", str(run_of_20_seconds.bag.parent), "--json", "here.json"]
    done = subprocess.run(line, check=False, capture_output=True, text=True, timeout=600, cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    assert read_json(tmp_path / "here.json")["metrics"] == run_of_20_seconds.live["metrics"]


@pytest.mark.parametrize(("options", "shown"), [((), PAPER_METRICS), (("--all",), tuple(METRICS))])
def test_table(options: tuple[str, ...], shown: Any, cocorosim: Command, run_of_20_seconds: Any) -> None:
    """The table has the paper's six, or all; nothing is cut off in a pipe."""
    lines = cocorosim("metrics", run_of_20_seconds.bag, *options).out.splitlines()
    rows = [line.split("│")[1].strip() for line in lines if line.startswith("│")]
    assert rows == list(shown)


def test_other_rates_of_other_people(cocorosim: Command, tmp_path: Path) -> None:
    """Two robots side by side, at different rates: 0.3 m apart, 0.05 m/s, polarisation 1; how it was done is said."""
    bag = write_foreign(tmp_path / "foreign", formation(), extra=("/chatter", "/left/word"))
    ended = cocorosim("metrics", bag, "--json", tmp_path / "m.json", "--interval", "0.5 s")
    assert ended.status == 0, ended.err
    content = read_json(tmp_path / "m.json")
    values = {name: entry["value"] for name, entry in content["metrics"].items()}
    assert content["robots"] == ["left", "right"]
    assert content["ticks"] == 25
    assert values["polarisation"] == pytest.approx(1.0, abs=1e-12)
    assert values["separation"] == pytest.approx(0.3, abs=1e-9)
    assert values["shoal_speed"] == pytest.approx(0.05, abs=1e-9)
    assert values["shoals"] == 1.0
    assert content["digest"] is None
    sentence = next(line for line in ended.out.splitlines() if "interpolated" in line)
    assert sentence.endswith("they were interpolated to moments 0.5 s apart.")


def test_gaps_and_robots_without_poses(cocorosim: Command, tmp_path: Path) -> None:
    """In a gap of 4 s the robot is absent; one that is named and never seen is said to be absent throughout."""
    bag = write_foreign(tmp_path / "foreign", {**formation(gap=(4.1, 8.1)), "ghost": []})
    ended = cocorosim("metrics", bag, "--json", tmp_path / "m.json", "--interval", "0.5s")
    content = read_json(tmp_path / "m.json")
    words = " ".join(content["findings"])
    assert "right: 1 gaps longer than 1 s" in words
    assert "ghost has no usable pose" in words
    assert content["metrics"]["separation"]["ticks"] < 25
    assert content["metrics"]["separation"]["value"] == pytest.approx(0.3, abs=1e-9)
    assert all(finding in ended.out for finding in content["findings"])


def test_one_robot_alone(cocorosim: Command, tmp_path: Path) -> None:
    """What is undefined for one robot is null in the JSON and a dash in the table."""
    bag = write_foreign(tmp_path / "foreign", {"left": formation()["left"]})
    ended = cocorosim("metrics", bag, "--json", tmp_path / "m.json")
    assert read_json(tmp_path / "m.json")["metrics"]["separation"]["value"] is None
    row = next(line for line in ended.out.splitlines() if line.startswith("│ separation "))
    assert row.split("│")[2].strip() == "-"


def test_recording_that_was_cut_off(cocorosim: Command, tmp_path: Path) -> None:
    """Of a file that ends in the middle the whole chunks are measured, and it is said."""
    whole = (SHIPPED / "bag" / "bag_0.mcap").read_bytes()
    (tmp_path / "cut.mcap").write_bytes(whole[: len(whole) // 2])
    ended = cocorosim("metrics", tmp_path / "cut.mcap", "--json", tmp_path / "m.json")
    assert ended.status == 0, ended.err
    content = read_json(tmp_path / "m.json")
    assert f"{tmp_path}/cut.mcap was not closed: read up to its last whole chunk" in ended.out
    assert 60 < content["ticks"] < 180


@pytest.mark.parametrize("robots", [{}, {"ghost": []}])
def test_without_poses(robots: Any, cocorosim: Command, tmp_path: Path) -> None:
    """One sentence names the recording and what it holds instead; the status is 2 and nothing is written."""
    bag = write_foreign(tmp_path / "talk", robots, extra=("/chatter",))
    ended = cocorosim("metrics", bag, "--json", tmp_path / "m.json")
    assert ended.status == 2
    assert ended.err.startswith(f"cocorosim: {bag} holds no poses: ")
    assert ("/ghost/pose" if robots else "/chatter (std_msgs/msg/String)") in ended.err
    assert ended.err.count("\n") == 1
    assert not (tmp_path / "m.json").exists()


@pytest.mark.parametrize("option", ["--json", "--picture"])
def test_nothing_is_overwritten_unless_forced(
    option: str, cocorosim: Command, run_of_20_seconds: Any, tmp_path: Path
) -> None:
    """A file that exists stays as it is and is named; --force replaces it."""
    file = tmp_path / "mine"
    file.write_text("precious")
    refused = cocorosim("metrics", run_of_20_seconds.bag, option, file)
    assert (refused.status, file.read_text()) == (2, "precious")
    assert refused.err == f"cocorosim: {file} exists already and is not overwritten; choose another name, or --force.\n"
    assert cocorosim("metrics", run_of_20_seconds.bag, option, file, "--force").status == 0
    assert file.read_bytes().startswith({"--json": b"{\n", "--picture": b"\x89PNG"}[option])
    assert [part.name for part in tmp_path.iterdir()] == ["mine"]


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("--json", "nowhere/m.json"), "nowhere/m.json lies in a folder that does not exist"),
        (("--picture", "."), ". is a folder"),
        (("--interval", "0.5"), "--interval' has '0.5', which has no unit"),
        (("--interval", "0 s"), "--interval' has '0 s'; it must be greater than zero"),
        (("--interval", "1e-9 s"), "more than 10000000 moments"),
    ],
)
def test_unusable_options(arguments: tuple[str, str], words: str, cocorosim: Command, run_of_20_seconds: Any) -> None:
    """Each is one sentence on standard error and status 2."""
    ended = cocorosim("metrics", run_of_20_seconds.bag, *arguments)
    assert ended.status == 2
    assert words in ended.err
    assert ended.err.count("\n") == 1
