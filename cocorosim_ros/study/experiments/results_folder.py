"""What the folder of an experiment holds, as it is read: the design that it belongs to and the rows that are there."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import pyarrow as pa
import pyarrow.compute as pc
import pyarrow.parquet as pq

from cocorosim_ros.foundation.errors import ArgumentError, CocorosimError
from cocorosim_ros.study.experiments.folder_layout import DESIGN, PARTS, RESULTS
from cocorosim_ros.study.experiments.rows import SCHEMA, RowKey

KEYS = ("numerics", "group", "replicate")
"""The columns that tell rows apart."""
_NOTED = set("design digest description baseline replicates metrics robots tank ticks tick cells version".split())
_NOTED_OF_CELLS = {"numerics", "group", "description", "scenario"}


def read_note(folder: Path) -> dict[str, Any]:
    """What design.json says. Raises CocorosimError if it is not what an experiment has written."""
    path = folder / DESIGN
    try:
        note = json.loads(path.read_text("utf-8"))
        reason = _what_lacks(note)
    except (OSError, ValueError) as error:
        reason = " ".join(str(error).split())
    if reason:
        raise ArgumentError(
            f"{path} does not say which design the rows beside it belong to ({reason}); put it back as it was, or run "
            "the design again, in another folder or with 'force'.",
            "force",
        )
    return dict(note)


def _what_lacks(note: Any) -> str:
    if not isinstance(note, dict):
        return "it is no mapping"
    lacking = sorted(_NOTED - note.keys())
    if lacking:
        return f"it lacks '{lacking[0]}'"
    cells = note["cells"]
    known = isinstance(cells, list) and all(isinstance(cell, dict) and cell.keys() >= _NOTED_OF_CELLS for cell in cells)
    return "" if cells and known else "its 'cells' are none"


def part_files(folder: Path) -> list[Path]:
    """The parts that are there, in the order of their names."""
    return sorted((folder / PARTS).glob("*.parquet"))


def read_folder(folder: Path, columns: Sequence[str] = tuple(SCHEMA.names)) -> pa.Table:
    """These columns of every row that is there, each row once. Raises CocorosimError if a file is none of results.

    Killed between writing the table and removing the parts, rows are there twice, and equal.
    """
    files = [path for path in (folder / RESULTS, *part_files(folder)) if path.is_file()]
    wanted = [*dict.fromkeys([*KEYS, *columns])]
    schema = pa.schema([SCHEMA.field(name) for name in wanted])
    table = pa.concat_tables([schema.empty_table(), *(read_rows(path, wanted) for path in files)])
    seen: set[RowKey] = set()
    fresh = [not (key in seen or seen.add(key)) for key in row_keys(table)]  # type: ignore[func-returns-value]
    return table.filter(pa.array(fresh, pa.bool_())).select(columns)


def row_keys(table: pa.Table) -> list[RowKey]:
    """Which run of which cell each row is of."""
    return [RowKey(*row) for row in zip(*(table[key].to_pylist() for key in KEYS), strict=True)]


def read_rows(path: Path, columns: Sequence[str]) -> pa.Table:
    """These columns of a table of results. Raises CocorosimError if the file is none, or lacks one of them."""
    try:
        lacking = [name for name in columns if name not in pq.read_schema(path).names]
        if lacking:
            raise CocorosimError(
                f"{path} lacks the column '{lacking[0]}', so another version of the program has made it; use that "
                "version, or run the design again in another folder."
            )
        table = pq.read_table(path, columns=list(columns), partitioning=None).select(list(columns))
        return table.cast(pa.schema([SCHEMA.field(name) for name in columns]))
    except FileNotFoundError as error:
        raise CocorosimError(f"{path} does not exist; give the folder of an experiment.") from error
    except (pa.ArrowException, OSError) as error:
        reason = " ".join(str(error).split())
        raise CocorosimError(f"{path} is no readable table of results ({reason}); remove it or start again.") from error


def group_rows(table: pa.Table, numerics: str, group: str) -> pa.Table:
    """The rows of one cell."""
    return table.filter(pc.and_(pc.equal(table["numerics"], numerics), pc.equal(table["group"], group)))
