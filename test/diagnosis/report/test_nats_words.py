"""Nats are explained where they are first seen, on the page and on the terminal."""

from __future__ import annotations

import io
from collections.abc import Callable
from dataclasses import replace

import pytest
from rich.console import Console

from cocorosim_ros.diagnosis.findings import Diagnosis
from cocorosim_ros.diagnosis.report.nats_words import explained_at_first_sight
from cocorosim_ros.diagnosis.report.terminal_table import terminal_tables

Example = Callable[[str], Diagnosis]
WORDS = ", each of which makes it 2.7 times as likely"


@pytest.mark.parametrize(
    ("page", "explained"),
    [
        ("<p>202 nats.</p><p>3 nats</p>", f"<p>202 nats{WORDS}.</p><p>3 nats</p>"),
        ('<p title="nats">', '<p title="nats">'),
        ("<style>.nats{}</style><b>1 nat</b>", f"<style>.nats{{}}</style><b>1 nat{WORDS}</b>"),
        ("<p>signatures</p>", "<p>signatures</p>"),
    ],
)  # fmt: skip
def test_the_first_mention_is_explained(page: str, explained: str) -> None:
    """Once, in text that is read: neither in a tag nor in a style; a page without nats stays as it is."""
    assert explained_at_first_sight(page) == explained


@pytest.mark.parametrize(("verdict", "told"), [("mismatch", 1), ("nameless", 1), ("recalibrate", 0), ("consistent", 0)])
def test_the_terminal_explains_them_once_above_its_tables(example: Example, verdict: str, told: int) -> None:
    """Where a table has them, and only there."""
    text = on_terminal(example(verdict))
    assert text.count(WORDS) == told
    assert not told or text.index(WORDS) < text.index("\u250f")


def test_the_terminal_explains_those_of_a_remark(example: Example) -> None:
    """A remark has them although nothing was found."""
    found = replace(example("consistent"), remarks=("The form of the drag explains more, by 12 nats.",))
    assert on_terminal(found).count(WORDS) == 1


def on_terminal(diagnosis: Diagnosis) -> str:
    """The tables on a wide terminal."""
    stream = io.StringIO()
    Console(file=stream, width=200).print(terminal_tables(diagnosis))
    return stream.getvalue()
