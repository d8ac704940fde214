"""YAML files: lines, and one sentence for each way in which a file is unusable."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.reading.entry import Entry
from cocorosim_ros.scenario.reading.yaml_file import load_yaml, parse_yaml, yaml_text


def complaint(path: Path, content: bytes | str) -> str:
    """The sentence about a file with this content."""
    path.write_bytes(content.encode() if isinstance(content, str) else content)
    with pytest.raises(CocorosimError) as caught:
        load_yaml(path)
    return str(caught.value)


def plain(entry: Entry) -> Any:
    """The value without its places."""
    if isinstance(entry.value, dict):
        return {name: plain(part) for name, part in entry.value.items()}
    if isinstance(entry.value, list):
        return [plain(part) for part in entry.value]
    return entry.value


def test_entries_know_line_and_key() -> None:
    """Each value has the line on which it begins and its dotted key."""
    top = parse_yaml("a: 1\nb:\n  c: [x, 2.5]\n", "f.yaml")
    c = top.value["b"].value["c"]
    assert (c.key, c.line, c.file) == ("b.c", 3, "f.yaml")
    assert (c.value[1].key, c.value[1].value) == ("b.c[1]", 2.5)


@pytest.mark.parametrize(
    ("content", "sentence"),
    [
        ("", "is empty"),
        ("# only a comment\n", "is empty"),
        ("- a\n- b\n", "holds a list at its top; a mapping"),
        ("hello\n", "holds only 'hello' at its top"),
        ("a: 1\nb: 2\na: 3\n", "line 3: 'a' appears twice (first on line 1); keep one of them."),
        ("t:\n  a: 1\n  a: 2\n", "line 3: 't.a' appears twice"),
        ("a:\n\tb: 1\n", "line 2 is indented with a tab; YAML allows spaces only there."),
        ("a: [1, 2\nb: 3\n", "is not valid YAML"),
        ("a: 1\n---\nb: 1\n", "is not valid YAML"),
        ("a: &x [1]\nb: *x\n", "is reached through a YAML alias"),
        ("a: &x [*x]\n", "is reached through a YAML alias"),
        ("a: !!python/object:os.system 1\n", "has the YAML tag"),
        ("a: !!python/none 1\n", "has the YAML tag"),
        ("1: x\n", "has a key that is not a word"),
        ("[a]: x\n", "has a key that is not a word"),
        (f"a: {'9' * 5000}\n", "line 1: 'a' has a number that cannot be read"),
        (b"a: \xff\n", "is not UTF-8 text (byte 3 is 0xff); save it as UTF-8."),
    ],
)
def test_unusable_content_is_one_sentence(tmp_path: Path, content: bytes | str, sentence: str) -> None:
    """Every kind of unusable content is told in one line that names the file."""
    told = complaint(tmp_path / "x.yaml", content)
    assert sentence in told
    assert "x.yaml" in told
    assert "\n" not in told


def test_missing_file(tmp_path: Path) -> None:
    """A file that is not there is said to be missing."""
    with pytest.raises(CocorosimError, match=r"nothing\.yaml does not exist; check the path\."):
        load_yaml(tmp_path / "nothing.yaml")


def test_folder_instead_of_file(tmp_path: Path) -> None:
    """A folder is said to be one."""
    with pytest.raises(CocorosimError, match="is a folder; name a YAML file"):
        load_yaml(tmp_path)


def test_unreadable_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A file without permission to read is said to be unreadable, with the system's reason."""
    path = tmp_path / "x.yaml"
    path.write_text("a: 1\n")

    def refuse(*_: object, **__: object) -> str:
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(Path, "read_text", refuse)
    with pytest.raises(CocorosimError, match=r"cannot be read \(Permission denied\); check its name and permissions"):
        load_yaml(path)


def test_path_below_the_working_folder_is_shown_relative(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Sentences name the file as the user would."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "deep").mkdir()
    told = complaint(tmp_path / "deep" / "x.yaml", "")
    assert told.startswith(f"deep{os.sep}x.yaml is empty")


WORDS = st.text(st.characters(codec="utf-8", exclude_categories=("Cs", "Cc")), max_size=12)
LEAVES = st.one_of(
    WORDS,
    st.booleans(),
    st.none(),
    st.integers(-(2**63), 2**63),
    st.floats(allow_nan=False, allow_infinity=False),
)
TREES = st.dictionaries(
    WORDS,
    st.recursive(
        LEAVES,
        lambda inner: st.lists(inner, max_size=3) | st.dictionaries(WORDS, inner, max_size=3),
        max_leaves=12,
    ),
    min_size=1,
    max_size=4,
)


@given(TREES)
def test_text_of_a_tree_reads_back(tree: dict[str, Any]) -> None:
    """Whatever is written as YAML is read back equal, types included."""
    read = plain(parse_yaml(yaml_text(tree), "t"))
    assert repr(read) == repr(tree)
