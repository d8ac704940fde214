"""What a run says on /diagnostics, as an aggregator takes it."""

from __future__ import annotations

from pathlib import Path

import pytest
from rosbags.typesys import Stores, get_typestore
from ruamel.yaml import YAML

from cocorosim_ros.wire.cdr.status import ANSWERS_MISSING, OK, RUN, WARN, end_of_run, robot_status, status_bytes

AGGREGATOR = Path(__file__).parents[3] / "config" / "diagnostics" / "aggregator.yaml"
STORE = get_typestore(Stores.ROS2_JAZZY)
SAID = {
    "run": end_of_run(500_000_000, 2, 0),
    "answers": status_bytes(0, WARN, ANSWERS_MISSING, "answers are missing at this tick", {"missing": "lily_02"}),
    "lily_02": robot_status(0, "lily_02", "a command from the past is not used"),
}


def told(data: bytes) -> list[tuple[str, int, str, str]]:
    """Name, level, hardware and message of each status, as another reader decodes them."""
    array = STORE.deserialize_cdr(data, "diagnostic_msgs/msg/DiagnosticArray")
    return [(each.name, each.level, each.hardware_id, each.message) for each in array.status]


def test_a_status_tells_the_robot_the_level_and_the_words() -> None:
    """A robot is the hardware of what is said about it; the run has none."""
    assert told(SAID["lily_02"]) == [("cocorosim: lily_02", WARN, "lily_02", "a command from the past is not used")]
    assert told(SAID["run"]) == [(RUN, OK, "", "ended after 2 ticks")]
    assert told(end_of_run(0, 2, 3))[0][1] == WARN


@pytest.mark.parametrize("short", SAID)
def test_the_aggregators_analyzer_takes_each_status(short: str) -> None:
    """One prefix finds all, and what is left of the name is told; what is said once must not turn stale."""
    parameters = YAML(typ="safe").load(AGGREGATOR)["analyzers"]["ros__parameters"]
    analyzer = parameters["cocorosim"]
    (prefix,) = analyzer["find_and_remove_prefix"]
    ((name, *_),) = told(SAID[short])
    assert name.startswith(prefix) and name.removeprefix(prefix) == short
    assert analyzer["type"] == "diagnostic_aggregator/GenericAnalyzer"
    assert analyzer["timeout"] <= 0.0
