"""A first look at any robot's recording, in seconds: what is odd about it, a sentence each."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from cocorosim_ros.diagnosis.checking.covariances import check_covariances
from cocorosim_ros.diagnosis.checking.finding import Oddity
from cocorosim_ros.diagnosis.checking.frozen import check_frozen
from cocorosim_ros.diagnosis.checking.timing import check_timing
from cocorosim_ros.diagnosis.checking.topic_log import TopicLog, read_topics
from cocorosim_ros.diagnosis.checking.transforms import check_transforms
from cocorosim_ros.diagnosis.checking.units import check_depths, check_units
from cocorosim_ros.foundation.card import Card, Shown
from cocorosim_ros.foundation.data_frame import data_frame
from cocorosim_ros.scenario.reading.arguments import Place, place_text
from cocorosim_ros.wire.conversion.formats.bag import open_messages
from cocorosim_ros.wire.conversion.formats.format import UNSAID

if TYPE_CHECKING:
    import pandas as pd


@dataclass(frozen=True, repr=False)
class CheckedRecording(Shown):
    """What is odd about a recording."""

    path: Path
    topics: tuple[tuple[str, str, int], ...]
    """Name, type and number of messages of each topic."""
    findings: tuple[Oddity, ...]
    """Kind, topic and sentence of each oddity; empty where nothing was found."""

    def to_frame(self) -> pd.DataFrame:
        """One row a finding: kind, topic, sentence."""
        names = ("kind", "topic", "sentence")
        return data_frame({name: [getattr(each, name) for each in self.findings] for name in names})

    def card(self) -> Card:
        """How much was looked at, and what was found."""
        facts = {"topics": str(len(self.topics)), "findings": str(len(self.findings))}
        rows = [(each.kind, each.topic, each.sentence) for each in self.findings]
        return Card(f"check of {self.path.name}", facts, ("kind", "topic", "found"), rows)

    def tree(self) -> dict[str, Any]:
        """The same as plain values, for JSON."""
        return {
            "recording": str(self.path),
            "topics": [{"topic": name, "type": kind, "messages": count} for name, kind, count in self.topics],
            "findings": [{"kind": each.kind, "topic": each.topic, "sentence": each.sentence} for each in self.findings],
        }


def check(recording: Place) -> CheckedRecording:
    """Look at any robot's recording without a model: clocks, rates, frozen readings, frames, covariances, units.

    recording: a bag of ROS 1 or ROS 2 (MCAP, SQLite), of whatever messages. Looked for: time that runs backwards,
    stamps of zero, clocks that differ, gaps and rates that drop, readings that stand still, transforms that contradict
    each other or lag, a lost /tf_static, covariances that are none, and units, signs and axes that numbers of standard
    messages (Odometry, Imu, FluidPressure, poses) contradict.

    Returns the findings, a sentence each. Raises CocorosimError if nothing of the recording can be read.

    Example: `[each.sentence for each in check("robot_bag").findings]`.
    """
    path = Path(place_text(recording, "recording"))
    log = open_messages(path, UNSAID)
    topics = tuple(read_topics(log))
    found = (*(Oddity("file", "", sentence) for sentence in log.damage), *_found(topics))
    facts = tuple((topic.name, topic.type_name, len(topic.log_ns)) for topic in topics)
    return CheckedRecording(path, facts, tuple(dict.fromkeys(found)))


def _found(topics: Sequence[TopicLog]) -> Iterator[Oddity]:
    yield from check_timing(topics)
    for topic in topics:
        yield from check_frozen(topic)
        yield from check_covariances(topic)
        yield from check_units(topic)
    yield from check_depths(topics)
    yield from check_transforms(topics)
