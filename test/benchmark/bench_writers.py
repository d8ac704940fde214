"""What a run without ROS would lose if a library wrote its recording: `python test/benchmark/bench_writers.py`.

The project's own MCAP writer and those of the packages `mcap` and `rosbags` take turns in one process: each round runs
the scenario with every writer, and writes the messages of such a run alone, in an order that changes from round to
round. Figures are CPU time; ratios are taken within a round. All recordings have the same digest, read from the files.
"""

from __future__ import annotations

import argparse
import statistics
import tempfile
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any
from unittest import mock

from conditions import conditions
from mcap.writer import CompressionType, Writer
from rich.console import Console
from rich.table import Table
from rosbags.rosbag2 import CompressionFormat, CompressionMode, StoragePlugin
from rosbags.rosbag2 import Writer as RosbagsWriter

from cocorosim_ros.graph.runs.in_process import run_in_process
from cocorosim_ros.graph.runs.results import recording_metadata
from cocorosim_ros.graph.runs.run_record import RunRecord
from cocorosim_ros.graph.runs.warm_up import compile_everything
from cocorosim_ros.scenario.scenario import Scenario
from cocorosim_ros.wire.bags import bag_writer
from cocorosim_ros.wire.bags.bag_reader import read_bag
from cocorosim_ros.wire.bags.comparison import bag_digest
from cocorosim_ros.wire.bags.mcap_writer import CHUNK_BYTES, McapWriter
from cocorosim_ros.wire.topics.body import describe_body
from cocorosim_ros.world.checks.loading import load_scenario

SCENARIO = "eleven_lilys"
MOST_LOSS = 0.10  # of the speed of a run, for which a library would take the place of our writer
MakesWriter = Callable[..., Any]  # of (path, profile, library): what writes one MCAP file as McapWriter does
Rows = list[tuple[int, int, int, bytes]]  # channel, log time, publish time [ns], CDR


class _Counting:
    """What `BagWriter` wants to know of its writer for metadata.yaml."""

    message_count, start_ns, end_ns = 0, 0, 0

    def __init__(self) -> None:
        self.counts: dict[int, int] = dict.fromkeys(range(1, 1000), 0)

    def close(self) -> None:
        """Nothing is left to be done."""


class OfMcap(_Counting):
    """The writer of the package `mcap` in the place of ours: chunks of the same size, compressed in the same way."""

    def __init__(self, path: Path, profile: str, library: str, *, chunk_bytes: int = CHUNK_BYTES) -> None:
        super().__init__()
        self._file = path.open("xb")
        self._writer = Writer(self._file, chunk_size=chunk_bytes, compression=CompressionType.ZSTD)
        self._writer.start(profile, library)

    def add_schema(self, name: str, encoding: str, data: str) -> int:
        """The number of a new schema."""
        return int(self._writer.register_schema(name, encoding, data.encode()))

    def add_channel(self, topic: str, schema: int, metadata: Mapping[str, str]) -> int:
        """The number of a new channel."""
        return self._writer.register_channel(topic, "cdr", schema, dict(metadata))

    def add_message(self, channel: int, log_time_ns: int, publish_time_ns: int, data: bytes) -> None:
        """Append a message."""
        self._writer.add_message(channel, log_time_ns, data, publish_time_ns)

    def add_metadata(self, name: str, values: Mapping[str, str]) -> None:
        """Write a metadata record."""
        self._writer.add_metadata(name, dict(values))

    def finish(self) -> None:
        """Write the summary and close the file."""
        self._writer.finish()
        self._file.close()


class OfRosbags(_Counting):
    """The writer of the package `rosbags` in the place of ours, with its own size of chunks, in a folder of its own."""

    def __init__(self, path: Path, profile: str, library: str, *, chunk_bytes: int = CHUNK_BYTES) -> None:
        super().__init__()
        self._writer = RosbagsWriter(path.with_suffix(""), version=9, storage_plugin=StoragePlugin.MCAP)
        self._writer.set_compression(CompressionMode.STORAGE, CompressionFormat.ZSTD)
        self._writer.open()
        self._schemas: list[tuple[str, str]] = []
        self._connections: list[Any] = []

    def add_schema(self, name: str, encoding: str, data: str) -> int:
        """The number of a new schema."""
        self._schemas.append((name, data))
        return len(self._schemas) - 1

    def add_channel(self, topic: str, schema: int, metadata: Mapping[str, str]) -> int:
        """The number of a new channel."""
        (name, text), rihs01 = self._schemas[schema], metadata["topic_type_hash"]
        self._connections.append(self._writer.add_connection(topic, name, msgdef=text, rihs01=rihs01))
        return len(self._connections)

    def add_message(self, channel: int, log_time_ns: int, publish_time_ns: int, data: bytes) -> None:
        """Append a message."""
        self._writer.write(self._connections[channel - 1], log_time_ns, data)

    def add_metadata(self, name: str, values: Mapping[str, str]) -> None:
        """Nothing: it has no such records."""

    def finish(self) -> None:
        """Write the summary and close the file."""
        self._writer.close()


