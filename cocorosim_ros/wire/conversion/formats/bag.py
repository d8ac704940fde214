"""Recordings of ROS 1 and ROS 2, told apart by what is in the files."""

from __future__ import annotations

from pathlib import Path

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.reading.entry import Entry
from cocorosim_ros.wire.bags import bag_metadata
from cocorosim_ros.wire.bags.file_kinds import kind_of
from cocorosim_ros.wire.conversion.bag_rows import BagRows
from cocorosim_ros.wire.conversion.formats.format import LogFormat, check_file
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


def open_messages(path: Path) -> MessageLog:
    """The recording of ROS 1 or ROS 2 at a path. Raises CocorosimError if there is none."""
    if not path.is_dir():
        if not path.exists():
            return McapMessages(path)
        check_file(path, path.name, _SUMMARY, _KINDS)
        kind = kind_of(path)
        if kind is not None and kind.key == "ros1":
            return Ros1Messages(path)
        if kind is not None and kind.key == "sqlite":
            return SqliteMessages(path.name, [path])
        return McapMessages(path)
    files = _sqlite_files(path)
    return SqliteMessages(path.name, files) if files else McapMessages(path)


def _open(path: Path) -> BagLog:
    return BagLog(open_messages(path))


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
