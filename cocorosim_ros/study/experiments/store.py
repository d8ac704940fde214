"""The folder of an experiment: finished chunks as parts, put together in one table when all are there.

`results_folder` says what lies there. A process that is killed at any moment loses the chunks that it had not
finished, and nothing else.
"""

from __future__ import annotations

import json
import shutil
from pathlib import Path
from typing import Any

import pyarrow as pa
import pyarrow.parquet as pq

from cocorosim_ros.foundation.errors import ArgumentError, CocorosimError
from cocorosim_ros.foundation.output_file import replace_file
from cocorosim_ros.foundation.resumed_folder import opening, refuse_foreign, remove_unfinished
from cocorosim_ros.study.experiments.code_version import version
from cocorosim_ros.study.experiments.design import CONTROLLER_FILES, Design
from cocorosim_ros.study.experiments.folder_layout import DESIGN, PARTS, RESULTS
from cocorosim_ros.study.experiments.results_folder import KEYS, part_files, read_folder, read_note, row_keys
from cocorosim_ros.study.experiments.rows import RowKey


class Store:
    """Where the rows of one design are kept."""

    def __init__(self, folder: Path, design: Design, *, force: bool = False) -> None:
        """Raises CocorosimError if the folder holds something else, or rows of another design or of other code."""
        self._folder, self._design = folder, design
        self._parts = folder / PARTS
        with opening(folder):
            self._open(force)

    @property
    def results(self) -> Path:
        """The finished table."""
        return self._folder / RESULTS

    def done(self) -> set[RowKey]:
        """Which rows are there."""
        return set(row_keys(read_folder(self._folder, KEYS)))

    def add(self, rows: pa.Table) -> None:
        """Keep the rows of a finished chunk. Raises CocorosimError if a worker with other code has made them."""
        others = set(rows["version"].to_pylist()) - {version()}
        if others:
            raise CocorosimError(
                f"A worker has version {others.pop()} of the program, this is {version()}; rows of both would not be "
                "comparable, so its rows are not kept: give all workers this version and the same command again."
            )
        first = rows.slice(0, 1).to_pylist()[0]
        name = f"{first['numerics']}-{first['group']}-{first['replicate']:07d}-{rows.num_rows}.parquet"
        _write(rows, self._parts / name.replace("/", "_"))

    def complete(self) -> pa.Table:
        """The finished table in the order of the design; the parts are put together in one file."""
        table = read_folder(self._folder)
        cells = [(cell.numerics, cell.group) for cell in self._design.cells]
        keep = [
            (cells.index((numerics, group)), replicate, row)
            for row, (numerics, group, replicate) in enumerate(row_keys(table))
            if (numerics, group) in cells and replicate < self._design.replicates
        ]
        ordered = table.take(pa.array([row for *_, row in sorted(keep)], pa.int64()))
        if len(keep) == table.num_rows:
            _write(ordered, self.results)
            for part in part_files(self._folder):
                part.unlink()
        return ordered

    def _open(self, force: bool) -> None:
        ours = (DESIGN, PARTS, RESULTS)
        refuse_foreign(self._folder, DESIGN, lambda name: name in ours or name.endswith(".html"), "an experiment")
        if force:
            self._empty()
        mine = {**self._design.summary(), "version": version()}
        note = self._folder / DESIGN
        if note.is_file():
            self._compare(read_note(self._folder), mine)
        self._parts.mkdir(parents=True, exist_ok=True)
        remove_unfinished(self._folder)
        replace_file(note, (json.dumps(mine, indent=2) + "\n").encode())

    def _empty(self) -> None:
        shutil.rmtree(self._parts, ignore_errors=True)
        for name in (RESULTS, DESIGN):
            (self._folder / name).unlink(missing_ok=True)

    def _compare(self, there: dict[str, Any], mine: dict[str, Any]) -> None:
        before = there.get(CONTROLLER_FILES, {})
        for file, sha256 in mine.get(CONTROLLER_FILES, {}).items():
            if before.get(file, sha256) != sha256:
                words = f"{before[file][:12]}..., now {sha256[:12]}..."
                raise ArgumentError(
                    f"The folder {self._folder} holds results of another version of {file} (SHA-256 {words}); rows of "
                    "both would not be comparable: put the file back as it was, give another folder with 'out', or "
                    "'force' to start again.",
                    "out",
                    "force",
                )
        if there.get("digest") != mine["digest"]:
            raise ArgumentError(
                f"The folder {self._folder} holds results of another design, '{there.get('design')}' with digest "
                f"{there.get('digest')}, not of '{mine['design']}' with {mine['digest']}; give another folder "
                "with 'out', or 'force' to start again.",
                "out",
                "force",
            )
        if there.get("version") != mine["version"]:
            raise ArgumentError(
                f"The folder {self._folder} holds results of version {there.get('version')} of the program, this is "
                f"{mine['version']}; rows of both would not be comparable: give another folder with 'out', or 'force' "
                "to start again.",
                "out",
                "force",
            )


def _write(table: pa.Table, path: Path) -> None:
    buffer = pa.BufferOutputStream()
    pq.write_table(table, buffer, compression="zstd")
    replace_file(path, buffer.getvalue().to_pybytes())
