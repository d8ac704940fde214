"""`cocorosim experiment`: what its bar tells on the way, and what it refuses before it writes anything."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace

import pytest
from rich.console import Console


def test_the_time_left_is_known_between_long_chunks() -> None:
    """Chunks of a long design take more than half a minute each, those of two workers end almost together."""
    from cocorosim_ros.commands.resumed_bar import new_bar

    now = 0.0
    bar, task = new_bar(Console(), "boids", 400, 0, lambda: now)
    for now in (50.0, 50.5, 101.0, 101.5):  # noqa: B007
        bar.advance(task, 45)
    left = bar.tasks[0].time_remaining
    assert left == pytest.approx(101.5 * (400 - 180) / 180, rel=0.02)


def test_the_time_left_of_the_first_chunks_is_no_guess_from_two_that_end_together() -> None:
    """Half a second between the first two says nothing of the rest."""
    from cocorosim_ros.commands.resumed_bar import new_bar

    now = 0.0
    bar, task = new_bar(Console(), "boids", 400, 100, lambda: now)
    for now in (50.0, 50.5):  # noqa: B007
        bar.advance(task, 45)
    assert bar.tasks[0].time_remaining == pytest.approx(50.5 * (300 - 90) / 90, rel=0.02)


UNMADE = """
class Mine:
    def __init__(self):
        {}['gain']
    def __call__(self, sensed):
        return {}
"""


@pytest.mark.parametrize("row", [(), ("--row", "1")], ids=["table", "row"])
def test_a_constructor_that_fails_is_unusable_input(
    cocorosim: Callable[..., SimpleNamespace], tmp_path: Path, row: tuple[str, ...]
) -> None:
    """Status 2 and the user's own line; neither design.json nor a folder for parts is left."""
    (tmp_path / "unmade.py").write_text(UNMADE, "utf-8")
    out = tmp_path / "out"
    ended = cocorosim("experiment", "smoke", "--controller", f"{tmp_path / 'unmade.py'}:Mine", "--out", out, *row)
    assert ended.status == 2, ended.err
    assert "unmade.py:4: KeyError: 'gain'; 'Mine' of lily_01" in ended.err and "could not be made." in ended.err
    assert not out.exists()
