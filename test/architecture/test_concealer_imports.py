"""The Concealer and the Scorer share no code with the tool that they examine: an import contract, both ways."""

from __future__ import annotations

import ast
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
ALLOWED = {"numpy", "scipy", "numba", "rosbags", "ruamel", "concealer"} | set(sys.stdlib_module_names)
BACK_DOORS = {"__import__", "exec", "eval", "compile"}  # and importlib, runpy, subprocess, below
FORBIDDEN = {"importlib", "runpy", "subprocess", "ctypes"}


def imported(text: str) -> set[str]:
    """Top-level packages that a source text imports; calls that could hide an import count as themselves."""
    found: set[str] = set()
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Import):
            found |= {alias.name.partition(".")[0] for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            found.add("." if node.level else str(node.module).partition(".")[0])
        elif isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in BACK_DOORS:
            found.add(node.func.id)
    return found


def strangers(text: str) -> set[str]:
    """What a file of the Concealer imports and must not."""
    return {name for name in imported(text) if name not in ALLOWED or name in FORBIDDEN}


def test_the_concealer_knows_only_its_own_code_and_public_libraries() -> None:
    """No file of test/concealer imports the tool, or anything but the five libraries it may use."""
    files = sorted((ROOT / "test" / "concealer").rglob("*.py"))
    assert {"physics.py", "score.py", "tamper.py"} <= {file.name for file in files}
    assert {file.name: strangers(file.read_text(encoding="utf-8")) for file in files} == {
        file.name: set() for file in files
    }


@pytest.mark.parametrize(
    ("line", "culprit"),
    [
        ("import cocorosim_ros.world.motion.dynamics", "cocorosim_ros"),
        ("def f():\n    from cocorosim_ros import errors", "cocorosim_ros"),
        ("__import__('cocorosim_ros')", "__import__"),
        ("import importlib", "importlib"),
        ("from . import physics", "."),
        ("import pandas", "pandas"),
    ],
)
def test_a_planted_import_is_found(line: str, culprit: str) -> None:
    """Each way of reaching the tool is noticed."""
    assert strangers(line) == {culprit}


def test_the_tool_does_not_know_the_concealer() -> None:
    """No file of the package imports the Concealer or the tests."""
    for file in sorted((ROOT / "cocorosim_ros").rglob("*.py")):
        assert not imported(file.read_text(encoding="utf-8")) & {"concealer", "test"}, file
