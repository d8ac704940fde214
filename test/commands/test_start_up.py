"""What is said at once: help, version and sentences about wrong names come before anything heavy is loaded.

Seconds differ from machine to machine. A few large libraries make them, and whether these were loaded does not differ.
"""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

from cocorosim_ros.commands.main import COMMANDS
from cocorosim_ros.library.explaining.index import every_explanation

HEAVY = ("numba", "llvmlite", "scipy", "matplotlib", "pandas", "pyarrow", "rosbags", "jinja2", "rclpy", "dask", "rerun")
HELP = [*((name, "--help") for name in COMMANDS), ("explain", "lockstep.patience")]
WRONG = {
    ("run", "elephant"): "name of no scenario",
    ("run", "misspelt.yaml"): "did you mean 'tick'",
    ("replay", "elephant"): "does not exist",
    ("calibrate", "elephant"): "does not exist",
    ("view", "elephant"): "does not exist",
    ("metrics", "elephant"): "does not exist",
    ("diagnose", "elephant", "--platform", "lily", "--out", "out"): "does not exist",
    ("diagnose", "elephant", "--platform", "lilly", "--out", "out"): "did you mean 'lily'",
    ("convert", "elephant", ".", "--out", "out"): "name of no map",
    ("experiment", "elephant", "--out", "out"): "name of no design",
    ("report", "elephant"): "holds no experiment",
    ("claims", "elephant"): "holds no experiment",
    ("digest", "elephant"): "does not exist",
    ("check", "elephant"): "does not exist",
    ("new", "platform", "2boats"): "is no name of a platform",
    ("explain", "patiense"): "did you mean patience",
}
PROGRAM = """
import contextlib, io, json, sys
from cocorosim_ros.commands.main import main
heavy, lines = json.loads(sys.argv[1])
said = []
for line in lines:
    words = io.StringIO()
    sys.argv = ["cocorosim", *line]
    with contextlib.redirect_stdout(words), contextlib.redirect_stderr(words):
        try:
            main()
        except SystemExit as ended:
            status = ended.code or 0
    said.append([status, words.getvalue(), [name for name in heavy if name in sys.modules]])
print(json.dumps(said))
"""
Said = dict[tuple[str, ...], tuple[int, str, list[str]]]


@pytest.fixture(scope="module")
def said(tmp_path_factory: pytest.TempPathFactory) -> Said:
    """Of each command line: status, words, and which heavy libraries were there after it; all in one new process."""
    folder = tmp_path_factory.mktemp("start_up")
    scenario = Path(__file__).parents[2] / "config" / "scenarios" / "one_lily.yaml"
    (folder / "misspelt.yaml").write_text(scenario.read_text().replace("\ntick:", "\ntikc:"))
    every_explanation()  # made once for each state of the sources, for the process below too
    lines = [("--help",), ("--version",), *HELP, *WRONG]
    call = [sys.executable, "-c", PROGRAM, json.dumps([HEAVY, lines])]
    done = subprocess.run(call, cwd=folder, capture_output=True, text=True, timeout=120, check=True)
    return dict(zip(lines, map(tuple, json.loads(done.stdout)), strict=True))


@pytest.mark.parametrize("line", [("--help",), ("--version",), *HELP], ids=" ".join)
def test_help_loads_nothing_heavy(said: Said, line: tuple[str, ...]) -> None:
    """What a command can do is said without what it does it with."""
    status, words, loaded = said[line]
    assert status == 0, words
    assert loaded == []


@pytest.mark.parametrize("line", WRONG, ids=" ".join)
def test_wrong_names_load_nothing_heavy(said: Said, line: tuple[str, ...]) -> None:
    """A wrong name, path or key is said without what a right one would have needed."""
    status, words, loaded = said[line]
    assert status == 2, words
    assert WRONG[line] in words
    assert loaded == []
