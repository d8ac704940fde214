"""CSV, Parquet, npz and MATLAB files as tables: how text is written, which column is the time."""

from __future__ import annotations

import codecs
import re
from collections.abc import Iterator, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any, Protocol

import numpy as np

from cocorosim_ros.diagnosis.criteria.guessing import GUESSING
from cocorosim_ros.diagnosis.guessing.column_names import is_time, tokens_and_unit
from cocorosim_ros.diagnosis.guessing.log_table import LogTable
from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.reading.entry import Entry
from cocorosim_ros.scenario.reading.quantity import UNITS
from cocorosim_ros.wire.bags.file_kinds import kind_or_table
from cocorosim_ros.wire.conversion.conversion_map import CsvLayout
from cocorosim_ros.wire.conversion.csv_rows import refuse_utf16
from cocorosim_ros.wire.conversion.formats import FORMATS
from cocorosim_ros.wire.conversion.formats.format import BY_NAME, FileFormat, check_file

ENDINGS = {".csv": "csv", ".txt": "csv", ".tsv": "csv", ".dat": "csv", ".log": "csv", ".parquet": "parquet",
           ".npz": "npz", ".mat": "mat"}  # fmt: skip
_SEPARATORS = (",", ";", "\t", "|", " ")
_SMALL = ("s", "ms", "us", "ns")  # units in which loggers count
_NUMBER = re.compile(r"[-+]?\d*[.,]?\d+([eE][-+]?\d+)?")


class _NamedRows(Protocol):
    """Rows whose columns have names."""

    @property
    def columns(self) -> tuple[str, ...]:
        """The names."""

    def numbers(self, column: Entry) -> Floats:
        """(n,) the cells of a column."""


def table_of_file(path: Path, pattern: str) -> tuple[LogTable, str]:
    """The table of a file, and a doubt about its time; `pattern` stands for its name in the map.

    Raises CocorosimError for a file that has no columns with names, or no time.
    """
    name = format_of(path)
    chosen = FORMATS[name]
    if not isinstance(chosen, FileFormat):
        raise TypeError(f"{path.suffix} is no table")
    check_file(path, path.name, chosen.summary, chosen.kinds, BY_NAME)
    layout = _layout(path) if name == "csv" else CsvLayout()
    columns = dict(_columns(chosen.rows(path, path.name, layout)))
    clock, unit, doubt = _time(path, columns)
    factor = float(UNITS["time"][unit])
    time = columns.pop(clock) * factor
    where: dict[str, Any] = {"files": pattern, "time": {"column": clock, "unit": unit}, **_layout_entry(layout)}
    if (np.diff(time) < 0).any():
        where["backwards"] = "sort"
        doubt = f"{doubt} Some rows run backwards in time and are sorted.".strip()
    return LogTable(pattern, "", time - np.nanmin(time), columns, where), doubt


def format_of(path: Path) -> str:
    """The format of a table: what the file is by how it begins, or else what its ending says."""
    kind = kind_or_table(path)
    return kind.key if kind is not None and kind.key in ENDINGS.values() else ENDINGS[path.suffix.lower()]


def _columns(rows: _NamedRows) -> Iterator[tuple[str, Floats]]:
    for name in rows.columns:
        try:
            yield name, rows.numbers(Entry(name, "", 0, ""))
        except CocorosimError:  # words, which are no number of any stream
            continue


def _time(path: Path, columns: Mapping[str, Floats]) -> tuple[str, str, str]:
    """The column of the time, its unit, and what is doubtful."""
    rising = [name for name, values in columns.items() if _rises(values)]
    named = [name for name in rising if is_time(name)]
    if not rising:
        raise CocorosimError(
            f"{path.name} has no column that rises from row to row, so nothing tells the time; write 'row_rate' into a "
            "map by hand, see `cocorosim new map NAME`."
        )
    chosen = (
        min(named, key=lambda name: ("stamp" not in name.lower(), list(columns).index(name))) if named else rising[0]
    )
    doubt = "" if named else f"The time is taken from '{chosen}', the first column that rises."
    unit, sure = _unit_of_time(chosen, columns[chosen])
    return chosen, unit, doubt if sure else f"{doubt} The time is taken to be in {unit}.".strip()


def _rises(values: Floats) -> bool:
    steps = np.diff(values[np.isfinite(values)])
    return bool(steps.size) and bool(np.median(steps) > 0.0) and float(np.mean(steps < 0.0)) < GUESSING.rising


def _unit_of_time(name: str, values: Floats) -> tuple[str, bool]:
    """The unit of a time, and whether its name or its size tells."""
    unit = tokens_and_unit(name)[1]
    if unit in UNITS["time"]:
        return unit, True
    first = float(values[np.isfinite(values)][0])
    for unit, factor in UNITS["time"].items():
        if GUESSING.epoch < first * float(factor) < GUESSING.later and unit in _SMALL:
            return unit, True
    step = float(np.nanmedian(np.diff(values)))
    for unit in _SMALL:
        tick = step * float(UNITS["time"][unit])
        if GUESSING.shortest_tick <= tick <= GUESSING.longest_tick:
            return unit, False
    return "s", False


def _layout(path: Path) -> CsvLayout:
    """Layout of a CSV file by its first lines."""
    plain = CsvLayout()
    try:
        text = path.read_bytes()[: 1 << 16]
    except OSError as error:
        raise CocorosimError(f"{path} cannot be read: {error.strerror}; check its name and permissions.") from error
    refuse_utf16(text, path.name)
    encoding = "utf-8" if _is_utf8(text) else "latin-1"
    lines = [line for line in text.decode(encoding, "replace").splitlines()[: GUESSING.head_lines] if line.strip()]
    comment = "#" if lines and lines[0].startswith("#") and len(lines) > 1 and not lines[1].startswith("#") else ""
    kept = [line for line in lines if not comment or not line.startswith(comment)]
    separator = max(_SEPARATORS, key=lambda mark: _fields(kept, mark)) if kept else ","
    cells = [cell.strip() for cell in (kept[0].split(separator) if kept else [])]
    if kept and all(_NUMBER.fullmatch(cell) for cell in cells):
        raise CocorosimError(
            f"{path.name} has no header, so nothing tells what its columns are; write a map by hand, see "
            "`cocorosim new map NAME`, where columns may be numbers."
        )
    body = kept[1].split(separator) if len(kept) > 1 else []
    decimal = "," if separator != "," and any(re.fullmatch(r"\s*-?\d+,\d+\s*", cell) for cell in body) else "."
    return replace(plain, separator=separator, comment=comment, decimal=decimal, encoding=encoding)


def _is_utf8(text: bytes) -> bool:
    try:
        codecs.getincrementaldecoder("utf-8")().decode(text)  # the piece may end within a letter
    except UnicodeDecodeError:
        return False
    return True


def _fields(lines: list[str], mark: str) -> int:
    """Number of cells of every line, if all have as many; a blank separates only where nothing else does."""
    counts = {len(line.split() if mark == " " else line.split(mark)) for line in lines}
    fewest = min(counts, default=0)
    return 0 if len(counts) > 1 or fewest == 1 else 2 * fewest - (mark == " ")


def _layout_entry(layout: CsvLayout) -> dict[str, Any]:
    plain, names = CsvLayout(), ("separator", "comment", "decimal", "encoding")
    changed = {name: getattr(layout, name) for name in names if getattr(layout, name) != getattr(plain, name)}
    if changed.get("separator") == " ":
        changed["separator"] = "space"
    return {"layout": changed} if changed else {}
