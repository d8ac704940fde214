"""What a result shows of itself: whole HTML, nothing of it from outside, no more rows than can be looked at."""

from __future__ import annotations

import sys
from collections.abc import Callable
from typing import Any

import pytest

from cocorosim_ros.foundation.card import Card, Shown, card_html, card_text, digits
from cocorosim_ros.foundation.data_frame import data_frame
from cocorosim_ros.foundation.errors import CocorosimError


def test_text_is_no_markup(parse: Callable[[str], Any]) -> None:
    """Names of files and robots appear as they are, whatever they hold."""
    nasty = '<script>alert("1 & 2")</script>'
    page = parse(card_html(Card(nasty, {nasty: nasty}, (nasty,), ((nasty,),), (nasty,))))
    assert page.cells == [nasty] * 6
    assert page.elements == ["div", "strong", "table", "tr", "th", "td", "table", "tr", "th", "tr", "td", "p"]


def test_long_tables_are_cut_and_say_so(parse: Callable[[str], Any]) -> None:
    """Twenty rows and eight remarks, and how many more there are."""
    rows = [(f"row {number}",) for number in range(50)]
    page = parse(card_html(Card("long", {}, ("name",), rows, [f"remark {number}" for number in range(10)])))
    assert [cell for cell in page.cells if cell.startswith("row ")] == [f"row {number}" for number in range(20)]
    assert {"30 more rows", "remark 7", "2 more remarks"} <= set(page.cells)
    assert "remark 8" not in page.cells


def test_a_card_without_facts() -> None:
    """The title alone."""
    assert card_text(Card("nothing", {})) == "<nothing>"
    assert card_html(Card("nothing", {})) == "<div><strong>nothing</strong></div>"


@pytest.mark.parametrize(
    ("value", "shown"), [(None, "-"), (float("nan"), "-"), (0.123456, "0.1235"), (12345.6, "1.235e+04")]
)
def test_digits(value: float | None, shown: str) -> None:
    """Four that count; what is undefined is a dash."""
    assert digits(value) == shown


def test_without_pandas_a_frame_is_a_sentence(monkeypatch: pytest.MonkeyPatch) -> None:
    """It says what to install, and what does without."""
    monkeypatch.setitem(sys.modules, "pandas", None)
    with pytest.raises(CocorosimError, match="needs pandas, which is not installed here; run `pip install"):
        data_frame({"time": [0.0]})


def test_a_record_of_what_it_cannot_hold_still_shows_itself() -> None:
    """A debugger and a failing test ask for the text of anything."""

    class Wrong(Shown):
        def card(self) -> Card:
            return Card("wrong", {"sum": [1] + 1})  # type: ignore[dict-item, operator]

    assert "Wrong object at" in repr(Wrong())
