"""The metadata.yaml of a rosbag2 folder, in the layout of ROS 2 Jazzy (version 9).

Source: rosbag2_storage/yaml.hpp and qos.cpp of rosbag2, branch jazzy.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from io import StringIO
from pathlib import Path
from typing import Any

from ruamel.yaml import YAML
from ruamel.yaml.error import YAMLError

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.wire.topics.service_quality import ServiceQuality

FILE_NAME = "metadata.yaml"
VERSION = 9
ROS_DISTRIBUTION = "jazzy"
_ROOT = "rosbag2_bagfile_information"


@dataclass(frozen=True)
class TopicEntry:
    """What metadata.yaml says about one topic."""

    name: str
    type_name: str
    type_hash: str
    quality: ServiceQuality
    count: int


@dataclass(frozen=True)
class BagLayout:
    """What metadata.yaml says about how a bag is stored."""

    storage: str  # mcap | sqlite3
    files: tuple[str, ...]  # names inside the folder
    compression_mode: str  # "" | file | message
    custom: Mapping[str, str]


def information(
    file_name: str, topics: Sequence[TopicEntry], start_ns: int, end_ns: int, custom: Mapping[str, str]
) -> dict[str, Any]:
    """The content of metadata.yaml for a bag of one MCAP file, below its root key."""
    count = sum(topic.count for topic in topics)
    start, duration = {"nanoseconds_since_epoch": start_ns}, {"nanoseconds": end_ns - start_ns}
    return {
        "version": VERSION,
        "storage_identifier": "mcap",
        "duration": duration,
        "starting_time": start,
        "message_count": count,
        "topics_with_message_count": [_topic(topic) for topic in topics],
        "compression_format": "",
        "compression_mode": "",
        "relative_file_paths": [file_name],
        "files": [{"path": file_name, "starting_time": start, "duration": duration, "message_count": count}],
        "custom_data": dict(custom) or None,
        "ros_distro": ROS_DISTRIBUTION,
    }


def file_text(content: Mapping[str, Any]) -> str:
    """metadata.yaml as text."""
    return yaml_text({_ROOT: dict(content)})


def yaml_text(content: Any) -> str:
    """Content as YAML in block style, keys in the given order."""
    yaml = YAML(typ="safe", pure=True)
    yaml.default_flow_style = False
    yaml.sort_base_mapping_type_on_output = False  # type: ignore[assignment]
    yaml.representer.ignore_aliases = lambda _: True
    yaml.width = 10_000
    stream = StringIO()
    yaml.dump(content, stream)
    return stream.getvalue()


def read_layout(file: Path) -> BagLayout:
    """How a bag is stored, as its metadata.yaml says. Raises CocorosimError if that file makes no sense."""
    try:
        content = YAML(typ="safe", pure=True).load(file.read_text("utf-8"))[_ROOT]
        return BagLayout(
            str(content["storage_identifier"]),
            tuple(Path(str(path)).name for path in content["relative_file_paths"]),
            str(content.get("compression_mode") or "").lower().replace("none", ""),
            {str(key): str(value) for key, value in (content.get("custom_data") or {}).items()},
        )
    except (OSError, UnicodeDecodeError, YAMLError, KeyError, TypeError, AttributeError) as error:
        reason = " ".join(str(error).split())
        raise CocorosimError(
            f"{file} is not the metadata of a rosbag2 recording ({reason}); give the .mcap file itself "
            f"instead of its "
            "folder."
        ) from error


def _topic(topic: TopicEntry) -> dict[str, Any]:
    metadata = {
        "name": topic.name,
        "type": topic.type_name,
        "serialization_format": "cdr",
        "offered_qos_profiles": [topic.quality.as_rosbag2()],
        "type_description_hash": topic.type_hash,
    }
    return {"topic_metadata": metadata, "message_count": topic.count}
