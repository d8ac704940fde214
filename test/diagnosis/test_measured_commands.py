"""Commands that a map calls measured: they act when they are logged, so that no delay of theirs is looked for."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES
from cocorosim_ros.diagnosis.evidence.gather import gather_recording
from cocorosim_ros.diagnosis.fitting.candidate import expand
from cocorosim_ros.diagnosis.tracks.make_tracks import make_tracks
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.parts.platform import load_platform
from cocorosim_ros.wire.conversion.conversion import convert
from cocorosim_ros.wire.conversion.map_file import load_map

ROWS = "t,left,right,pump\n" + "".join(f"{k},0.{k % 10},0.5,0\n" for k in range(30))


def converted(folder: Path, *measured: str) -> Any:
    """A recording of a Lily's commands, of which `measured` are said to be."""
    (folder / "log.csv").write_text(ROWS, "utf-8")
    columns = [
        f"{actuator}: {{column: {column}, unit: '1'{', measured: true' if column in measured else ''}}}"
        for actuator, column in zip(load_platform("lily").actuator_names, ("left", "right", "pump"), strict=True)
    ]
    (folder / "map.yaml").write_text(
        "name: told\nformat: csv\ntables:\n  - {files: '*.csv', robot: boat, time: {column: t, unit: s}, "
        f"streams: {{thruster_command: {{{', '.join(columns)}}}}}}}\n",
        "utf-8",
    )
    (done,) = convert(load_map(folder / "map.yaml"), folder / "log.csv", folder / "bag", force=True)
    return done


@pytest.mark.parametrize(
    ("measured", "all_of_them"), [(("left", "right", "pump"), True), (("left", "pump"), False), ((), False)]
)
def test_a_recording_says_that_its_commands_were_measured(
    tmp_path: Path, measured: tuple[str, ...], all_of_them: bool
) -> None:
    """Of all actuators, or not: one that was told what to do may have done it late."""
    done = converted(tmp_path, *measured)
    assert json.loads(done.conversion.metadata.get("measured_commands", "[]")) == ["boat"] * all_of_them
    found = gather_recording(done.folder, load_platform("lily"))
    (log,) = found.robots
    assert log.measured == all_of_them
    assert any("that they act late was not looked for" in remark for remark in found.remarks) == all_of_them


def test_no_delay_is_looked_for_where_commands_were_measured(swim: Any) -> None:
    """Nor is anything else left out; and a robot with orders in one of its recordings may be late there."""
    evidence = swim(load_platform("lily"), 10.0)

    def asked(*measured: bool) -> set[str]:
        (recording,) = evidence.recordings
        told = [
            replace(recording, robots=tuple(replace(log, measured=each) for log in recording.robots))
            for each in measured
        ]
        tracks = make_tracks(replace(evidence, recordings=tuple(told)))
        rows = tracks[0].vehicle.row[None].repeat(len(tracks), axis=0)
        return {candidate.entry.id for candidate in expand(ENTRIES, tracks, rows)}

    assert asked(False) - asked(True) == {"command_delay"}
    assert asked(True, False) == asked(False)


def test_a_measured_that_is_neither_true_nor_false_is_refused(tmp_path: Path) -> None:
    """The place in the map is told."""
    converted(tmp_path, "left")
    text = (tmp_path / "map.yaml").read_text("utf-8").replace("measured: true", "measured: often")
    (tmp_path / "map.yaml").write_text(text, "utf-8")
    with pytest.raises(CocorosimError, match=r"map\.yaml.*measured.*often"):
        load_map(tmp_path / "map.yaml")


def test_what_is_reported_is_measured_anyway(tmp_path: Path) -> None:
    """A report that is called so is refused, with the way out."""
    converted(tmp_path, "left")
    text = (tmp_path / "map.yaml").read_text("utf-8")
    number = "{column: left, unit: '1', measured: true}"
    reported = text.replace("}}}}", "}}, actuator_feedback: {left: {fraction: NUMBER}}}}").replace("NUMBER", number)
    (tmp_path / "map.yaml").write_text(reported, "utf-8")
    with pytest.raises(CocorosimError, match=r"fraction.*says nothing here.*leave it out"):
        load_map(tmp_path / "map.yaml")
