"""What a run writes down: the topics that were asked for, with statistics of all the poses."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.graph.runs.in_process import run_in_process
from cocorosim_ros.graph.runs.run_record import RunRecord, Selection, run_topics, selected_topics
from cocorosim_ros.graph.runs.scenery import Scenery
from cocorosim_ros.scenario.scenario import Scenario
from cocorosim_ros.wire.bags.bag_reader import read_bag
from cocorosim_ros.wire.bags.comparison import bag_digest
from cocorosim_ros.wire.topics.body import describe_body
from cocorosim_ros.world.checks.loading import load_scenario


@pytest.fixture
def scenario() -> Scenario:
    """Eleven Lilys for three ticks."""
    return load_scenario("eleven_lilys", duration="1.5 s")


@pytest.fixture
def record(scenario: Scenario, tmp_path: Path) -> Callable[[str, Selection], dict[str, int]]:
    """Function of a name and a selection of topics: messages per topic of such a run."""

    def run(name: str, selection: Selection) -> dict[str, int]:
        bodies = [describe_body(robot) for robot in scenario.robots]
        recorded = RunRecord(tmp_path / name, bodies, {}, selection=selection)
        assert run_in_process(scenario, recorded) == 3
        recorded.close()
        counts: dict[str, int] = {}
        for message in read_bag(tmp_path / name).messages():
            counts[message.topic] = counts.get(message.topic, 0) + 1
        return counts

    return run


def test_a_selection_is_all_that_is_recorded(record: Callable[[str, Selection], dict[str, int]]) -> None:
    """Names stand for the topics of all robots, full names for one; everything else is left out."""
    everything = record("all", "all")
    assert len(everything) == 11 * 9 + 4
    chosen = record("some", ("pose", "/lily_03/compass", "/shoal_statistics"))
    expected = {f"/lily_{number:02d}/pose": 3 for number in range(1, 12)}
    assert chosen == {**expected, "/lily_03/compass": 3, "/shoal_statistics": 3}


def test_scenery_is_recorded_and_changes_nothing_else(scenario: Scenario, tmp_path: Path) -> None:
    """What holds all the time comes first and once, markers every 2 s; digest and all other messages stay the same."""
    bodies = [describe_body(robot) for robot in scenario.robots]
    bags = []
    for name, scenery in (("plain", None), ("drawn", Scenery.of(scenario))):
        recorded = RunRecord(tmp_path / name, bodies, {}, scenery=scenery)
        run_in_process(scenario, recorded)
        recorded.close()
        bags.append(read_bag(tmp_path / name))
    plain, drawn = ([(each.topic, each.log_time_ns, each.data) for each in bag.messages()] for bag in bags)
    standing = ["/tf_static", *(f"/lily_{number:02d}/robot_description" for number in range(1, 12)), "/markers/tank"]
    assert [topic for topic, _, _ in drawn[: len(standing)]] == standing
    assert [topic for topic, _, _ in drawn].count("/markers/swarm") == 1
    assert [each for each in drawn if each[0] not in {*standing, "/markers/swarm"}] == plain
    digests = [bag.summary.metadata["cocorosim"]["digest"] for bag in bags]
    assert digests[0] == digests[1] == bag_digest(bags[1]).hexdigest()


def test_scenery_can_be_left_out(scenario: Scenario) -> None:
    """Its topics can be named in a selection, and are left out of one that does not name them."""
    topics = {**run_topics([describe_body(robot) for robot in scenario.robots]), **Scenery.of(scenario).topics}
    chosen = selected_topics(topics, ("pose", "robot_description", "/markers/swarm"))
    assert len(chosen) == 11 + 11 + 1


def test_a_selection_must_fit(scenario: Scenario) -> None:
    """A name that is no topic is named, and so are missing poses of one robot."""
    topics = run_topics([describe_body(robot) for robot in scenario.robots])
    with pytest.raises(CocorosimError, match="'sonar', which is no topic of this run"):
        selected_topics(topics, ("pose", "sonar"))
    with pytest.raises(CocorosimError, match="has no poses"):
        selected_topics(topics, ("/lily_01/pose", "compass"))


def test_a_run_can_be_ended_at_any_tick(scenario: Scenario, tmp_path: Path) -> None:
    """What was done until then is whole: every topic has as many messages as ticks were run."""
    recorded = RunRecord(tmp_path / "bag", [describe_body(robot) for robot in scenario.robots], {})
    assert run_in_process(scenario, recorded, lambda tick: tick < 2) == 2
    recorded.close()
    topics = [message.topic for message in read_bag(tmp_path / "bag").messages()]
    assert topics.count("/lily_11/radio_tx") == topics.count("/clock") == topics.count("/shoal_statistics") == 2
    assert topics.count("/diagnostics") == 1
