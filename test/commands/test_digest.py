"""`cocorosim digest`: equal or not, and where not."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from cocorosim_ros.wire.bags.bag_writer import BagWriter, Channel
from cocorosim_ros.wire.cdr.type_store import build, serialize

WORD = "std_msgs/msg/String"
Command = Callable[..., SimpleNamespace]


def record(folder: Path, words: list[str]) -> str:
    """Record the words, one per millisecond; the digest."""
    with BagWriter(folder, [Channel("/word", WORD)]) as bag:
        for index, word in enumerate(words):
            bag.write("/word", index * 10**6, index * 10**6, serialize(build(WORD, {"data": word})))
    return bag.digest.hexdigest()


def test_one_recording(cocorosim: Command, run_of_20_seconds: Any) -> None:
    """One line: the digest that the recording was closed with, and its path."""
    ended = cocorosim("digest", run_of_20_seconds.bag)
    assert (ended.status, ended.out, ended.err) == (0, f"{run_of_20_seconds.digest}  {run_of_20_seconds.bag}\n", "")


def test_topics(cocorosim: Command, run_of_20_seconds: Any) -> None:
    """With --topics one more line for each topic, sorted, with its count and type."""
    lines = cocorosim("digest", run_of_20_seconds.bag, "--topics").out.splitlines()[1:]
    rows = {topic: (count, type_name) for _, count, topic, type_name in map(str.split, lines)}
    assert list(rows) == sorted(run_of_20_seconds.topics)
    assert rows["/lily_03/pose"] == ("40", "geometry_msgs/msg/PoseStamped")
    assert rows["/diagnostics"][0] == "1"


def test_equal_recordings(cocorosim: Command, tmp_path: Path) -> None:
    """Two equal ones have status 0 and are said to be equal."""
    assert record(tmp_path / "one", ["a", "b"]) == record(tmp_path / "two", ["a", "b"])
    ended = cocorosim("digest", tmp_path / "one", tmp_path / "two")
    assert ended.status == 0
    assert ended.out.splitlines()[-1] == f"{tmp_path}/one and {tmp_path}/two are equal."


def test_different_recordings(cocorosim: Command, tmp_path: Path) -> None:
    """Status 1, and the first difference of each one that differs from the first: topic, message, stamp."""
    for name, words in {"one": ["a", "b", "c"], "two": ["a", "b", "c"], "three": ["a", "x", "c"]}.items():
        record(tmp_path / name, words)
    ended = cocorosim("digest", tmp_path / "one", tmp_path / "two", tmp_path / "three")
    assert ended.status == 1
    *_, equal, different = ended.out.splitlines()
    assert equal.endswith("two are equal.")
    assert different.startswith("/word: message 1, stamp 1000000 ns, differs from byte 8 on")


def test_recording_that_was_changed(cocorosim: Command, tmp_path: Path) -> None:
    """A recording with a damaged chunk does not hold what it held when it was closed: status 1, and it is said."""
    digest = record(tmp_path / "one", ["a"] * 50)
    file = tmp_path / "one" / "one_0.mcap"
    data = bytearray(file.read_bytes())
    data[data.index(b"zstd") + 40] ^= 0xFF
    file.write_bytes(data)
    ended = cocorosim("digest", tmp_path / "one")
    assert ended.status == 1
    assert f"had the digest {digest} when it was closed: it was changed or damaged since." in ended.err


@pytest.mark.parametrize("arguments", [(), ("nowhere",)])
def test_nothing_to_read(arguments: tuple[str, ...], cocorosim: Command) -> None:
    """No argument and no such place: one sentence and status 2."""
    ended = cocorosim("digest", *arguments)
    assert (ended.status, ended.err.count("\n")) == (2, 1)
    assert ended.err.startswith("cocorosim: ")
