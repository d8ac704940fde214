"""Every public record of the library shows itself, gives its table as a DataFrame, and has arrays that stay."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterator, Mapping
from dataclasses import fields, is_dataclass
from functools import cached_property
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cocorosim_ros as cocorosim
from cocorosim_ros.diagnosis.checking.finding import Oddity
from cocorosim_ros.library.convert import ConvertedRecording, TopicExtent

SHIPPED = Path(__file__).parents[2] / "bags" / "five_lilys"
NO_RESULTS = {"CocorosimError", "Watch"}  # what is raised, and what is given
NO_TABLES = {"Platform", "Explanation"}  # numbers of many kinds; words
RECORDS = [name for name in cocorosim.__all__ if name[0].isupper() and name not in NO_RESULTS]
EXTENTS = (TopicExtent("lily_01", "pose", 2, 0.5, 2.0, 0.5), TopicExtent("lily_01", "compass", 1, 0.0, None, None))
ODDITY = Oddity("clock", "/imu", "/imu: a stamp of zero.")


def converted() -> ConvertedRecording:
    """One recording of two topics."""
    return ConvertedRecording(Path("out"), "0" * 16, EXTENTS, ("a pose was late",))


MADE: dict[str, Callable[[], Any]] = {
    "CheckedRecording": lambda: cocorosim.CheckedRecording(SHIPPED, (("/imu", "Imu", 9),), (ODDITY, ODDITY)),
    "Conversion": lambda: cocorosim.Conversion("haizhe_auv", (converted(), converted())),
    "ConvertedRecording": converted,
    "Design": lambda: cocorosim.load_design("smoke"),
    "Explanation": lambda: cocorosim.explain("lockstep.patience")[0],
    "Platform": lambda: cocorosim.load_platform("lily"),
    "PoseTrack": lambda: cocorosim.simulate("one_lily", duration=2.0).tracks()["lily_01"],
    "RecordedTrack": lambda: cocorosim.read_recording(SHIPPED).tracks["lily_01"],
    "Recording": lambda: cocorosim.read_recording(SHIPPED),
    "Scenario": lambda: cocorosim.load_scenario("five_lilys"),
    "ShoalStatistics": lambda: cocorosim.measure(SHIPPED),
    "SimulatedRun": lambda: cocorosim.simulate("five_lilys", duration=2.0),
    "TopicReadings": lambda: cocorosim.read_recording(SHIPPED).readings["lily_01"]["imu"],
}
ELSEWHERE = {"DesignResults", "DiagnosisResult", "FleetResult"}  # which take runs and fits: test/library has them shown
ROWS = {
    # what a table has as many rows of as there are
    "CheckedRecording": lambda made: len(made.findings),
    "Conversion": lambda made: 2 * len(EXTENTS),
    "ConvertedRecording": lambda made: len(EXTENTS),
    "Design": lambda made: len(made.cells),
    "PoseTrack": lambda made: len(made.stamp_ns),
    "RecordedTrack": lambda made: len(made.stamp_ns),
    "Recording": lambda made: sum(len(track.stamp_ns) for track in made.tracks.values()),
    "Scenario": lambda made: len(made.robots),
    "ShoalStatistics": lambda made: len(made.stamp_ns),
    "SimulatedRun": lambda made: made.position.shape[0] * len(made.robots),
    "TopicReadings": lambda made: len(made.values),
}


def arrays(value: Any, place: str, seen: set[int]) -> Iterator[tuple[str, Any]]:
    """All arrays that can be reached from a result by its public fields and properties, with the way there."""
    if isinstance(value, np.ndarray):
        yield place, value
    elif isinstance(value, Mapping):
        for name, part in value.items():
            yield from arrays(part, f"{place}[{name!r}]", seen)
    elif isinstance(value, tuple | list):
        for number, part in enumerate(value):
            yield from arrays(part, f"{place}[{number}]", seen)
    elif is_dataclass(value) and not isinstance(value, type) and id(value) not in seen:
        seen.add(id(value))
        for name in public(type(value)):
            yield from arrays(getattr(value, name), f"{place}.{name}", seen)


def public(kind: type) -> list[str]:
    """The public fields and properties of a record, but for the open file of a recording."""
    found = {each.name for each in fields(kind)}  # type: ignore[arg-type]
    for name, part in inspect.getmembers_static(kind):
        if isinstance(part, property | cached_property):
            found.add(name)
    return sorted(name for name in found if not name.startswith("_") and name != "bag")


def test_every_result_is_here() -> None:
    """A new public record has to be made above, or to be shown by tests of its own."""
    assert set(RECORDS) == MADE.keys() | ELSEWHERE
    assert set(MADE) == ROWS.keys() | NO_TABLES


@pytest.mark.parametrize("name", RECORDS)
def test_it_shows_itself_in_its_own_words(name: str) -> None:
    """Text and HTML come from one card, and not from the list of all fields that a dataclass has."""
    record = getattr(cocorosim, name)
    assert record.__repr__.__qualname__ == "Shown.__repr__" and callable(record._repr_html_)
    assert (name in NO_TABLES) != hasattr(record, "to_frame")


@pytest.mark.parametrize("name", MADE)
def test_it_shows_itself(name: str) -> None:
    """A line in a shell, and in a notebook a small page whose elements are closed."""
    made = MADE[name]()
    assert type(made).__name__ == name
    assert len(repr(made)) < 400 and "\n" not in repr(made)
    opened: list[str] = []
    parser = HTMLParser()
    parser.handle_starttag = lambda tag, attributes: opened.append(tag)  # type: ignore[method-assign]
    parser.handle_endtag = opened.remove  # type: ignore[method-assign]
    html = made._repr_html_()
    parser.feed(html)
    assert opened == [] and "<table>" in html and len(html) < 20_000


@pytest.mark.parametrize("name", ROWS)
def test_its_table_is_a_frame(name: str) -> None:
    """One row for each of what it lists, and no column without a name."""
    made = MADE[name]()
    frame = made.to_frame()
    assert len(frame) == ROWS[name](made) > 0
    assert all(isinstance(column, str) and column for column in frame.columns)


@pytest.mark.parametrize("name", MADE)
def test_its_arrays_cannot_be_written_to(name: str) -> None:
    """Those in fields, in properties and in the records and mappings that they hold."""
    found = list(arrays(MADE[name](), name, set()))
    assert [place for place, array in found if array.flags.writeable] == []
    has_arrays = name in ("PoseTrack", "RecordedTrack", "Recording", "ShoalStatistics", "SimulatedRun", "TopicReadings")
    assert bool(found) == has_arrays


def test_what_a_recording_hands_out_is_reached() -> None:
    """The walk sees tracks, readings, series and simulated readings; methods hand out what cannot be written to too."""
    recording, run = MADE["Recording"](), MADE["SimulatedRun"]()
    places = {place for place, _ in (*arrays(recording, "r", set()), *arrays(run, "s", set()))}
    assert {"r.tracks['lily_01'].position", "r.readings['lily_01']['imu'].values", "s.readings['compass']"} <= places
    statistics = run.measure()
    handed = [statistics["polarisation"], recording.readings["lily_01"]["imu"].column("angular_rate_z")]
    handed += [array for track in run.tracks().values() for _, array in arrays(track, "t", set())]
    assert not any(array.flags.writeable for array in handed)


def test_arrays_of_the_user_stay_the_users() -> None:
    """What is measured can still be written to afterwards."""
    stamps, places, yaw = np.arange(2) * 10**9, np.zeros((2, 3)), np.zeros(2)
    cocorosim.measure({"a": cocorosim.PoseTrack(stamps, places, yaw)})
    time, position, heading = np.arange(2.0), np.zeros((2, 1, 3)), np.zeros((2, 1))
    cocorosim.measure(time, position, heading)
    assert all(array.flags.writeable for array in (stamps, places, yaw, time, position, heading))
