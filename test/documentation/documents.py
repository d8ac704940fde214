"""The documents of the project, and what stands in them."""

from __future__ import annotations

import re
import shlex
import textwrap
from collections.abc import Iterator
from dataclasses import dataclass
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
    ".cff",
    ".bib",
    ".ipynb",
    ".xml",
    ".txt",
    ".sh",
    ".msg",
    ".cmake",
    ".rviz",
    ".in",
}
_BLOCK = re.compile(
    r"^ *```(?P<language>\S*)\n(?P<code>[\s\S]*?)^ *```$|(?<=\n\n)(?P<lines>(?:    [^\s{].*\n)+)", re.MULTILINE
)


@dataclass(frozen=True)
class Block:
    """A piece of a page that is no prose. `language` of a fence is its word, of indented lines "shell"."""

    language: str
    code: str

    @property
    def file(self) -> str:
        """The name in a first line such as `# map.yaml`: a file that the reader is to write; "" if there is none."""
        head = re.match(r"# (\w+\.\w+)\n", self.code)
        return head[1] if head else ""

    @property
    def commands(self) -> list[list[str]]:
        """The words of every line of a shell; `&&` separates, what follows three spaces is a remark."""
        if self.language != "shell" or self.code.split()[0].endswith(":"):  # the latter is YAML
            return []
        lines = [re.split(r" {3,}", line.strip())[0] for line in self.code.splitlines()]
        return [shlex.split(part) for line in lines for part in line.split("&&")]


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


def blocks(text: str) -> Iterator[Block]:
    """All fenced blocks and blocks of indented lines of a page, in their order."""
    for found in _BLOCK.finditer(text):
        if found["lines"] is None:
            yield Block(found["language"], textwrap.dedent(found["code"]))
        else:
            yield Block("shell", textwrap.dedent(found["lines"]))


def fenced(text: str, language: str) -> list[str]:
    """The code blocks of a language, also those inside lists."""
    fences = [block for block in blocks(text) if block.language != "shell"]
    return [block.code for block in fences if re.fullmatch(language, block.language)]


def commands(text: str) -> list[list[str]]:
    """The words of every command that stands in a block of indented lines."""
    return [words for block in blocks(text) for words in block.commands]


def links(text: str) -> list[str]:
    """The targets of all links to files."""
    return [target for target in re.findall(r"\]\(([^)#\s]+)(?:#[^)\s]*)?\)", text) if "://" not in target]


def paths_in_code(text: str) -> list[str]:
    """What stands in backticks and looks like a path of this tree, without capitals that stand for a name."""
    tops = "cocorosim_ros|config|test|bags|msg_defs"
    return re.findall(rf"`((?:{tops})/[a-z0-9_./]*)`", text)
