"""The recording in bags/: made by the command that its README names, whole, and open to independent readers."""

from __future__ import annotations

import json
import platform
from collections import Counter
from importlib.metadata import version
from pathlib import Path

import pytest
from mcap.reader import make_reader
from mcap_ros2.decoder import DecoderFactory
from rosbags.highlevel import AnyReader

from cocorosim_ros.graph.runs.in_process import run_in_process
from cocorosim_ros.graph.runs.run_record import RunRecord
from cocorosim_ros.wire.bags.bag_reader import read_bag
from cocorosim_ros.wire.bags.comparison import bag_digest
from cocorosim_ros.wire.topics.body import describe_body
from cocorosim_ros.world.checks.loading import load_scenario

BAGS = Path(__file__).parents[2] / "bags"
FOLDER = BAGS / "five_lilys"
ROBOTS, TICKS, TOPICS_PER_ROBOT = 5, 240, 9
MESSAGES = TICKS * (ROBOTS * TOPICS_PER_ROBOT + 3) + 1  # clock, tf, statistics; the last word


# By the libraries of bags/five_lilys: `cocorosim run five_jeffs --in-process --duration "20 s"`, `cocorosim digest`.
FIVE_JEFFS = "da3656158814c64b75cf2331dec9ebb7fc059f5a6b62c5c49d78c1f152290a2a"


def digest_of(folder: Path) -> str:
    """The digest with which a recording was closed."""
    return read_bag(folder).summary.metadata["cocorosim"]["digest"]


def are_of_the_recording() -> bool:
    """Whether processor, NumPy and Numba are of the kind that made the recording: last bits differ with others."""
    made_by = json.loads(read_bag(FOLDER).summary.metadata["cocorosim"]["versions"])
    same = all(made_by[name] == version(name) for name in ("numpy", "numba"))
    return same and platform.machine() == "x86_64"


def test_it_is_small_and_the_readme_names_its_command() -> None:
    """Under 2 MB, of the scenario that the command in the README names."""
    assert sum(file.stat().st_size for file in BAGS.rglob("*") if file.is_file()) < 2_000_000
    assert "\n    cocorosim run five_lilys --out bags/five_lilys\n" in (BAGS / "README.md").read_text()
    assert read_bag(FOLDER).summary.metadata["cocorosim"]["scenario"] == load_scenario("five_lilys").to_yaml()


def test_it_is_what_it_was_when_it_was_closed() -> None:
    """Complete, every message there, with the digest that is stored in it."""
    bag = read_bag(FOLDER)
    assert bag.summary.complete
    assert bag.summary.message_count == MESSAGES
    assert bag_digest(bag).hexdigest() == bag.summary.metadata["cocorosim"]["digest"]


def test_made_again_it_says_the_same(tmp_path: Path) -> None:
    """The scenario run anew gives the recorded statistics to 1e-6, and with the same libraries every bit of a Lily.

    With other libraries or another processor the last bits of a sine differ. A difference of 1e-15 at the start grows
    to some 1e-12 in the two minutes of this run.
    """
    scenario = load_scenario("five_lilys")
    record = RunRecord(tmp_path / "bag", [describe_body(robot) for robot in scenario.robots], {})
    with record.writer:
        assert run_in_process(scenario, record) == TICKS
    anew = record.summary()
    if are_of_the_recording():
        assert bag_digest(read_bag(tmp_path / "bag")).hexdigest() == digest_of(FOLDER)
    for name in ("metrics.json", "live_metrics.json"):
        recorded = json.loads((FOLDER / name).read_text())
        assert recorded["ticks"] == anew["ticks"]
        assert recorded["metrics"].keys() == anew["metrics"].keys()
        for metric, entry in recorded["metrics"].items():
            for key in ("value", "mean", "median"):
                assert anew["metrics"][metric][key] == pytest.approx(entry[key], abs=1e-6), (metric, key)


@pytest.mark.skipif(not are_of_the_recording(), reason="other libraries, or another kind of processor")
def test_the_bits_of_a_jeff_are_what_they_were(tmp_path: Path) -> None:
    """Forty ticks of five, whose pumps and thrusters are not a Lily's."""
    scenario = load_scenario("five_jeffs", duration="20 s")
    record = RunRecord(tmp_path / "bag", [describe_body(robot) for robot in scenario.robots], {})
    run_in_process(scenario, record)
    assert record.close() == FIVE_JEFFS


def test_rosbags_opens_it() -> None:
    """An independent reader finds every message and decodes them by the schemas that the recording brings along."""
    counts: Counter[str] = Counter()
    with AnyReader([FOLDER / "bag"]) as reader:
        for connection, time, data in reader.messages():
            message = reader.deserialize(data, connection.msgtype)
            counts[connection.topic] += 1
            if connection.topic == "/lily_05/pose":
                assert message.header.stamp.sec * 10**9 + message.header.stamp.nanosec == time
                assert -2.0 <= message.pose.position.z <= 0.0
    assert sum(counts.values()) == MESSAGES
    assert counts["/lily_05/pose"] == TICKS


def test_mcap_ros2_opens_it() -> None:
    """Another one that knows nothing of ROS's own types decodes all of it by the recorded schemas alone."""
    with (FOLDER / "bag" / "bag_0.mcap").open("rb") as file:
        reader = make_reader(file, validate_crcs=True, decoder_factories=[DecoderFactory()])
        decoded = [entry.decoded_message for entry in reader.iter_decoded_messages()]
    statistics = [message for message in decoded if hasattr(message, "unit")]
    assert len(decoded) == MESSAGES
    assert len(statistics) == TICKS
    assert 0.0 <= statistics[-1].value[statistics[-1].name.index("polarisation")] <= 1.0
