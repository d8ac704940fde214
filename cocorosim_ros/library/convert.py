"""Other people's logs made into recordings of the contract."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from cocorosim_ros.foundation.arrays import Integers
from cocorosim_ros.foundation.card import Card, Shown, digits
from cocorosim_ros.foundation.data_frame import data_frame
from cocorosim_ros.foundation.input_place import refuse_inputs
from cocorosim_ros.scenario.reading.arguments import Place, function, place_text
from cocorosim_ros.scenario.reading.config_files import find_config

if TYPE_CHECKING:
    import pandas as pd

    from cocorosim_ros.library.recording import Recording
    from cocorosim_ros.wire.conversion.conversion import Converted


@dataclass(frozen=True)
class TopicExtent:
    """How much there is of one topic of one robot."""

    robot: str
    topic: str
    messages: int
    duration: float
    """From the first message to the last [s]."""
    rate: float | None
    """Messages per second on average [Hz]; None where all have one stamp, or there is one alone."""
    longest_gap: float | None
    """Longest time between two messages [s]; None for one alone."""


@dataclass(frozen=True, repr=False)
class ConvertedRecording(Shown):
    """One recording that was made."""

    folder: Path
    digest: str
    topics: tuple[TopicExtent, ...]
    findings: tuple[str, ...]
    """What was left out, sorted or repaired on the way, in sentences."""

    @property
    def messages(self) -> int:
        """How many messages it holds."""
        return sum(extent.messages for extent in self.topics)

    def read(self) -> Recording:
        """The recording, opened. Raises CocorosimError if it is no longer there."""
        from cocorosim_ros.library.recording import read_recording

        return read_recording(self.folder)

    def to_frame(self) -> pd.DataFrame:
        """One row a topic: robot, topic, messages, duration [s], rate [Hz], longest_gap [s]."""
        names = ("robot", "topic", "messages", "duration", "rate", "longest_gap")
        return data_frame({name: [getattr(extent, name) for extent in self.topics] for name in names})

    def card(self) -> Card:
        """Its topics, and what was found on the way."""
        rows = [(each.robot, each.topic, str(each.messages), digits(each.rate)) for each in self.topics]
        facts = {"messages": str(self.messages), "digest": self.digest, "folder": str(self.folder)}
        headings = ("robot", "topic", "messages", "rate [Hz]")
        return Card(f"converted recording {self.folder.name}", facts, headings, rows, self.findings)


@dataclass(frozen=True, repr=False)
class Conversion(Shown):
    """The recordings that were made from one source, one for each of its runs."""

    name: str
    """Of the map."""
    recordings: tuple[ConvertedRecording, ...]

    @property
    def findings(self) -> tuple[str, ...]:
        """What was left out, sorted or repaired; where there are several recordings each sentence names its own."""
        if len(self.recordings) == 1:
            return self.recordings[0].findings
        return tuple(f"{made.folder.name}: {sentence}" for made in self.recordings for sentence in made.findings)

    def to_frame(self) -> pd.DataFrame:
        """One row a topic: recording, robot, topic, messages, duration [s], rate [Hz], longest_gap [s]."""
        rows = [(made.folder.name, extent) for made in self.recordings for extent in made.topics]
        names = ("robot", "topic", "messages", "duration", "rate", "longest_gap")
        columns = {name: [getattr(extent, name) for _, extent in rows] for name in names}
        return data_frame({"recording": [recording for recording, _ in rows], **columns})

    def card(self) -> Card:
        """The topics of each recording."""
        rows = [
            (made.folder.name, extent.robot, extent.topic, str(extent.messages), digits(extent.rate))
            for made in self.recordings
            for extent in made.topics
        ]
        facts = {
            "recordings": str(len(self.recordings)),
            "messages": str(sum(made.messages for made in self.recordings)),
        }
        headings = ("recording", "robot", "topic", "messages", "rate [Hz]")
        return Card(f"conversion by {self.name}", facts, headings, rows, self.findings)


def convert(
    map: Place,
    source: Place,
    out: Place,
    *,
    force: bool = False,
    progress: Callable[[str], None] = lambda run: None,
) -> Conversion:
    """Convert a log as a map says into recordings of the contract.

    map: a name in config/maps, or a file. source: a file or a folder of them (CSV, Parquet, npz, mat), or one log (a
    bag of ROS 1 or 2, ULog, DataFlash, tlog). out: the recording to make, a folder; if the source holds several runs,
    each becomes a recording of its own below it. force: replace what is there. progress: told the name of each run
    before it is read.

    Returns the recordings with the extent of each topic and what was left out. Raises CocorosimError for whatever is
    wrong with map or source, and if `out` exists (without `force`); then nothing is left behind.

    Example: `convert("hovercraft_epfl", "logs", "recordings").recordings[0].read().tracks`.
    """
    function(progress, "progress")
    # Loaded here and one after the other: what is wrong with names and paths is said before the weight comes.
    file = find_config("maps", place_text(map, "map"))
    from cocorosim_ros.wire.conversion.map_file import load_map

    mapped, place, target = load_map(file), Path(place_text(source, "source")), Path(place_text(out, "out"))
    from cocorosim_ros.wire.conversion.sources import check_there

    check_there(mapped, place)
    refuse_inputs(target, [file, place])
    from cocorosim_ros.wire.conversion.conversion import convert as convert_source

    made = convert_source(mapped, place, target, force=force, progress=progress)
    return Conversion(mapped.name, tuple(_described(part) for part in made))


def _described(made: Converted) -> ConvertedRecording:
    stamps: dict[tuple[str, str], list[Integers]] = {}
    for stream in made.conversion.streams:
        stamps.setdefault((stream.robot, stream.topic), []).append(stream.stamp_ns)
    extents = tuple(_extent(*place, np.sort(np.concatenate(parts))) for place, parts in stamps.items())
    return ConvertedRecording(made.folder, made.digest, extents, made.conversion.findings)


def _extent(robot: str, topic: str, stamps: Integers) -> TopicExtent:
    """The extent of a topic from the stamps (n,) [ns] of its messages, ascending."""
    from cocorosim_ros.wire.cdr.primitives import NANOSECONDS

    if len(stamps) < 2:
        return TopicExtent(robot, topic, len(stamps), 0.0, None, None)
    span = float((stamps[-1] - stamps[0]) / NANOSECONDS)
    rate = (len(stamps) - 1) / span if span > 0 else None
    gap = float((np.diff(stamps) / NANOSECONDS).max())
    return TopicExtent(robot, topic, len(stamps), span, rate, gap)
