"""What passes for a recording of a fleet, and when it was made."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import pytest

from cocorosim_ros.diagnosis.fleet import recordings, work
from cocorosim_ros.diagnosis.fleet.dating import dated
from cocorosim_ros.diagnosis.fleet.recordings import FleetRecording, find_recordings
from cocorosim_ros.diagnosis.fleet.work import Job, diagnose_recording
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.parts.platform import load_platform

STAMP = 1_760_000_000_000_000_000


def bag(folder: Path) -> Path:
    """Something that looks like a rosbag2 folder."""
    folder.mkdir(parents=True)
    (folder / "metadata.yaml").write_text("x", "utf-8")
    (folder / "a_0.mcap").write_text("x", "utf-8")
    return folder


def test_recordings_at_any_depth(tmp_path: Path) -> None:
    """Bag folders, folders of runs, bare files and files of other bags; neither other files nor results."""
    bag(tmp_path / "day_1" / "one")
    bag(tmp_path / "day_1" / "run" / "bag")
    (tmp_path / "day_1" / "run" / "picture.png").write_text("x", "utf-8")
    (tmp_path / "two.mcap").write_text("x", "utf-8")
    (tmp_path / "old.db3").write_text("x", "utf-8")
    (tmp_path / "readme.txt").write_text("x", "utf-8")
    bag(tmp_path / "found" / "overlay" / "ghosts")
    (tmp_path / "found" / "diagnosis.json").write_text("{}", "utf-8")
    bag(tmp_path / ".hidden" / "three")
    found = find_recordings(tmp_path)
    assert [each.name for each in found] == ["day_1/one", "day_1/run", "old.db3", "two.mcap"]
    assert [[file.name for file in each.files] for each in found[:2]] == [
        ["day_1/one/a_0.mcap", "day_1/one/metadata.yaml"],
        ["day_1/run/bag/a_0.mcap", "day_1/run/bag/metadata.yaml"],
    ]
    assert found[3].files[0].size == 1


def test_links_are_followed_once(tmp_path: Path) -> None:
    """A folder of links to recordings is a fleet; one that leads back has an end; one to nowhere is listed."""
    elsewhere, fleet = bag(tmp_path / "elsewhere" / "one"), tmp_path / "fleet"
    fleet.mkdir()
    (fleet / "link").symlink_to(elsewhere)
    (fleet / "back").symlink_to(fleet)
    (fleet / "gone.mcap").symlink_to(tmp_path / "nowhere.mcap")
    assert [each.name for each in find_recordings(fleet)] == ["gone.mcap", "link"]


def test_a_folder_that_may_not_be_entered(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """It is listed, so that reading it says what is wrong, and the others are found."""
    bag(tmp_path / "good")
    bag(tmp_path / "closed")
    plain = recordings._is_recording

    def guarded(folder: Path) -> bool:
        if folder.name == "closed":
            raise PermissionError(13, "Permission denied", str(folder))
        return plain(folder)

    monkeypatch.setattr(recordings, "_is_recording", guarded)
    assert [each.name for each in find_recordings(tmp_path)] == ["closed", "good"]


def test_a_pipe_is_no_recording(tmp_path: Path) -> None:
    """Reading it would wait for ever; it is a sentence."""
    os.mkfifo(tmp_path / "pipe.mcap")
    (pipe,) = find_recordings(tmp_path)
    assert "is a pipe or a device and no file" in diagnose_recording(Job(pipe, load_platform("lily"))).problem


def test_what_the_system_refused_is_tried_again(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The file is the same when it may be read at last; one that is broken stays so."""
    job = Job(FleetRecording("a.mcap", tmp_path / "a.mcap", ()), load_platform("lily"))

    def refused(_: Job) -> dict[str, Any]:
        raise CocorosimError("a.mcap cannot be read") from PermissionError(13, "Permission denied")

    monkeypatch.setattr(work, "found_in", refused)
    assert diagnose_recording(job).again
    (tmp_path / "a.mcap").write_text("no recording", "utf-8")
    monkeypatch.undo()
    broken = diagnose_recording(job)
    assert broken.problem and not broken.again


def test_a_file_that_is_written_again_has_another_state(tmp_path: Path) -> None:
    """By its size."""
    bag(tmp_path / "one")
    (before,) = find_recordings(tmp_path)
    assert find_recordings(tmp_path) == (before,)
    (tmp_path / "one" / "a_0.mcap").write_text("longer", "utf-8")
    assert find_recordings(tmp_path)[0].files != before.files


def test_folders_that_are_no_fleet(tmp_path: Path) -> None:
    """Each is a sentence with what to do."""
    file, one, empty = tmp_path / "file", bag(tmp_path / "one"), tmp_path / "empty"
    file.write_text("x", "utf-8")
    empty.mkdir()
    for folder, words in (
        (tmp_path / "missing", "does not exist; give the folder that holds the recordings"),
        (file, "is a file; give the folder"),
        (one, "is a recording itself; give the folder that holds the recordings"),
        (empty, "No recording lies below .*bring other logs into bags with `cocorosim convert`"),
    ):
        with pytest.raises(CocorosimError, match=words):
            find_recordings(folder)


@pytest.mark.parametrize(
    ("stamp", "log", "name", "start", "by"),
    [
        (STAMP, STAMP + 5, "x", STAMP, "stamps"),
        (500, STAMP, "x", STAMP, "log times"),
        (500, 500, "rosbag2_2025_10_09-08_53_20/bag", STAMP, "name"),
        (500, 500, "rosbag2_2025_13_09-08_53_20", None, "nothing"),
        (0, 0, "monday", None, "nothing"),
    ],
)
def test_when_it_was_made(stamp: int, log: int, name: str, start: int | None, by: str) -> None:
    """Stamps first, then log times, then a date in the name that is one; else nothing (2025-10-09 08:53:20 UTC)."""
    assert (dated(stamp, log, name).start_ns, dated(stamp, log, name).by) == (start, by)
