"""The recipes of CONTRIBUTING.md, followed word by word on a copy of this tree."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

from .documents import ROOT, fenced

ONE_FILE_ONE_LINE = (
    "Add an effect",
    "Add a sensor",
    "Add a sensor that a diagnosis compares",
    "Add an error of a sensor",
)
FILES_CHANGED = 2  # the new one, and that of the table
COPIED = ("cocorosim_ros", "config", "msg_defs", "package.xml")
_HEAD = re.compile(r"# (?P<path>\S+?)(?:, in (?P<table>\w+))?\n")


def section(title: str) -> str:
    """The text of CONTRIBUTING.md below a heading, up to the next one."""
    text = (ROOT / "CONTRIBUTING.md").read_text("utf-8")
    return re.split(r"^## ", text.split(f"## {title}\n", 1)[1], maxsplit=1, flags=re.MULTILINE)[0]


def copy_of_this_tree(folder: Path) -> Path:
    """The package with its configuration, in a folder of its own."""
    folder.mkdir(parents=True, exist_ok=True)
    for name in COPIED:
        source = ROOT / name
        if source.is_dir():
            shutil.copytree(source, folder / name, ignore=shutil.ignore_patterns("__pycache__"))
        else:
            shutil.copy(source, folder / name)
    return folder


def tree_with(recipes: Sequence[str], folder: Path) -> Path:
    """Copy this tree with its tests into a folder, and follow recipes in the copy."""
    copy = copy_of_this_tree(folder)
    shutil.copytree(ROOT / "test", copy / "test", ignore=shutil.ignore_patterns("__pycache__"))
    shutil.copy(ROOT / "pyproject.toml", copy)
    for title in recipes:
        changed = follow(title, copy)
        assert changed, title
        assert len(changed) == FILES_CHANGED or title not in ONE_FILE_ONE_LINE, f"{title}: one file, one line"
    return copy


def python_in(tree: Path) -> Callable[..., str]:
    """Give a function of words and variables of the environment.

    That runs Python with the copy first on its path and a cache of its own, and returns what Python prints.
    """
    own = {"PYTHONPATH": str(tree), "NUMBA_CACHE_DIR": str(tree / "compiled")}

    def run(*words: Any, **environment: str) -> str:
        done = subprocess.run(
            [sys.executable, *map(str, words)],
            cwd=tree,
            env=os.environ | own | environment,
            capture_output=True,
            text=True,
            check=False,
        )
        assert done.returncode == 0, done.stdout + done.stderr
        return done.stdout

    return run


def follow(title: str, tree: Path) -> list[str]:
    """Do what the recipe says; returns the paths that were written or changed."""
    done = []
    for block in fenced(section(title), r"\w*"):
        head = _HEAD.match(block)
        if head is None:
            continue
        file, text = tree / head["path"], block[head.end() :].lstrip("\n")
        if head["table"]:
            file.write_text(with_lines(file.read_text("utf-8"), head["table"], text), encoding="utf-8")
        else:
            assert not file.exists(), f"{head['path']} is there already"
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text, encoding="utf-8")
        done.append(head["path"])
    return done


def with_lines(source: str, table: str, lines: str) -> str:
    """The source with imports at its top and entries at the end of a table, which is a literal over several lines."""
    imports, entries = lines.split("\n\n", 1)
    first = source.index("from cocorosim_ros")
    source = f"{source[:first]}{imports}\n{source[first:]}"
    begin = re.search(rf"^{table}\b[^=\n]*= [({{\[]", source, re.MULTILINE)
    assert begin is not None, f"no table {table}"
    end = re.compile(r"^[)}\]]", re.MULTILINE).search(source, begin.end())
    assert end is not None, f"{table} has no end"
    return (
        source[: end.start()]
        + "".join(f"    {line}\n" for line in entries.strip().splitlines())
        + source[end.start() :]
    )
