"""Reads a rosbag2 folder or a bare MCAP file, also damaged or unfinished ones, as raw messages."""

from __future__ import annotations

import heapq
import tempfile
from collections.abc import Collection, Iterator
from pathlib import Path
from typing import BinaryIO, NamedTuple

import zstandard

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.wire.bags import bag_metadata
from cocorosim_ros.wire.bags.bag_summary import summarize
from cocorosim_ros.wire.bags.file_kinds import told_of_folder
from cocorosim_ros.wire.bags.mcap_file import McapFile, RawMessage, Watch

RUN_PART = "bag"  # where the folder of a run holds its recording


class RecordedMessage(NamedTuple):
    """One message as it was recorded."""

    topic: str
    type_name: str
    log_time_ns: int
    publish_time_ns: int
    data: bytes


class Bag:
    """An open recording; what it holds is known, its messages are read when they are asked for."""

    def __init__(self, path: Path, files: list[McapFile], damage: list[str], *, packed_messages: bool = False) -> None:
        self.path = path
        self._files = sorted(files, key=lambda file: file.contents.start_ns)
        self._packed_messages = packed_messages
        self.summary = summarize(path, [file.contents for file in self._files], damage)

    def messages(
        self, topics: Collection[str] | None = None, *, in_time_order: bool = False
    ) -> Iterator[RecordedMessage]:
        """The messages of these topics, or of all.

        They come as they were recorded, file after file; or sorted by log time, those of equal time as
        recorded.
        """
        wanted = None if topics is None else frozenset(topics)
        if in_time_order:
            runs = [self._sorted(file, wanted) for file in self._files]
            yield from heapq.merge(*runs, key=lambda message: message.log_time_ns)
            return
        for file in self._files:
            yield from self._selected(file, file.messages(), wanted)

    def _sorted(self, file: McapFile, wanted: frozenset[str] | None) -> Iterator[RecordedMessage]:
        """The messages of a file by log time, no more of them in memory than blocks overlap in time."""
        waiting: list[tuple[int, int, int, RecordedMessage]] = []
        blocks = sorted(enumerate(file.timed_blocks()), key=lambda entry: entry[1][0])
        for number, (start_ns, block) in blocks:
            while waiting and waiting[0][0] < start_ns:
                yield heapq.heappop(waiting)[3]
            for index, message in enumerate(self._selected(file, block, wanted)):
                heapq.heappush(waiting, (message.log_time_ns, number, index, message))
        while waiting:
            yield heapq.heappop(waiting)[3]

    def _selected(
        self, file: McapFile, messages: Iterator[RawMessage], wanted: frozenset[str] | None
    ) -> Iterator[RecordedMessage]:
        names = {
            number: (channel.topic, channel.type_name)
            for number, channel in file.contents.channels.items()
            if wanted is None or channel.topic in wanted
        }
        for number, log_time_ns, publish_time_ns, data in messages:
            if number in names:
                topic, type_name = names[number]
                plain = _unpacked(data, topic, file.path) if self._packed_messages else data
                yield RecordedMessage(topic, type_name, log_time_ns, publish_time_ns, plain)


def check_there(path: Path | str) -> Path:
    """The path, if anything lies there. Raises CocorosimError otherwise."""
    place = Path(path)
    if not place.exists():
        raise CocorosimError(f"{place} does not exist; give a rosbag2 folder or an .mcap file.")
    return place


def recording_at(path: Path | str) -> Path:
    """The file or folder that holds the recording at a path: of the folder of a run, its part."""
    place = Path(path)
    return place / RUN_PART if (place / RUN_PART).is_dir() and not any(place.glob("*.mcap")) else place


def read_bag(path: Path | str, watch: Watch | None = None) -> Bag:
    """The recording at a path: a rosbag2 folder with MCAP files, one MCAP file, or the folder of a run (its `bag`).

    `watch` is told how far the opening of each file is, and later each pass through its messages as recorded.

    Raises CocorosimError if there is no recording, or nothing of it can be read.
    """
    place = check_there(path)
    if not place.is_dir():
        _refuse_sqlite(place, [place])
        return Bag(place, [McapFile(place, watch=watch)], [])
    place = recording_at(place)
    layout = None
    if (place / bag_metadata.FILE_NAME).exists():
        layout = bag_metadata.read_layout(place / bag_metadata.FILE_NAME)
    names = list(layout.files) if layout else []
    names += sorted(file.name for file in place.glob("*.mcap") if file.name not in names)
    _refuse_sqlite(place, [place / name for name in names] or list(place.glob("*.db3*")))
    files, damage = _open_files(place, names, watch)
    return Bag(place, files, damage, packed_messages=layout is not None and layout.compression_mode == "message")


def _open_files(folder: Path, names: list[str], watch: Watch | None) -> tuple[list[McapFile], list[str]]:
    """The files of a folder that can be read, and what is wrong with the others."""
    if not names:
        other = told_of_folder(folder)
        way_out = f"it {other}" if other else "give a rosbag2 folder or an .mcap file"
        raise CocorosimError(f"{folder} holds no .mcap file; {way_out}.")
    files: list[McapFile] = []
    errors: list[CocorosimError] = []
    for name in names:
        try:
            file = folder / name
            files.append(McapFile(file, _unpacked_file(file) if file.suffix == ".zstd" else None, watch))
        except CocorosimError as error:
            errors.append(error)
    if not files:
        raise errors[0]
    return files, [str(error).rstrip(".") for error in errors]


def _refuse_sqlite(place: Path, files: list[Path]) -> None:
    for file in files:
        if ".db3" in file.suffixes:
            raise CocorosimError(
                f"{place} is a recording in SQLite storage ({file.name}), and only MCAP storage is read; "
                f"convert it with "
                f"`rosbags-convert --src {place} --dst NEW_FOLDER --dst-storage mcap` or `ros2 bag convert`."
            )


def _unpacked_file(file: Path) -> BinaryIO:
    """The content of a zstd file in a temporary one, as far as it goes."""
    plain = tempfile.TemporaryFile()  # McapFile closes it
    try:
        with file.open("rb") as packed:
            zstandard.ZstdDecompressor().copy_stream(packed, plain)
    except OSError as error:
        raise CocorosimError(
            f"{file} cannot be read: {error.strerror}; give a rosbag2 folder or .mcap file."
        ) from error
    except zstandard.ZstdError as error:
        if plain.tell() == 0:
            raise CocorosimError(f"{file} is not a zstd file: {error}; record again or give another file.") from error
    plain.flush()
    return plain


def _unpacked(data: bytes, topic: str, file: Path) -> bytes:
    try:
        return zstandard.ZstdDecompressor().decompressobj().decompress(data)
    except zstandard.ZstdError as error:
        raise CocorosimError(
            f"{file} holds a message of {topic} that is not zstd data ({error}), though metadata.yaml says "
            f"so; give the "
            ".mcap file itself instead of its folder."
        ) from error
