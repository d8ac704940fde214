"""The drawing of who imports whom."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

FOLDER = str(Path(__file__).resolve().parent)
if FOLDER not in sys.path:
    sys.path.append(FOLDER)
ROOT = Path(__file__).parents[2]


def test_shortcuts_are_left_out_and_circles_are_found() -> None:
    """a -> c follows from a -> b -> c; in a circle every arrow stays."""
    from import_graph import circles, mermaid, without_shortcuts

    straight = {("a", "b"), ("b", "c"), ("a", "c")}
    assert without_shortcuts(straight) == {("a", "b"), ("b", "c")}
    assert circles({"a", "b", "c"}, straight) == set()
    around = {("a", "b"), ("b", "a"), ("b", "c")}
    assert circles({"a", "b", "c"}, around) == {"a", "b"}
    assert without_shortcuts(around) == around
    assert mermaid({"a", "b"}, {("a", "b")}) == "flowchart TD\n    a\n    b\n    a --> b"


def test_the_command_counts_this_package() -> None:
    """No wing and no room of the diagnosis is in a circle."""
    for inside in ("", "diagnosis", "world", "scenario"):
        words = [sys.executable, "test/architecture/import_graph.py", ".", "--inside", inside, "--count"]
        said = subprocess.run(words, cwd=ROOT, capture_output=True, text=True, check=True).stdout
        assert said.rstrip().endswith("in circles: none"), (inside, said)
