"""What a recording that is read leaves of its files in memory."""

from __future__ import annotations

import random
from pathlib import Path

import pytest

from cocorosim_ros.wire.bags.bag_reader import read_bag
from cocorosim_ros.wire.bags.bag_writer import BagWriter, Channel

pytestmark = pytest.mark.skipif(
    not Path("/proc/self/smaps").exists(), reason="the system does not tell what it keeps of a file"
)


def test_a_long_file_does_not_stay_in_memory(tmp_path: Path) -> None:
    """Of 32 MB that have been opened and read, memory holds less than 6 MB, at the end and in between."""
    data = random.Random(1).randbytes(2**20)  # which no compression makes shorter
    with BagWriter(tmp_path / "bag", [Channel("/a", "std_msgs/msg/UInt8")]) as bag:
        for index in range(32):
            bag.write("/a", index, index, data)
    opened = read_bag(tmp_path / "bag")
    kept = [_kept_of(tmp_path), *(_kept_of(tmp_path) for _ in opened.messages())]
    assert len(kept) == 33 and max(kept) < 6.0


def test_many_small_chunks_do_not_stay_in_memory(tmp_path: Path) -> None:
    """Linux maps what lies around a byte that is looked at: of 8 MB in chunks of 20 kB, most was kept."""
    with BagWriter(tmp_path / "bag", [Channel("/a", "std_msgs/msg/UInt8")]) as bag:
        for index in range(400):
            bag.write("/a", index, index, random.Random(index).randbytes(20_000) + bytes(2**20))
    opened = read_bag(tmp_path / "bag")
    assert len(list(opened.messages())) == 400
    assert _kept_of(tmp_path) < 1.0


def _kept_of(folder: Path) -> float:
    """How much of the files in a folder is in the memory of this process [MB]."""
    kept, mapped = 0.0, False
    for line in Path("/proc/self/smaps").read_text().splitlines():
        if "-" in line.split(" ", 1)[0]:
            mapped = str(folder) in line
        elif mapped and line.startswith("Rss:"):
            kept += int(line.split()[1])
    return kept / 1024
