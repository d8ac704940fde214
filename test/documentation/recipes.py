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


def python_with(recipes: Sequence[str], tree: Path) -> Callable[..., str]:
    """Follow recipes of one file and one line each in a new copy with its tests, and give a function of words.

    That runs Python with the copy first on its path and a cache of its own, and returns what Python prints.
    """
    copy = copy_of_this_tree(tree)
    shutil.copytree(ROOT / "test", copy / "test", ignore=shutil.ignore_patterns("__pycache__"))
    shutil.copy(ROOT / "pyproject.toml", copy)
    for title in recipes:
        assert len(follow(title, copy)) == 2, f"{title}: one file, one line"
    environment = os.environ | {"PYTHONPATH": str(copy), "NUMBA_CACHE_DIR": str(copy / "compiled")}

    def run(*words: Any) -> str:
        done = subprocess.run(
            [sys.executable, *map(str, words)], cwd=copy, env=environment, capture_output=True, text=True, check=False
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
