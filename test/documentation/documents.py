"""The documents of the project, and what stands in them."""

from __future__ import annotations

import re
import shlex
import textwrap
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).parents[2]
NOT_OURS = {".git", ".venv", "runs", "build", "install", "log"}
TEXT_SUFFIXES = {
    "",
    ".md",
    ".py",
    ".yaml",
    ".yml",
    ".toml",
    ".cfg",
    ".xml",
    ".txt",
    ".sh",
    ".msg",
    ".cmake",
    ".rviz",
    ".in",
}


def documents() -> list[Path]:
    """Every Markdown file of the project."""
    return sorted(path for path in own_files() if path.suffix == ".md")


def own_files() -> Iterator[Path]:
    """Every text file that belongs to the project."""
    for path in ROOT.rglob("*"):
        parts = path.relative_to(ROOT).parts
        hidden = any(part in NOT_OURS or part.endswith(("_cache", "__pycache__", ".egg-info")) for part in parts)
        if not hidden and not parts[0].startswith(".") and path.is_file() and path.suffix in TEXT_SUFFIXES:
            yield path


def fenced(text: str, language: str) -> list[str]:
    """The code blocks of a language, also those inside lists."""
    return [
        textwrap.dedent(code) for code in re.findall(rf"^ *```{language}\n(.*?)^ *```", text, re.DOTALL | re.MULTILINE)
    ]


def commands(text: str) -> list[list[str]]:
    """The words of every line of an indented block; `&&` separates, what follows three spaces is a remark."""
    plain = re.sub(r"^ *```.*?^ *```", "", text, flags=re.DOTALL | re.MULTILINE)
    blocks = re.findall(r"(?<=\n\n)(?:    [^\s{].*\n)+", plain)
    shell = [block for block in blocks if not block.split()[0].endswith(":")]  # the others are YAML
    lines = [re.split(r" {3,}", line.strip())[0] for block in shell for line in block.splitlines()]
    return [shlex.split(part) for line in lines for part in line.split("&&")]


def links(text: str) -> list[str]:
    """The targets of all links to files."""
    return [target for target in re.findall(r"\]\(([^)#\s]+)\)", text) if "://" not in target]


def paths_in_code(text: str) -> list[str]:
    """What stands in backticks and looks like a path of this tree, without capitals that stand for a name."""
    tops = "cocorosim_ros|config|test|bags|msg_defs"
    return re.findall(rf"`((?:{tops})/[a-z0-9_./]*)`", text)
