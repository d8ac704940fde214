"""Small logs, maps around them, and what the recording holds afterwards."""

from __future__ import annotations

import sys
from collections.abc import Callable, Mapping
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

Converted = Callable[[str, Path], dict[str, list[Any]]]
HEAD = "name: test\nformat: csv\ntables:\n"


def messages_of(folder: Path) -> dict[str, list[Any]]:
    """All messages of a recording by topic, with the stamp of their header [ns] as `.at`."""
    from cocorosim_ros.wire.bags.bag_reader import read_bag
    from cocorosim_ros.wire.cdr.type_store import deserialize

    found: dict[str, list[Any]] = {}
    for message in read_bag(folder).messages():
        content = deserialize(message.type_name, message.data)
        at = content.header.stamp.sec * 1_000_000_000 + content.header.stamp.nanosec
        assert message.log_time_ns == at
        found.setdefault(message.topic, []).append(SimpleNamespace(at=at, content=content))
    return found


@pytest.fixture
def messages() -> Callable[[Path], dict[str, list[Any]]]:
    """The function that reads a recording back."""
    return messages_of


@pytest.fixture
def convert_csv(tmp_path: Path) -> Callable[..., SimpleNamespace]:
    """Function of (tables, files by name, source in their folder, name of the recording): what came of it."""
    from cocorosim_ros.wire.conversion.conversion import convert
    from cocorosim_ros.wire.conversion.map_file import load_map

    def run(
        tables: str, files: Mapping[str, str], source: str = "", out: str = "bag", **options: Any
    ) -> SimpleNamespace:
        logs = tmp_path / "logs"
        for name, text in files.items():
            (logs / name).parent.mkdir(parents=True, exist_ok=True)
            (logs / name).write_text(text, "utf-8")
        (tmp_path / "map.yaml").write_text(HEAD + tables, "utf-8")
        done = convert(load_map(tmp_path / "map.yaml"), logs / source, tmp_path / out, **options)
        return SimpleNamespace(
            topics=messages_of(done[0].folder) if len(done) == 1 else {},
            findings=done[0].conversion.findings,
            done=done,
        )

    return run


@pytest.fixture
def converted(tmp_path: Path, messages: Callable[[Path], dict[str, list[Any]]]) -> Converted:
    """Function of (map, source): the messages of the recording by topic; every line of the map has to be used."""
    from cocorosim_ros.scenario.reading.config_files import find_config
    from cocorosim_ros.wire.conversion.conversion import convert
    from cocorosim_ros.wire.conversion.map_file import load_map

    def run(name: str, source: Path) -> dict[str, list[Any]]:
        (made,) = convert(load_map(find_config("maps", name)), source, tmp_path / "ours")
        assert made.conversion.findings == ()
        return messages(made.folder)

    return run


@pytest.fixture
def logs() -> SimpleNamespace:
    """What writes DataFlash and MAVLink byte by byte."""
    folder = str(Path(__file__).parents[2] / "contracts")
    if folder not in sys.path:
        sys.path.append(folder)
    import logs_by_format

    return SimpleNamespace(**vars(logs_by_format))
