"""A recording of a run in Rerun's own loader of MCAP: every topic, every message, every pose in its place."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from rosbags.highlevel import AnyReader

from cocorosim_ros.graph.runs.in_process import run_in_process
from cocorosim_ros.library.record import new_record
from cocorosim_ros.world.checks.loading import load_scenario

Rows = dict[str, list[dict[str, Any]]]
ROBOTS = 5
PARTS = 7  # frames of a Lily that do not move against its hull: two thrusters, five sensors that look in a direction


@pytest.fixture(scope="module")
def file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Five seconds of five Lilys, with what is drawn for viewers."""
    folder, scenario = tmp_path_factory.mktemp("run") / "bag", load_scenario("five_lilys", duration="5 s")
    record = new_record(scenario, folder)
    run_in_process(scenario, record)
    record.close()
    return folder / "bag_0.mcap"


def test_every_topic_is_an_entity_with_its_messages(file: Path, rerun_rows: Callable[[Path], Rows]) -> None:
    """As many rows as `rosbags` counts messages; of transforms one row for each frame."""
    with AnyReader([file.parent]) as reader:
        counts = {connection.topic: connection.msgcount for connection in reader.connections}
    expected = {**counts, "/tf": counts["/tf"] * ROBOTS, "/tf_static": ROBOTS * PARTS}
    assert {topic: len(rows) for topic, rows in rerun_rows(file).items()} == expected


def test_poses_are_in_the_tank_where_the_recording_has_them(file: Path, rerun_rows: Callable[[Path], Rows]) -> None:
    """Rerun draws them: places and frame, as `rosbags` reads them."""
    with AnyReader([file.parent]) as reader:
        poses = [connection for connection in reader.connections if connection.topic == "/lily_03/pose"]
        read = [reader.deserialize(data, kind.msgtype) for kind, _, data in reader.messages(poses)]
    rows = rerun_rows(file)["/lily_03/pose"]
    assert {frame for row in rows for frame in row["CoordinateFrame:frame"]} == {"world"}
    places = np.array([row["InstancePoses3D:translations"][0] for row in rows])
    expected = np.array([[getattr(each.pose.position, axis) for axis in "xyz"] for each in read])
    assert places == pytest.approx(expected, abs=1e-6), "Rerun keeps places in single precision"


def test_rerun_warns_of_nothing(
    file: Path, rerun_rows: Callable[[Path], Rows], capfd: pytest.CaptureFixture[str]
) -> None:
    """No key of the metadata comes twice; Rerun writes its warnings to the standard streams."""
    rerun_rows(file)
    out, err = capfd.readouterr()
    assert "WARN" not in out + err
