"""Whether a file may be written: asked before any work."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.foundation.output_file import check_file


def test_a_new_file_in_a_folder_that_exists_and_no_file_at_all_are_fine(tmp_path: Path) -> None:
    """Nothing is said."""
    check_file(tmp_path / "page.html", force=False)
    check_file(None, force=False)


def test_what_is_there_is_replaced_only_by_force(tmp_path: Path) -> None:
    """And asking alone changes nothing."""
    page = tmp_path / "page.html"
    page.write_text("before")
    with pytest.raises(CocorosimError, match=r"page\.html exists already and is not overwritten.*'force'"):
        check_file(page, force=False)
    check_file(page, force=True)
    assert page.read_text() == "before"


@pytest.mark.parametrize(
    ("place", "wrong"), [(".", "is a folder"), ("no/page.html", "in a folder that does not exist")]
)
def test_a_place_where_no_file_can_be_is_refused_even_with_force(tmp_path: Path, place: str, wrong: str) -> None:
    """A folder, and a file in none."""
    with pytest.raises(CocorosimError, match=wrong):
        check_file(tmp_path / place, force=True)


@pytest.mark.parametrize("command", ["report", "view"])
def test_pages_are_refused_before_their_source_is_read(
    cocorosim: Callable[..., Any], tmp_path: Path, command: str
) -> None:
    """There is no source here, and yet it is the page that is spoken of."""
    ended = cocorosim(command, tmp_path / "nothing", "--out", tmp_path / "no" / "page.html")
    assert ended.status == 2
    assert "lies in a folder that does not exist" in ended.err
