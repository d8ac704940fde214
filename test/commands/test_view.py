"""`cocorosim view`: a page that plays the recording, opened in a browser or not."""

from __future__ import annotations

import json
import re
import subprocess
import sys
import webbrowser
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any
from urllib.parse import urlparse
from urllib.request import url2pathname

import pytest
from rosbags.rosbag2 import StoragePlugin, Writer

from cocorosim_ros.wire.bags.bag_reader import read_bag
from cocorosim_ros.wire.bags.bag_writer import BagWriter, Channel
from cocorosim_ros.wire.cdr.type_store import type_store

Command = Callable[..., SimpleNamespace]
SHIPPED = Path(__file__).parents[2] / "bags" / "five_lilys"


@pytest.fixture
def opened(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """The addresses that were opened in a browser."""
    addresses: list[str] = []

    def open_page(address: str) -> bool:
        addresses.append(address)
        return len(addresses) == 1

    monkeypatch.setattr(webbrowser, "open", open_page)
    return addresses


def test_a_page_is_written_and_opened(
    cocorosim: Command, opened: list[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Without --out a temporary file that stays; where no browser is, that is said."""
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    for words in (False, True):
        result = cocorosim("view", SHIPPED)
        assert result.status == 0, result.err
        page = Path(url2pathname(urlparse(opened[-1]).path))
        assert str(page) in result.out
        assert ("no browser was found here" in result.out) == words
        text = page.read_text("utf-8")
        assert all(f'"lily_0{number}"' in text for number in range(1, 6))
        assert "five_lilys" in text
    assert len(set(opened)) == 2


def test_a_file_of_ones_own(cocorosim: Command, opened: list[str], tmp_path: Path) -> None:
    """--no-open opens nothing; what is there is replaced with --force alone."""
    page = tmp_path / "page.html"
    assert cocorosim("view", SHIPPED / "bag", "--out", page, "--no-open").status == 0
    page.write_text("a letter")
    refused = cocorosim("view", SHIPPED, "--out", page, "--no-open")
    assert refused.status == 2
    assert f"{page} exists already and is not overwritten" in refused.err
    assert page.read_text() == "a letter"
    assert cocorosim("view", SHIPPED, "--out", page, "--no-open", "--force").status == 0
    assert page.read_text("utf-8").startswith("<!doctype html>")
    assert opened == []


def empty_bag(folder: Path) -> Path:
    """A recording without poses, by the independent writer."""
    with Writer(folder, version=9, storage_plugin=StoragePlugin.MCAP) as writer:
        connection = writer.add_connection("/name", "std_msgs/msg/String", typestore=type_store())
        writer.write(connection, 5, b"\x00\x01\x00\x00\x02\x00\x00\x00a\x00")
    return folder


def test_unusable_input(cocorosim: Command, opened: list[str], tmp_path: Path) -> None:
    """One sentence and status 2, no page and no browser: no recording, no poses, a folder that is not there."""
    (tmp_path / "note.txt").write_text("no bag")
    cases: list[tuple[tuple[Any, ...], str]] = [
        ((tmp_path / "nowhere",), "nowhere"),
        ((tmp_path / "note.txt",), "note.txt"),
        ((empty_bag(tmp_path / "empty"),), "empty holds no poses: it has /name (std_msgs/msg/String)"),
        ((SHIPPED, "--out", tmp_path / "none" / "page.html"), "page.html lies in a folder that does not exist"),
        ((SHIPPED, "--out", tmp_path), "is a folder"),
    ]
    for arguments, words in cases:
        result = cocorosim("view", *arguments)
        assert result.status == 2, result.out
        assert words in result.err
        assert result.err.count("\n") == 1, result.err
    assert opened == []
    assert not list(tmp_path.rglob("*.html"))


def test_a_damaged_recording(cocorosim: Command, opened: list[str], tmp_path: Path) -> None:
    """It is shown up to where it can be read, and both terminal and page say so."""
    whole = (SHIPPED / "bag" / "bag_0.mcap").read_bytes()
    broken = tmp_path / "broken.mcap"
    broken.write_bytes(whole[: len(whole) // 2])
    result = cocorosim("view", broken, "--out", tmp_path / "page.html")
    assert result.status == 0, result.err
    assert "broken.mcap" in result.out
    assert '<p class="finding">' in (tmp_path / "page.html").read_text("utf-8")
    assert len(opened) == 1


def test_a_scene_in_three_dimensions(
    cocorosim: Command, opened: list[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """--3d writes what Rerun opens, alone or beside another; nothing is replaced unasked, and no page is opened."""
    pytest.importorskip("rerun")
    started: list[list[str]] = []
    begin = subprocess.Popen

    def idle(line: list[str], **_: object) -> subprocess.Popen[bytes]:
        started.append(line)
        return begin([sys.executable, "-c", ""])

    monkeypatch.setattr("subprocess.Popen", idle)
    alone, both = tmp_path / "alone.rrd", tmp_path / "both.rrd"
    assert cocorosim("view", SHIPPED, "--3d", "--out", alone, "--no-open").status == 0
    assert started == []
    result = cocorosim("view", SHIPPED, "--3d", "--against", SHIPPED / "bag", "--out", both)
    assert result.status == 0, result.err
    assert alone.read_bytes()[:4] == both.read_bytes()[:4] == b"RRF2", "how files of Rerun begin"
    assert [line[1:] for line in started] == [["-m", "rerun", "--bind", "127.0.0.1", str(both)]]
    assert "Rerun's viewer ended" not in result.out
    assert cocorosim("view", SHIPPED, "--3d", "--out", alone, "--no-open").status == 2
    assert opened == []


def test_a_scene_without_rerun(cocorosim: Command, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A sentence with both ways out; two recordings without --3d are refused with one, too."""
    monkeypatch.setattr("importlib.util.find_spec", lambda name: None)
    cases = [
        (("--3d",), ("package rerun, which is not installed", "cocorosim[view]", "leave out --3d")),
        (("--against", SHIPPED), ("add --3d",)),
    ]
    for options, words in cases:
        result = cocorosim("view", SHIPPED, *options, "--out", tmp_path / "out", "--no-open")
        assert result.status == 2, result.out
        assert all(part in result.err for part in words), result.err
        assert result.err.count("\n") == 1, result.err
    assert not list(tmp_path.iterdir())


def test_the_page_has_the_metrics(cocorosim: Command, opened: list[str], tmp_path: Path) -> None:
    """Six curves of 240 moments, float32 in base64: 960 bytes are 1280 letters."""
    page = tmp_path / "page.html"
    assert cocorosim("view", SHIPPED, "--out", page, "--no-open").status == 0
    held = re.search(r'id="recording">(.*?)</script>', page.read_text("utf-8"), re.DOTALL)
    assert held is not None
    curves = json.loads(held[1])["curves"]
    assert [len(curve["mean"]) for curve in curves] == [1280] * 6


@pytest.mark.parametrize(
    ("before", "after", "words"),
    [("duration: ", "dqration: ", "'dqration' is not a known key"), ("seed: ", "weather: calm\nseed: ", "'weather'")],
    ids=["a flipped bit", "a newer version's key"],
)
def test_a_scenario_that_cannot_be_read(
    cocorosim: Command, run_of_20_seconds: SimpleNamespace, tmp_path: Path, before: str, after: str, words: str
) -> None:
    """The poses are whole, so the page is written without the tank; a sentence says why, on the page too."""
    bag = read_bag(run_of_20_seconds.bag)
    made_from = dict(bag.summary.metadata["cocorosim"])
    made_from["scenario"] = made_from["scenario"].replace(before, after, 1)
    channels = [Channel(each.topic, each.type_name) for each in bag.summary.topics]
    with BagWriter(tmp_path / "bag", channels, metadata=made_from) as writer:
        for message in bag.messages():
            writer.write(message.topic, message.log_time_ns, message.publish_time_ns, message.data)
    page = tmp_path / "page.html"
    done = cocorosim("view", tmp_path / "bag", "--out", page, "--no-open")
    assert done.status == 0, done.err
    assert words in done.out
    assert "cannot be read, so its tank is not shown" in done.out
    assert "cannot be read, so its tank is not shown" in page.read_text("utf-8")
    assert cocorosim("metrics", tmp_path / "bag", "--picture", tmp_path / "shoal.png").status == 0
