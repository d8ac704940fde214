"""The files of a diagnosis appear together and whole, or not at all."""

from __future__ import annotations

from pathlib import Path

import pytest

from cocorosim_ros.diagnosis.report.output_folder import check_folder, write_folder
from cocorosim_ros.foundation.errors import CocorosimError

TEXTS = {"diagnosis.json": "{}\n", "model.yaml": "name: a\n", "report.html": "\u00b5"}


def test_files_are_written_into_a_folder_that_is_made(tmp_path: Path) -> None:
    """All files, nothing beside them."""
    folder = tmp_path / "a" / "b"
    check_folder(folder, force=False)
    write_folder(folder, TEXTS)
    assert {path.name: path.read_text("utf-8") for path in folder.iterdir()} == TEXTS


def test_a_folder_that_cannot_be_made_is_said_before(tmp_path: Path) -> None:
    """Below a file nothing can be made; one that can is not left behind by the question."""
    (tmp_path / "file").write_text("mine")
    with pytest.raises(CocorosimError, match=r"cannot be written: Not a directory; give another one with 'out'"):
        check_folder(tmp_path / "file" / "below", force=False)
    check_folder(tmp_path / "a" / "b", force=False)
    assert [each.name for each in tmp_path.iterdir()] == ["file"]


def test_an_older_diagnosis_needs_force(tmp_path: Path) -> None:
    """Without it the sentence names the file and 'force'; what has come beside it since is no hindrance."""
    check_folder(tmp_path, force=False)
    write_folder(tmp_path, {"model.yaml": "old"})
    (tmp_path / "notes.txt").write_text("mine")
    with pytest.raises(CocorosimError, match=r"model\.yaml exists already.*'force'"):
        check_folder(tmp_path, force=False)
    check_folder(tmp_path, force=True)
    write_folder(tmp_path, TEXTS)
    assert (tmp_path / "model.yaml").read_text() == "name: a\n"
    assert (tmp_path / "notes.txt").read_text() == "mine"


@pytest.mark.parametrize("force", [False, True])
def test_a_folder_of_other_files(tmp_path: Path, force: bool) -> None:
    """Nobody asked for a diagnosis among them; what a killed one has left is none."""
    (tmp_path / ".model.yaml.partial").write_text("na")
    check_folder(tmp_path, force=force)
    (tmp_path / "notes.txt").write_text("mine")
    with pytest.raises(CocorosimError, match=r"holds 'notes\.txt', which is no part of a diagnosis.*with 'out'"):
        check_folder(tmp_path, force=force)


def test_a_file_is_no_folder(tmp_path: Path) -> None:
    """Neither as the folder nor above it."""
    (tmp_path / "file").write_text("mine")
    with pytest.raises(CocorosimError, match="is a file"):
        check_folder(tmp_path / "file", force=True)
    with pytest.raises(CocorosimError, match="cannot be written"):
        write_folder(tmp_path / "file" / "below", TEXTS)
    assert [path.name for path in tmp_path.iterdir()] == ["file"]


def test_a_failure_leaves_nothing_behind(tmp_path: Path) -> None:
    """A file that cannot be written takes the others and the new folders with it."""
    with pytest.raises(CocorosimError, match="cannot be written"):
        write_folder(tmp_path / "new" / "er", {**TEXTS, "no/such/folder.txt": "x"})
    assert list(tmp_path.iterdir()) == []
