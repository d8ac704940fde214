"""Which files belong to which run and to which table of the map."""

from __future__ import annotations

import hashlib
import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from fnmatch import fnmatchcase
from pathlib import Path

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.reading.entry import Entry, listed
from cocorosim_ros.wire.conversion.conversion_map import ConversionMap, TableMap
from cocorosim_ros.wire.conversion.formats import FORMATS
from cocorosim_ros.wire.conversion.formats.format import LogFormat


@dataclass(frozen=True)
class SourceFile:
    """One file for one table of the map."""

    path: Path
    origin: str  # its place below the source's folder, as sentences and the recording show it
    robot: str  # what {robot} stands for in its name, '' without it
    beside: Mapping[str, SourceFile] = field(default_factory=dict)  # of the same run, by the map's names


@dataclass(frozen=True)
class Run:
    """The files of one recording: for each table of the map, in its order."""

    name: str  # what {run} stands for, '' where patterns have none
    files: tuple[tuple[SourceFile, ...], ...]


_ByRun = dict[str, list[SourceFile]]  # by what {run} stands for, '' where a pattern has none


def check_there(mapped: ConversionMap, source: Path) -> None:
    """Nothing, if anything lies at the path. Raises CocorosimError otherwise."""
    if not source.exists():
        chosen = FORMATS[mapped.format]
        wanted = chosen.summary if isinstance(chosen, LogFormat) else "a file or a folder"
        raise CocorosimError(f"{source} does not exist; give {wanted}.")


def find_runs(mapped: ConversionMap, source: Path) -> list[Run]:
    """The runs in a folder, or the one that a file belongs to, sorted by name.

    Raises CocorosimError: no file fits, or the file fits none of the map's patterns.
    """
    if source.is_dir():
        return _runs(mapped, source, "")
    for table in mapped.tables:
        folder = source.absolute().parents[table.source.count("/")]
        match = _pattern(table.source, table.place).fullmatch(source.absolute().relative_to(folder).as_posix())
        if match is not None and (run := match.groupdict().get("run", "")) is not None and fnmatchcase(run, table.runs):
            return _runs(mapped, folder, run, None if "run" in match.groupdict() else source)
    patterns = listed(f"'{table.source}'" for table in mapped.tables)
    raise CocorosimError(f"{source.name} fits no 'files' of {mapped.file}: {patterns}; give a file that does.")


def sha256_of(path: Path) -> str:
    """The sha256 of a file, in hexadecimal digits."""
    with path.open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


def _runs(mapped: ConversionMap, folder: Path, wanted: str, this: Path | None = None) -> list[Run]:
    """The runs of a folder, or the one that is wanted; `this` file alone of tables that it is for."""
    entries = sorted(path for path in _walk(folder, mapped.tables) if path.is_file())
    by_table: list[_ByRun] = []
    beside: list[dict[str, _ByRun]] = []
    for table in mapped.tables:
        found = _fitting(table.source, table.place, entries, folder)
        by_table.append({run: files for run, files in found.items() if not run or fnmatchcase(run, table.runs)})
        beside.append({name: _fitting(each.source, each.place, entries, folder) for name, each in table.beside.items()})
    names = sorted({run for found in by_table for run in found if run}) or [""]
    chosen = [name for name in names if wanted in ("", name)]
    runs = [Run(name, tuple(_files_of(found, name) for found in by_table)) for name in chosen]
    if not any(files for run in runs for files in run.files):
        patterns = listed(f"'{table.source}'" for table in mapped.tables)
        raise CocorosimError(f"{folder} holds no file like {patterns}; give the folder that does, or correct 'files'.")
    if this is not None:
        runs = [_with_this_alone(runs[0], this)]
    return [_with_others(mapped, run, beside) for run in runs]


def _fitting(source: str, place: Entry, entries: Iterable[Path], folder: Path) -> _ByRun:
    """The files that fit a pattern, by run."""
    pattern = _pattern(source, place)
    found: _ByRun = {}
    for path in entries:
        origin = path.relative_to(folder).as_posix()
        match = pattern.fullmatch(origin)
        if match is not None:
            parts = match.groupdict()
            found.setdefault(parts.get("run") or "", []).append(SourceFile(path, origin, parts.get("robot") or ""))
    return found


def _with_others(mapped: ConversionMap, run: Run, beside: Iterable[Mapping[str, _ByRun]]) -> Run:
    """A run, each of its files with those that stand beside it; `beside` is what fits, for each table."""
    tables = []
    for table, files, fitting in zip(mapped.tables, run.files, beside, strict=True):
        others = {name: _files_of(found, run.name) for name, found in fitting.items()}
        tables.append(tuple(_with_its_others(table, file, others) for file in files))
    return Run(run.name, tuple(tables))


def _with_its_others(table: TableMap, file: SourceFile, others: Mapping[str, Iterable[SourceFile]]) -> SourceFile:
    """A file with those that stand beside it. Raises CocorosimError unless there is one of each."""
    chosen = {}
    for name, found in others.items():
        same = [other for other in found if other.robot in ("", file.robot)]
        if len(same) != 1:
            many = f"{len(same)} files" if same else "no file"
            raise table.beside[name].place.problem(
                f"finds {many} like '{table.beside[name].source}' beside {file.origin}; it must be exactly one."
            )
        chosen[name] = same[0]
    return replace(file, beside=chosen)


def _files_of(found: _ByRun, run: str) -> tuple[SourceFile, ...]:
    """The files of a run; those without a run in their name belong to every one."""
    return tuple([*found.get(run, []), *(found.get("", []) if run else [])])


def _walk(folder: Path, tables: Iterable[TableMap]) -> Iterable[Path]:
    sources = [
        source for table in tables for source in (table.source, *(each.source for each in table.beside.values()))
    ]
    depths = {source.count("/") for source in sources}
    for depth in sorted(depths):
        yield from folder.glob("/".join(["*"] * (depth + 1)))


def _pattern(source: str, place: Entry) -> re.Pattern[str]:
    """The pattern of file names: * is anything, {run} and {robot} are anything that is remembered."""
    text = re.escape(source).replace(r"\*", "[^/]*")
    for word in ("run", "robot"):
        first, *others = text.split(re.escape(f"{{{word}}}"))
        if len(others) > 1:
            raise place.problem(f"has {{{word}}} twice in 'files'; write it once.")
        text = first + "".join(f"(?P<{word}>[^/]+?){rest}" for rest in others)
    return re.compile(text)


def _with_this_alone(run: Run, source: Path) -> Run:
    """The run with no other file than the one that was named, in all tables that this is for."""
    mine = [tuple(file for file in files if file.path.absolute() == source.absolute()) for files in run.files]
    return Run(run.name, tuple(alone or files for alone, files in zip(mine, run.files, strict=True)))