WRITERS: dict[str, MakesWriter] = {"ours": McapWriter, "mcap": OfMcap, "rosbags": OfRosbags}


def run_with(writer: MakesWriter, scenario: Scenario, folder: Path) -> float:
    """CPU seconds of a run without ROS, from the end of its first tick to its closed recording."""
    with mock.patch.object(bag_writer, "McapWriter", writer):
        bodies = [describe_body(robot) for robot in scenario.robots]
        record = RunRecord(folder, bodies, recording_metadata(scenario))
        moments: list[float] = []

        def note(tick: int) -> bool:
            moments.append(time.process_time())
            return True

        run_in_process(scenario, record, note)
        record.close()
        return time.process_time() - moments[0]


def write_with(writer: MakesWriter, channels: Sequence[tuple[str, str, str]], rows: Rows) -> float:
    """CPU seconds of writing messages; channels: topic, type and schema of each."""
    with tempfile.TemporaryDirectory() as folder:
        target = writer(Path(folder) / "bag.mcap", "ros2", "benchmark")
        for topic, name, schema in channels:
            target.add_channel(topic, target.add_schema(name, "ros2msg", schema), {"topic_type_hash": "RIHS01_00"})
        start = time.process_time()
        for row in rows:
            target.add_message(*row)
        target.finish()
        return time.process_time() - start


def recorded(folder: Path) -> tuple[list[tuple[str, str, str]], Rows]:
    """The channels and messages of a recording."""
    bag = read_bag(folder)
    channels = [(topic.topic, topic.type_name, topic.schema) for topic in bag.summary.topics]
    numbers = {topic: number for number, (topic, _, _) in enumerate(channels, start=1)}
    rows = [(numbers[part.topic], part.log_time_ns, part.publish_time_ns, part.data) for part in bag.messages()]
    return channels, rows


def digests(folders: Sequence[Path]) -> set[str]:
    """The digests of the recordings in these folders, wherever in them their file is."""
    return {bag_digest(next(folder.rglob("*.mcap"))).hexdigest() for folder in folders}


def show(console: Console, title: str, times: Mapping[str, Sequence[float]], pieces: int) -> None:
    """One table: microseconds per piece, and how the writers compare within each round."""
    table = Table(title=title)
    for head in ("writer", "us, median", "time of ours, median", "least", "most"):
        table.add_column(head, justify="left" if head == "writer" else "right")
    for name, seconds in times.items():
        ratios = [mine / ours for mine, ours in zip(seconds, times["ours"], strict=True)]
        cells = [f"{value:.2f}" for value in (statistics.median(ratios), min(ratios), max(ratios))]
        table.add_row(name, f"{1e6 * statistics.median(seconds) / pieces:.2f}", *cells)
    console.print(table)


@dataclass
class Times:
    """CPU seconds per writer, one of each round."""

    whole: dict[str, list[float]] = field(default_factory=lambda: {name: [] for name in WRITERS})  # of a run
    alone: dict[str, list[float]] = field(default_factory=lambda: {name: [] for name in WRITERS})  # of writing
    messages: int = 0  # in a run


def measure(scenario: Scenario, rounds: int, scratch: Path) -> Times:
    """Let the writers take turns; ends the program if their recordings differ."""
    run_with(McapWriter, scenario, scratch / "first")
    channels, rows = recorded(scratch / "first")
    times = Times(messages=len(rows))
    for round_ in range(rounds):
        names = list(WRITERS)[:: 1 if round_ % 2 == 0 else -1]
        for name in names:
            times.whole[name].append(run_with(WRITERS[name], scenario, scratch / f"{name}_{round_}"))
        for name in names:
            times.alone[name].append(write_with(WRITERS[name], channels, rows))
    if len(digests(list(scratch.iterdir()))) != 1:
        raise SystemExit("the writers have not recorded the same messages, so that their times tell nothing")
    return times


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=9, help="how often each writer has its turn")
    parser.add_argument("--duration", default="300 s", help="length of each run")
    arguments = parser.parse_args()
    console = Console(width=100)
    console.print("\n".join(conditions()), markup=False, highlight=False)
    scenario = load_scenario(SCENARIO, duration=arguments.duration)
    compile_everything(scenario)
    with tempfile.TemporaryDirectory() as scratch:
        times = measure(scenario, arguments.rounds, Path(scratch))
    show(console, f"a run of {SCENARIO} without ROS, per tick", times.whole, scenario.ticks - 1)
    show(console, "writing its messages, per message", times.alone, times.messages)
    for name, seconds in list(times.whole.items())[1:]:
        ratios = [ours / its for its, ours in zip(seconds, times.whole["ours"], strict=True)]
        loss = 1.0 - statistics.median(ratios)
        verdict = f"with {name} a run loses {loss:.0%} of its speed; {MOST_LOSS:.0%} would be the most"
        console.print(verdict, highlight=False)


if __name__ == "__main__":
    main()
