"""`cocorosim check`: status, words and JSON; what is found in which recording is tested with the library."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace

from cocorosim_ros.wire.bags.bag_writer import BagWriter, Channel
from cocorosim_ros.wire.cdr import type_store

Run = Callable[..., SimpleNamespace]
IMU = "sensor_msgs/msg/Imu"


def test_a_sound_recording(cocorosim: Run, run_of_20_seconds: SimpleNamespace) -> None:
    """Nothing odd: status 0, one line."""
    done = cocorosim("check", run_of_20_seconds.bag)
    assert (done.status, len(done.out.splitlines())) == (0, 1)
    assert "nothing odd was found" in done.out


def test_an_odd_recording(cocorosim: Run, tmp_path: Path) -> None:
    """Status 1, a sentence each, and the same for programs."""
    with BagWriter(tmp_path / "bag", [Channel("/imu", IMU)]) as writer:
        for row in range(40):
            message = type_store.build(IMU, {"linear_acceleration": {"z": 1.0}, "orientation": {"w": 1.0}})
            writer.write("/imu", row * 10**8, row * 10**8, type_store.serialize(message))
    done = cocorosim("check", tmp_path / "bag", "--json", "-")
    told = json.loads(done.out)
    assert done.status == 1
    assert {each["kind"] for each in told["findings"]} == {"stamps", "units"}
    assert told["topics"] == [{"topic": "/imu", "type": IMU, "messages": 40}]
    assert all(each["sentence"] in done.err for each in told["findings"])
