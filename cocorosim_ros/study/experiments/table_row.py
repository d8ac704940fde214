"""Which run a row of a finished table is: the number of runs per group is the table's, not the design's."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.study.experiments.design import Cell, Design
from cocorosim_ros.study.experiments.folder_layout import RESULTS
from cocorosim_ros.study.experiments.results_folder import KEYS, read_note, read_rows


@dataclass(frozen=True)
class TableRow:
    """What a row says that it is."""

    cell: Cell
    replicate: int
    version: str
    """Of the code that made it."""


def row_of_table(design: Design, folder: Path, row: int) -> TableRow:
    """The run that is row `row`, counted from 0, of the finished table in this folder.

    Raises CocorosimError if there is no such table or row, or if the row belongs to another design.
    """
    path = folder / RESULTS
    if folder.is_dir() and not path.is_file():
        raise CocorosimError(
            f"{folder} holds no finished table yet, whose rows could be counted; let 'cocorosim experiment' make it."
        )
    table = read_rows(path, [*KEYS, "version"])
    if not 0 <= row < table.num_rows:
        raise CocorosimError(f"{path} has no row {row}; choose from 0 to {table.num_rows - 1}.")
    numerics, group, replicate, version = table.slice(row, 1).to_pylist()[0].values()
    texts = [cell["scenario"] for cell in _cells(folder, numerics, group)]
    for cell in design.cells:
        if (cell.numerics, cell.group) == (numerics, group) and cell.scenario.to_yaml() in texts:
            return TableRow(cell, replicate, version)
    raise CocorosimError(
        f"Row {row} of {path} is of group '{group}' in {numerics} numerics of another design than '{design.name}' is "
        "now; give the design that the table was made of, as it was."
    )


def _cells(folder: Path, numerics: str, group: str) -> list[dict[str, str]]:
    cells = read_note(folder)["cells"]
    return [cell for cell in cells if (cell["numerics"], cell["group"]) == (numerics, group)]
