"""The map that a log most probably needs, as YAML, with everything doubtful in comments."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from cocorosim_ros.diagnosis.guessing.actuators import COMMAND, commands_of, together
from cocorosim_ros.diagnosis.guessing.agreement import agreed
from cocorosim_ros.diagnosis.guessing.log_files import tables_of_bag, tables_of_ulog
from cocorosim_ros.diagnosis.guessing.log_table import Guess, LogTable
from cocorosim_ros.diagnosis.guessing.recognising import recognised
from cocorosim_ros.diagnosis.guessing.table_files import ENDINGS, format_of, table_of_file
from cocorosim_ros.diagnosis.guessing.units_by_size import with_units
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.reading.entry import listed
from cocorosim_ros.scenario.reading.yaml_file import yaml_text
from cocorosim_ros.wire.bags.file_kinds import kind_of, told
from cocorosim_ros.wire.bags.poses_of_others import frame_name
from cocorosim_ros.wire.conversion.formats.bag import BAG

_READY = {"dataflash": "ardusub_dataflash", "tlog": "ardusub_tlog"}  # their messages are the same for every vehicle
_ONE = "vehicle"
_ROBOT = re.compile(r"[A-Za-z][A-Za-z0-9_]*")
_BETTER_TYPES = ("nav_msgs/msg/Odometry", "geometry_msgs/msg/PoseWithCovarianceStamped")


@dataclass(frozen=True)
class GuessedMap:
    """A map as text, the streams that it makes (robot, topic, place in the log), and what is not sure, in sentences."""

    text: str
    streams: tuple[tuple[str, str, str], ...]
    doubts: tuple[str, ...]


def guess_map(source: Path, name: str) -> GuessedMap:
    """The map of a log: a bag of ROS 1 or 2, a ULog, or a CSV, Parquet, npz or MATLAB file.

    Raises CocorosimError if it cannot be read, or if nothing in it is recognised.
    """
    kind, tables, doubts = _tables(source)
    by_robot = _robots(tables) if kind == "bag" else {_ONE: list(tables)}
    chosen = {robot: list(_streams(own, doubts)) for robot, own in by_robot.items()}
    if not any(chosen.values()):
        seen = ", ".join(name for table in tables for name in (table.columns if kind not in ("bag", "ulog") else
                         [table.source]))  # fmt: skip
        raise CocorosimError(
            f"Nothing in {source} is recognised (it has {seen[:200] or 'no numbers'}); write a map by hand, "
            "see `cocorosim new map NAME`."
        )
    streams = tuple((robot, guess.topic, guess.table.source) for robot, own in chosen.items() for guess in own)
    own_doubts = [f"{guess.place}: {words}" for own in chosen.values() for guess in own for words in guess.doubts]
    every = tuple(dict.fromkeys([*doubts, *own_doubts]))
    tree = {
        "name": name,
        "description": f"guessed from {source.name}",
        "format": kind,
        "tables": [_entry(robot, table, own) for robot, guesses in chosen.items() for table, own in _by_table(guesses)],
    }
    return GuessedMap(_comments(source, every) + yaml_text(tree), streams, every)


def _tables(source: Path) -> tuple[str, list[LogTable], list[str]]:
    """The format of a log, its tables, and doubts about them."""
    if not source.exists():
        raise CocorosimError(f"{source} does not exist; give a bag, a ULog, or a CSV, Parquet, npz or MATLAB file.")
    if source.is_file() and source.suffix.lower() in ENDINGS:
        table, doubt = table_of_file(source, f"{{run}}{source.suffix}")
        return format_of(source), [table], [f"{source.name}: {doubt}"] if doubt else []
    kind = kind_of(source) if source.is_file() else None
    if kind is not None and kind.key in _READY:
        raise CocorosimError(
            f"{source} is {kind.name}, for which a map ships: "
            f"`cocorosim convert {_READY[kind.key]} {source} --out BAG`."
        )
    if kind is not None and kind.key == "ulog":
        return "ulog", list(tables_of_ulog(source)), []
    if source.is_file() and (kind is None or kind.key not in BAG.kinds):
        endings = listed(sorted(ENDINGS))
        what = f"it {told(kind, source)}" if kind else f"its kind is not known; a table has an ending of {endings}"
        raise CocorosimError(f"{source} is no log that a map can be guessed for: {what}.")
    files = sorted(each for each in source.iterdir() if each.suffix.lower() in ENDINGS) if source.is_dir() else []
    if files and not any(each.suffix in (".mcap", ".db3") for each in source.iterdir()):
        return _tables_of_folder(files)
    return "bag", list(tables_of_bag(source)), []


def _tables_of_folder(files: Sequence[Path]) -> tuple[str, list[LogTable], list[str]]:
    """One table for each set of columns, of the kind of the first file; files with the same columns are runs."""
    kind = format_of(files[0])
    found: dict[tuple[str, ...], tuple[LogTable, str]] = {}
    same: dict[tuple[str, ...], list[Path]] = {}
    for file in (each for each in files if format_of(each) == kind):
        table, doubt = table_of_file(file, file.name)
        same.setdefault(tuple(table.columns), []).append(file)
        found.setdefault(tuple(table.columns), (table, doubt))
    tables, doubts = [], []
    for columns, (table, doubt) in found.items():
        pattern = _pattern(same[columns]) if len(found) == 1 or len(same[columns]) > 1 else table.source
        tables.append(replace(table, source=pattern, where={**table.where, "files": pattern}))
        doubts += [f"{pattern}: {doubt}"] if doubt else []
    return kind, tables, doubts


def _pattern(files: Sequence[Path]) -> str:
    """The beginning and the end that the names of files have in common, with {run} for what stands between."""
    names, ending = [file.stem for file in files], files[0].suffix
    if len(names) == 1:
        return f"{{run}}{ending}"
    head = _shared_beginning(names)
    backwards = [name[len(head) :][::-1] for name in names]
    tail = _shared_beginning([rest[:-1] for rest in backwards])[::-1]  # a character is left for the run
    return f"{head}{{run}}{tail}{ending}"


def _shared_beginning(names: Sequence[str]) -> str:
    shortest = min(names, key=len)
    lengths = range(len(shortest), -1, -1)
    return shortest[: next(length for length in lengths if len({name[:length] for name in names}) == 1)]


def _robots(tables: Sequence[LogTable]) -> dict[str, list[LogTable]]:
    """Topics by robot: each namespace with a pose of its own is one, where there are several."""
    spaces = {table.source.strip("/").partition("/")[0] for table in tables if "/" in table.source.strip("/")}
    own = {space: [table for table in tables if table.source.strip("/").startswith(f"{space}/")] for space in spaces}
    with_pose = sorted(
        space
        for space, inside in own.items()
        if _ROBOT.fullmatch(space) and any(guess.topic == "pose" for table in inside for guess in recognised(table))
    )
    transforms = [table for table in tables if " of " in table.kind]
    if len(with_pose) > 1:
        return {space: own[space] for space in with_pose}
    if not with_pose and len(transforms) > 1:
        return {frame_name(table.kind.partition(" of ")[2]): [table] for table in transforms}
    return {with_pose[0] if with_pose and len(spaces) == 1 else _ONE: list(tables)}


def _streams(tables: Sequence[LogTable], doubts: list[str]) -> Iterator[Guess]:
    """The streams of one robot, each once, with units and axes settled."""
    every = [with_units(guess) for table in tables for guess in recognised(table)]
    best: dict[str, Guess] = {}
    for topic in dict.fromkeys(guess.topic for guess in every):
        best[topic], *others = sorted((guess for guess in every if guess.topic == topic), key=_rank)
        if others:
            names = ", ".join(dict.fromkeys(guess.table.source for guess in others))
            doubts.append(f"{names} could be the {topic}, too; {best[topic].table.source} is taken.")
    yield from agreed(list(best.values()))
    commands = [guess for table in tables for guess in commands_of(table)]
    if not commands:
        doubts.append("No command of a thruster is recognised: without one nothing can be diagnosed.")
    yield from together(commands)


def _rank(guess: Guess) -> tuple[bool, int, int]:
    """Order of preference: with a heading of its own, of a type that is made for it, the most frequent."""
    kind = guess.table.kind
    order = _BETTER_TYPES.index(kind) if kind in _BETTER_TYPES else len(_BETTER_TYPES)
    return bool(guess.fixed), order, -len(guess.table.time)


def _by_table(guesses: Sequence[Guess]) -> list[tuple[LogTable, list[Guess]]]:
    found: dict[int, tuple[LogTable, list[Guess]]] = {}
    for guess in guesses:
        found.setdefault(id(guess.table), (guess.table, []))[1].append(guess)
    return list(found.values())


def _entry(robot: str, table: LogTable, guesses: Sequence[Guess]) -> dict[str, Any]:
    """A table of the map."""
    return {**table.where, "robot": robot, "streams": {guess.topic: _stream(guess) for guess in guesses}}


def _stream(guess: Guess) -> dict[str, Any]:
    numbers = {name: number.entry() for name, number in guess.numbers.items()}
    if guess.topic == COMMAND:
        return {name: {**entry, **guess.fixed[name]} for name, entry in numbers.items()}
    axes = {"axes": "ned_frd"} if guess.north_east_down else {}
    return {**axes, **numbers, **guess.fixed}


def _comments(source: Path, doubts: Sequence[str]) -> str:
    head = f"# Guessed by `cocorosim convert --guess {source.name}`; config/README.md has all keys.\n"
    if not doubts:
        return head
    return head + "# What is not sure:\n" + "".join(f"# - {sentence}\n" for sentence in doubts)
