"""Docstrings and comments say things plainly: no courtroom, no persons for things, a verb or a noun first."""

from __future__ import annotations

import ast
import io
import re
import tokenize
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
PACKAGE = ROOT / "cocorosim_ros"
TESTS = ROOT / "test"
PROOF = [TESTS / "concealer", TESTS / "trial", TESTS / "concealer_tests", TESTS / "trial_tests"]
DIAGNOSIS = PACKAGE / "diagnosis"
COURTROOM = re.compile(
    r"\b(accus\w+|innocen\w+|guilt\w*|blam\w+|quarrel\w*|merits?|culprits?|suspicion\w*|acquit\w*|alibi\w*|testif\w+"
    r"|witness\w*|prosecut\w+)\b",
    re.IGNORECASE,
)
PERSONS = re.compile(
    r"\b(who|whom|whoever|whomever|whosever|whosoever|nobody|somebody|anybody|everybody)\b", re.IGNORECASE
)
NO_HEAD = re.compile(
    r"(Above|After|As|At|Below|Beside|By|For|From|How|If|In|It|Of|On|Once|That|The same|These|They|This|Those|To|Under"
    r"|Until|What|Whatever|When|Where|Whether|Which|Who|Whose|Why|With|Without)\b"
)


def comments(path: Path) -> Iterator[tuple[int, str]]:
    """Line and text of every comment of a module."""
    for token in tokenize.generate_tokens(io.StringIO(path.read_text("utf-8")).readline):
        if token.type == tokenize.COMMENT:
            yield token.start[0], token.string


def docstrings(path: Path) -> Iterator[tuple[int, str]]:
    """Line and text of every docstring of a module, those below constants and fields among them."""
    for node in ast.walk(ast.parse(path.read_text("utf-8"))):
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant) and isinstance(node.value.value, str):
            yield node.lineno, node.value.value


def modules(folder: Path) -> list[Path]:
    """All modules in a folder and its rooms."""
    return sorted(folder.rglob("*.py"))


def places(paths: list[Path], words: re.Pattern[str]) -> list[str]:
    """File, line and word of everything in docstrings and comments that matches."""
    return [
        f"{path.name}:{line}: {match[0]}"
        for path in paths
        for line, text in (*docstrings(path), *comments(path))
        for match in words.finditer(text)
    ]


def written(paths: list[Path], words: re.Pattern[str]) -> list[str]:
    """File, line and word of everything that matches, names and texts among it."""
    return [
        f"{path.name}:{line}: {match[0]}"
        for path in paths
        for line, text in enumerate(path.read_text("utf-8").splitlines(), start=1)
        for match in words.finditer(text.replace("_", " "))
    ]


def test_no_courtroom() -> None:
    """A diagnosis weighs evidence; it accuses nothing, and nothing in it is innocent."""
    tests = [path for path in modules(TESTS) if path != Path(__file__)]
    assert places(modules(PACKAGE) + tests, COURTROOM) == []


def test_no_courtroom_in_the_proof() -> None:
    """Neither in the names and texts of its programs and their tests, nor on the pages that they make."""
    programs = [path for folder in PROOF for path in modules(folder)]
    names = (
        "trial.md",
        "trial.json",
        "trial_families.md",
        "trial_families.json",
        "trial_rov.md",
        "trial_rov.json",
        "trial_slender.md",
        "trial_slender.json",
        "tampered.md",
        "real.md",
        "against.md",
        "against_before.md",
        "against_eighty.md",
        "against_eight.md",
        "against_five.md",
    )
    pages = [ROOT / "docs" / name for name in names]
    found = written([*programs, *pages, TESTS / "trial" / "README.md"], COURTROOM)
    assert found + written(programs, re.compile(r"\bwho(m|so)?ever\b", re.IGNORECASE)) == []


def test_no_persons_for_things() -> None:
    """Things are neither `who` nor `nobody`."""
    assert places(modules(DIAGNOSIS), PERSONS) == []


@pytest.mark.parametrize("path", modules(DIAGNOSIS), ids=lambda path: str(path.relative_to(DIAGNOSIS)))
def test_docstrings_begin_with_a_verb_or_a_noun(path: Path) -> None:
    """A reader who sees the first words alone knows what the text is about."""
    assert [f"{line}: {text[:40]}" for line, text in docstrings(path) if NO_HEAD.match(text)] == []


def test_the_words_are_found_where_they_stand(tmp_path: Path) -> None:
    """Docstrings of modules, functions and fields are searched, and comments; code and other strings are not."""
    planted = tmp_path / "planted.py"
    planted.write_text(
        '"""What it is, whosever."""\nfield = 1.0\n"""Blamed."""\nmerit = "guilt"  # the quarrel\n'
        'def f():\n    """An innocent lag."""\n'
    )
    assert places([planted], COURTROOM) == [
        "planted.py:3: Blamed", "planted.py:6: innocent", "planted.py:4: quarrel"
    ]  # fmt: skip
    assert places([planted], PERSONS) == ["planted.py:1: whosever"]
    assert written([planted], re.compile("merit|guilt")) == ["planted.py:4: merit", "planted.py:4: guilt"]
    assert [text for _, text in docstrings(planted) if NO_HEAD.match(text)] == ["What it is, whosever."]
    planted.write_text("def is_blamed(): ...\n", "utf-8")
    assert written([planted], COURTROOM) == ["planted.py:1: blamed"]
