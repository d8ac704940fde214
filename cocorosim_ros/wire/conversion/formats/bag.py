"""Recordings of ROS 1 and ROS 2, told apart by what is in the files."""

from __future__ import annotations

from pathlib import Path

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.reading.entry import Entry
from cocorosim_ros.wire.bags import bag_metadata
from cocorosim_ros.wire.bags.bag_reader import recording_at
from cocorosim_ros.wire.bags.file_kinds import kind_of, told_of_folder
from cocorosim_ros.wire.conversion.bag_rows import BagRows
from cocorosim_ros.wire.conversion.formats.format import BY_MAP, LogFormat, check_file
from cocorosim_ros.wire.conversion.formats.mcap_messages import McapMessages
from cocorosim_ros.wire.conversion.formats.message_log import MessageLog
from cocorosim_ros.wire.conversion.formats.ros1_messages import Ros1Messages
from cocorosim_ros.wire.conversion.formats.sqlite_messages import SqliteMessages

_SUMMARY = "a bag"
_KINDS = ("mcap", "sqlite", "ros1", "zstd")


class BagLog:
    """A recording of ROS as topics of rows."""

    def __init__(self, messages: MessageLog) -> None:
        self._messages = messages
        self.damage = messages.damage

    def rows(self, topic: str, place: Entry) -> BagRows:
        """The messages of a topic."""
        return BagRows(self._messages, topic, place)


def open_messages(path: Path, said: str = BY_MAP) -> MessageLog:
    """The recording of ROS 1 or ROS 2 at a path. Raises CocorosimError if there is none.

    said: what tells that there is one, as `check_file` has it.
    """
    if not path.is_dir():
        if not path.exists():
            return McapMessages(path)
        check_file(path, path.name, _SUMMARY, _KINDS, said)
        kind = kind_of(path)
        if kind is not None and kind.key == "ros1":
            return Ros1Messages(path)
        if kind is not None and kind.key == "sqlite":
            return SqliteMessages(path.name, [path])
        return McapMessages(path)
    files = _sqlite_files(path)
    if not files and not _has_mcap(path) and (other := told_of_folder(path)):
        raise CocorosimError(f"{path} is not {_SUMMARY}{said}: it {other}.")
    return SqliteMessages(path.name, files) if files else McapMessages(path)


def _open(path: Path) -> BagLog:
    return BagLog(open_messages(path))


def _has_mcap(path: Path) -> bool:
    """Tell whether a folder holds MCAP files, plain or packed, or lists some, or is that of a run."""
    place = recording_at(path)
    return (place / bag_metadata.FILE_NAME).exists() or any(place.glob("*.mcap*"))


def _sqlite_files(folder: Path) -> list[Path]:
    """The .db3 files of a rosbag2 folder in their order; none if it is stored otherwise."""
    if any(folder.glob("*.mcap")):
        return []
    if any(folder.glob("*.db3.zstd")) and not any(folder.glob("*.db3")):
        raise CocorosimError(f"{folder} holds packed SQLite files; unpack them by `unzstd {folder.name}/*.db3.zstd`.")
    found = sorted(folder.glob("*.db3"))
    if not found or not (folder / bag_metadata.FILE_NAME).exists():
        return found
    layout = bag_metadata.read_layout(folder / bag_metadata.FILE_NAME)
    if layout.compression_mode == "message":
        raise CocorosimError(f"{folder} holds SQLite files with packed messages; unpack them by `ros2 bag convert`.")
    named = [folder / name for name in layout.files if (folder / name).is_file()]
    return [*named, *(file for file in found if file not in named)]


BAG = LogFormat(summary=_SUMMARY, kinds=_KINDS, open=_open)
