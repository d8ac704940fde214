"""Whoever looks on sees every message of a run, also those that are not recorded."""

from __future__ import annotations

from pathlib import Path

from cocorosim_ros.graph.runs.in_process import run_in_process
from cocorosim_ros.library.record import new_record
from cocorosim_ros.wire.bags.bag_reader import read_bag
from cocorosim_ros.world.checks.loading import load_scenario


class Onlooker:
    """Keeps what it is shown."""

    def __init__(self) -> None:
        self.types: dict[str, str] = {}
        self.shown: list[tuple[str, int, bytes]] = []
        self.latched: set[str] = set()

    def add(self, topic: str, type_name: str, schema: str = "") -> None:
        """A topic is offered."""
        self.types[topic] = type_name

    def send(self, topic: str, stamp_ns: int, data: bytes, *, latched: bool = False) -> None:
        """A message is shown."""
        self.shown.append((topic, stamp_ns, data))
        self.latched |= {topic} if latched else set()


def test_viewers_see_all_that_a_whole_recording_holds(tmp_path: Path) -> None:
    """Topics with their types, and the same bytes at the same times, although the recording is of poses alone."""
    scenario, onlooker = load_scenario("five_lilys", duration="5 s"), Onlooker()
    records = [
        new_record(scenario, tmp_path / "whole"),
        new_record(scenario, tmp_path / "poses", selection=("pose",)),
    ]
    records[1].show_to(onlooker)
    for record in records:
        run_in_process(scenario, record)
        record.close()
    whole = read_bag(tmp_path / "whole")
    assert onlooker.types == whole.summary.types
    assert sorted(onlooker.shown) == sorted((each.topic, each.log_time_ns, each.data) for each in whole.messages())
    descriptions = {topic for topic in onlooker.types if topic.endswith("/robot_description")}
    assert onlooker.latched == {"/tf_static", "/markers/tank", *descriptions}
    assert set(read_bag(tmp_path / "poses").summary.types) == {f"/lily_0{number}/pose" for number in range(1, 6)}
