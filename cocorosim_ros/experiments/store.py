"""The folder of an experiment: finished chunks as parts, put together in one table when all are there.

    design.json        which design and which code the rows belong to
    parts/*.parquet    rows of finished chunks; each appears at once or not at all
    results.parquet    all rows, in the order of the design

A process that is killed at any moment loses the chunks that it had not finished, and nothing else.
"""

from __future__ import annotations

import json
import os
import shutil
from pathlib import Path

import pyarrow as pa
import pyarrow.compute as pc
import pyarrow.parquet as pq

from cocorosim_ros.errors import CocorosimError
from cocorosim_ros.experiments.design import Design
from cocorosim_ros.experiments.rows import SCHEMA, version

DESIGN, PARTS, RESULTS = "design.json", "parts", "results.parquet"
_NEW = ".new"


class Store:
    """Where the rows of one design are kept."""

    def __init__(self, folder: Path, design: Design, *, force: bool = False) -> None:
        """Raises CocorosimError if the folder holds something else, or rows of another design or of other code."""
        self._folder, self._design = folder, design
        self._parts = folder / PARTS
        try:
            self._open(force)
        except (FileExistsError, NotADirectoryError) as error:
            raise CocorosimError(f"{folder} is a file, or lies below one; give another folder with --out.") from error
        except OSError as error:
            raise CocorosimError(
                f"The folder {folder} cannot be written: {error.strerror}; give another one with --out."
            ) from error

    @property
    def results(self) -> Path:
        """The finished table."""
        return self._folder / RESULTS

    def done(self) -> set[tuple[str, str, int]]:
        """Numerics, group and replicate of every row that is there."""
        keys = ("numerics", "group", "replicate")
        table = self._everything(list(keys))
        return set(zip(*(table[key].to_pylist() for key in keys), strict=True))

    def add(self, rows: pa.Table) -> None:
        """Keep the rows of a finished chunk."""
        first = rows.slice(0, 1).to_pylist()[0]
        name = f"{first['numerics']}-{first['group']}-{first['replicate']:07d}-{rows.num_rows}.parquet"
        _write(rows, self._parts / name.replace("/", "_"))

    def complete(self) -> pa.Table:
        """The finished table in the order of the design; the parts are put together in one file."""
        table = self._everything(SCHEMA.names)
        cells = [(cell.numerics, cell.group) for cell in self._design.cells]
        keep = [
            (cells.index((numerics, group)), replicate, row)
            for row, (numerics, group, replicate) in enumerate(self._keys(table))
            if (numerics, group) in cells and replicate < self._design.replicates
        ]
        ordered = table.take(pa.array([row for *_, row in sorted(keep)], pa.int64()))
        if len(keep) == table.num_rows:
            _write(ordered, self.results)
            for part in self._part_files():
                part.unlink()
        return ordered

    def _keys(self, table: pa.Table) -> list[tuple[str, str, int]]:
        return list(zip(*(table[key].to_pylist() for key in ("numerics", "group", "replicate")), strict=True))

    def _everything(self, columns: list[str]) -> pa.Table:
        files = [path for path in (self.results, *self._part_files()) if path.is_file()]
        tables = [read_rows(path, columns) for path in files]
        table = pa.concat_tables(tables) if tables else SCHEMA.empty_table().select(columns)
        # Killed between writing the table and removing the parts, rows are there twice, and equal.
        seen: set[tuple[str, str, int]] = set()
        fresh = [not (key in seen or seen.add(key)) for key in self._keys(table)]  # type: ignore[func-returns-value]
        return table.filter(pa.array(fresh, pa.bool_()))

    def _part_files(self) -> list[Path]:
        return sorted(self._parts.glob("*.parquet"))

    def _open(self, force: bool) -> None:
        self._refuse_foreign()
        if force:
            self._empty()
        mine = {**self._design.summary(), "version": version()}
        note = self._folder / DESIGN
        if note.is_file():
            self._compare(json.loads(note.read_text("utf-8")), mine)
        self._parts.mkdir(parents=True, exist_ok=True)
        for unfinished in self._folder.rglob(f"*{_NEW}"):
            unfinished.unlink()
        _replace(note, (json.dumps(mine, indent=2) + "\n").encode())

    def _refuse_foreign(self) -> None:
        there = sorted(part.name for part in self._folder.iterdir()) if self._folder.is_dir() else []
        known = (DESIGN, PARTS, RESULTS)
        foreign = [name for name in there if name not in known and not name.endswith((_NEW, ".html"))]
        if foreign or (there and DESIGN not in there and not all(name.endswith(_NEW) for name in there)):
            raise CocorosimError(
                f"The folder {self._folder} holds '{(foreign or there)[0]}', which is no part of an experiment, so it "
                "is not touched; give another folder with --out."
            )

    def _empty(self) -> None:
        shutil.rmtree(self._parts, ignore_errors=True)
        for name in (RESULTS, DESIGN):
            (self._folder / name).unlink(missing_ok=True)

    def _compare(self, there: dict[str, str], mine: dict[str, str]) -> None:
        if there.get("digest") != mine["digest"]:
            raise CocorosimError(
                f"The folder {self._folder} holds results of another design, '{there.get('design')}' with digest "
                f"{there.get('digest')}, not of '{mine['design']}' with {mine['digest']}; give another folder "
                "with --out, or --force to start again."
            )
        if there.get("version") != mine["version"]:
            raise CocorosimError(
                f"The folder {self._folder} holds results of version {there.get('version')} of the program, this is "
                f"{mine['version']}; rows of both would not be comparable: give another folder with --out, or --force "
                "to start again."
            )


def read_rows(path: Path, columns: list[str] | None = None) -> pa.Table:
    """The rows of a table of results. Raises CocorosimError if the file is none."""
    try:
        return pq.read_table(path, columns=columns, partitioning=None)
    except FileNotFoundError as error:
        raise CocorosimError(f"{path} does not exist; give the folder or the table of an experiment.") from error
    except (pa.ArrowException, OSError) as error:
        reason = " ".join(str(error).split())
        raise CocorosimError(f"{path} is no readable table of results ({reason}); remove it or start again.") from error


def group_rows(table: pa.Table, numerics: str, group: str) -> pa.Table:
    """The rows of one cell."""
    return table.filter(pc.and_(pc.equal(table["numerics"], numerics), pc.equal(table["group"], group)))


def _write(table: pa.Table, path: Path) -> None:
    buffer = pa.BufferOutputStream()
    pq.write_table(table, buffer, compression="zstd")
    _replace(path, buffer.getvalue().to_pybytes())


def _replace(path: Path, content: bytes) -> None:
    """The file is there in full or as it was, even if the power fails."""
    new = path.with_name(path.name + _NEW)
    with open(new, "wb") as stream:
        stream.write(content)
        stream.flush()
        os.fsync(stream.fileno())
    os.replace(new, path)
