"""Tables that a log may lack, and numbers that a formula leaves out: what a map may say of them."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace

import pytest

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.wire.conversion.map_file import load_map

Convert = Callable[..., SimpleNamespace]
TABLE = "{topic: /a, optional: WORD, robot: boat, streams: {compass: {heading: {column: data, unit: rad}}}}"


def read(folder: Path, word: str, kind: str = "bag") -> tuple[bool, frozenset[str]]:
    """What the map says of its table."""
    (folder / "map.yaml").write_text(f"name: m\nformat: {kind}\ntables:\n  - {TABLE.replace('WORD', word)}\n")
    (table,) = load_map(folder / "map.yaml").tables
    return table.optional, table.unless


def test_what_it_may_say(tmp_path: Path) -> None:
    """Yes, no, and in place of what."""
    assert read(tmp_path, "true") == (True, frozenset())
    assert read(tmp_path, "false") == (False, frozenset())
    assert read(tmp_path, "{unless: pose}") == (True, frozenset({"pose"}))
    assert read(tmp_path, "{unless: [pose, compass]}") == (True, frozenset({"pose", "compass"}))


@pytest.mark.parametrize(
    ("word", "sentence"),
    [
        ("perhaps", r"map.yaml line 4: 'tables\[0\].optional' has 'perhaps'; write true or false"),
        ("{unless: poses}", r"optional.unless' has 'poses'; did you mean 'pose'"),
        ("{unless: [pose, speed]}", r"has 'speed'; allowed: pose, compass"),
        ("{}", "lacks 'unless'"),
    ],
)
def test_what_it_may_not_say(word: str, sentence: str, tmp_path: Path) -> None:
    """Place, what was found, what is allowed."""
    with pytest.raises(CocorosimError, match=sentence):
        read(tmp_path, word)


def test_files_are_told_without_it(convert_csv: Convert) -> None:
    """A map of files needs no such key: a file that is missing is a remark there."""
    table = (
        "  - {{files: {0}.csv, time: {{column: t, unit: s}}, robot: boat, "
        "streams: {{{1}: {{{2}: {{column: x, unit: {3}}}}}}}{4}}}\n"
    )
    tables = table.format("a", "compass", "heading", "rad", "") + table.format("b", "velocity", "x", "m/s", "")
    assert convert_csv(tables, {"a.csv": "t,x\n0,1\n"}).findings == (
        "No file fits 'b.csv', so its topics are missing.",
    )
    with pytest.raises(CocorosimError, match="optional' is not a known key"):
        convert_csv(table.format("a", "compass", "heading", "rad", ", optional: true"), {"a.csv": "t,x\n0,1\n"})


def test_missing_is_no_number(convert_csv: Convert) -> None:
    """Rows where a formula says so are left out, and said; nothing else may have that name."""
    table = (
        "  - {files: a.csv, time: {column: t, unit: s}, robot: boat, "
        'streams: {velocity: {x: {formula: "where(ok, u, missing)", unit: m/s}}}}\n'
    )
    found = convert_csv(table, {"a.csv": "t,u,ok\n0,1,1\n1,2,0\n2,3,1\n"})
    assert [each.content.twist.linear.x for each in found.topics["/boat/velocity"]] == [1, 3]
    assert found.findings == ("boat/velocity from a.csv: 1 row with missing or infinite numbers was left out.",)
    named = table.replace("robot: boat", "names: {missing: u}, robot: boat")
    with pytest.raises(CocorosimError, match=r"names.missing' is no short name of a column"):
        convert_csv(named, {"a.csv": "t,u,ok\n0,1,1\n"})
