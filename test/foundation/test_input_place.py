"""Inputs are never overwritten, whatever may be replaced."""

from __future__ import annotations

from pathlib import Path

import pytest

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.foundation.input_place import refuse_inputs
from cocorosim_ros.foundation.output_file import check_file


@pytest.mark.parametrize(
    ("place", "read", "found"),
    [
        ("log.csv", "log.csv", "is read by this command"),
        ("bag/x.mcap", "bag", "is a part of .*bag, which is read"),
        ("bag/metadata.yaml", "bag", "is a part of .*bag, which is read"),
        ("found", "found/model.yaml", "holds .*model.yaml, which is read"),
        ("other/../log.csv", "log.csv", "is read"),
        ("link.csv", "log.csv", "is read"),
    ],
)
def test_places_of_inputs(tmp_path: Path, place: str, read: str, found: str) -> None:
    """The same place, one within it, one above it, another way to it, a link."""
    (tmp_path / "link.csv").symlink_to(tmp_path / "log.csv")
    with pytest.raises(CocorosimError, match=f"{found}.*is not replaced, even with 'force'; choose another place"):
        refuse_inputs(tmp_path / place, [tmp_path / "else", tmp_path / read])


def test_places_beside_inputs(tmp_path: Path) -> None:
    """A neighbour whose name begins alike, results within the folder of a recording, and no place at all."""
    refuse_inputs(tmp_path / "bag" / "page.html", [tmp_path / "bag"])
    refuse_inputs(tmp_path / "bag" / "diagnosis", [tmp_path / "bag"])
    refuse_inputs(tmp_path / "bag.html", [tmp_path / "bag"])
    refuse_inputs(None, [tmp_path])


def test_a_file_that_is_read(tmp_path: Path) -> None:
    """Force does not help."""
    (tmp_path / "log.csv").write_text("t,x\n")
    with pytest.raises(CocorosimError, match="is read by this command"):
        check_file(tmp_path / "log.csv", force=True, inputs=[tmp_path / "log.csv"])
