"""Commands that have to compile something first say so, in pipes too, and say nothing where nothing is compiled."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from numba import njit
from rich.console import Console

from cocorosim_ros.commands.compiling_words import compiling_told
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.library.recording import Recording

Command = Callable[..., SimpleNamespace]
SHIPPED = Path(__file__).parents[2] / "bags" / "five_lilys"


def compiling(*arguments: Any, **options: Any) -> None:
    """Compile a new function, as numba does when its cache does not hold it, and give up."""
    if progress := options.get("progress"):
        progress("reading", 0.0)
    njit(lambda x: x + 1.0)(1.0)
    raise CocorosimError("Enough is seen.")


@pytest.mark.parametrize("name", ["metrics", "view", "diagnose"])
def test_a_command_says_that_it_compiles(
    cocorosim: Command, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str
) -> None:
    """The sentence comes before the work is done, and says that it is for once."""
    monkeypatch.setattr(Recording, "measure", compiling)
    monkeypatch.setattr("cocorosim_ros.library.diagnose.diagnose", compiling)
    options = {"metrics": (), "view": ("--no-open", "--out", tmp_path / "page.html")}
    done = cocorosim(name, SHIPPED, *options.get(name, ("--platform", "lily", "--out", tmp_path / "out")))
    part = "the diagnosis" if name == "diagnose" else "the statistics"
    words = [line for line in done.out.splitlines() if "compil" in line]
    assert words == [f"compiling {part} (once per version, about a minute or two)"]


def test_no_word_where_nothing_is_compiled(capsys: pytest.CaptureFixture[str]) -> None:
    """What the cache holds is loaded in silence."""
    with compiling_told(Console(), "the statistics"):
        pass
    assert capsys.readouterr().out == ""
