"""Many runs of a design, resumable, as one table."""

from __future__ import annotations

from collections.abc import Callable, Generator, Iterator
from contextlib import closing, contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from cocorosim_ros.foundation.card import Card, Shown, digits
from cocorosim_ros.foundation.data_frame import loaded_pandas
from cocorosim_ros.foundation.processors import processors
from cocorosim_ros.scenario.reading.arguments import Place, function, one_of, place_text, whole_number
from cocorosim_ros.study.experiments import execution
from cocorosim_ros.study.experiments.design import Cell, Design, load_design
from cocorosim_ros.study.experiments.execution import Going
from cocorosim_ros.study.experiments.results_folder import group_rows, read_folder
from cocorosim_ros.study.experiments.rows import Chunk, chunks
from cocorosim_ros.study.experiments.store import Store
from cocorosim_ros.world.controllers.plain.plain_controller import rehearse_plain

if TYPE_CHECKING:
    import pandas as pd

Calculate = Callable[[list[Chunk], Going], Generator[Any, None, None]]


@dataclass(frozen=True)
class Watch:
    """How to follow, and end, what takes long."""

    progress: Callable[[int, int], None] = lambda done, runs: None
    """Told at the start and after each part how many runs are done, and of how many."""
    going: Going = lambda: True
    """Asked now and then whether to go on."""

    def __post_init__(self) -> None:
        """Raise CocorosimError for what cannot be called."""
        function(self.progress, "progress")
        function(self.going, "going")


@dataclass(frozen=True, eq=False, repr=False)
class DesignResults(Shown):
    """The rows of a design: one a run."""

    design: Design
    folder: Path
    """Where the rows are kept; `run_design` with the same folder goes on."""
    table: Any
    """pyarrow.Table in the order of the design: numerics, group, replicate, seed, ticks, then of each metric its number
    for the run, its mean and its median over time, in SI units; NaN for a run that ran away."""
    missing: int
    """How many runs are not there yet, after an interruption; then the table has the others, in no order."""

    @property
    def file(self) -> Path:
        """The Parquet file of the finished table."""
        return self.folder / "results.parquet"

    @property
    def findings(self) -> tuple[str, ...]:
        """One sentence for each group of which runs ran away."""
        return tuple(sentence for cell in self.design.cells if (sentence := self._ran_away(cell)))

    def to_frame(self) -> pd.DataFrame:
        """The table as a DataFrame. Raises CocorosimError if pandas is not installed."""
        loaded_pandas()
        return self.table.to_pandas()

    def tree(self) -> dict[str, Any]:
        """What `cocorosim experiment --json` writes: the medians of the design's metrics in each group."""
        groups = []
        for cell in self.design.cells:
            rows, medians = self._medians(cell)
            groups.append({"numerics": cell.numerics, "group": cell.group, "runs": rows, "medians": medians})
        facts = {"design": self.design.name, "folder": str(self.folder), "runs": self.design.runs}
        return {**facts, "missing": self.missing, "groups": groups, "findings": list(self.findings)}

    def card(self) -> Card:
        """The median of the design's metrics over the runs of each group."""
        facts = {
            "runs": f"{self.table.num_rows} of {self.design.runs}",
            "baseline": self.design.baseline,
            "folder": str(self.folder),
        }
        headings = ("numerics", "group", "runs", *(f"median {name}" for name in self.design.metrics))
        rows = [self._row(cell) for cell in self.design.cells]
        return Card(f"results of the design {self.design.name}", facts, headings, rows, self.findings)

    def _row(self, cell: Cell) -> tuple[str, ...]:
        runs, medians = self._medians(cell)
        return cell.numerics, cell.group, str(runs), *map(digits, medians.values())

    def _medians(self, cell: Cell) -> tuple[int, dict[str, float | None]]:
        """How many runs of a group are there, and the median of each metric over those that have it."""
        rows = group_rows(self.table, cell.numerics, cell.group)
        values = {name: np.asarray(rows[name].to_numpy()) for name in self.design.metrics}
        known = {name: column[~np.isnan(column)] for name, column in values.items()}
        return rows.num_rows, {name: float(np.median(each)) if each.size else None for name, each in known.items()}

    def _ran_away(self, cell: Cell) -> str:
        ticks = group_rows(self.table, cell.numerics, cell.group)["ticks"].to_pylist()
        away = sum(count < cell.scenario.ticks for count in ticks)
        if not away:
            return ""
        told = f"{away} of {len(ticks)} runs of the group '{cell.group}', {cell.numerics} numerics, ran away"
        why = "forces or currents are too strong for the integrator's step. Their rows have no values"
        return f"{told}: {why}; a shorter step in that group's change would keep them."


def run_design(
    design: Place | Design,
    out: Place,
    *,
    replicates: int | None = None,
    workers: int | str | None = None,
    force: bool = False,
    watch: Watch = Watch(),
) -> DesignResults:
    """Run all runs of a design that are not in the folder `out` yet, and give the whole table.

    design: a name in config/designs, a file, or a record of `load_design`, which also chooses groups. replicates: runs
    in each group instead of the design's own. workers: how many processes of this machine, one per processor if left
    out (with more than one a script has to call this below `if __name__ == "__main__":`), or the address of a Dask
    scheduler whose workers do it. force: start again instead of going on. watch: told how far it is, asked whether to
    go on; what is finished by then is kept.

    Returns the table, one row a run. Raises CocorosimError for whatever is wrong with the design, if the folder holds
    something else or rows of another design or version (without `force`), if a plain Python controller cannot be made,
    and if workers keep dying.

    Example: `run_design("smoke", "results", workers=1).to_frame().groupby("group")["polarisation"].median()`.
    """
    one_of(watch, "watch", Watch)
    chosen, folder = _design(design, replicates), Path(place_text(out, "out"))
    if workers is not None and not isinstance(workers, str):
        workers = whole_number(workers, "workers")
    for cell in chosen.cells:
        rehearse_plain(cell.scenario.robots, cell.scenario.seed)
    with _calculator(workers) as calculate:  # before the folder is made: a scheduler may not answer
        store = Store(folder, chosen, force=force)
        missing = _add_missing(store, chosen, calculate, watch)
    return DesignResults(chosen, folder, read_folder(folder) if missing else store.complete(), missing)


def _design(design: Place | Design, replicates: int | None) -> Design:
    if not isinstance(design, Design):
        return load_design(place_text(design, "design"), replicates)
    return design if replicates is None else replace(design, replicates=whole_number(replicates, "replicates"))


def _add_missing(store: Store, design: Design, calculate: Calculate, watch: Watch) -> int:
    """Calculate what is not there yet; how many runs are missing in the end, more than none after an interruption."""
    left = list(chunks(design, store.done()))
    missing = sum(chunk.count for chunk in left)
    watch.progress(design.runs - missing, design.runs)
    with closing(calculate(left, watch.going)) as tables:
        for rows in tables:
            store.add(rows)
            missing -= rows.num_rows
            watch.progress(design.runs - missing, design.runs)
    return missing


@contextmanager
def _calculator(workers: int | str | None) -> Iterator[Calculate]:
    """What calculates chunks, in this process, in several or on a cluster."""
    if isinstance(workers, str):
        from cocorosim_ros.study.experiments.on_dask import connected, run_on_dask

        with connected(workers) as client:
            yield lambda left, going: run_on_dask(left, client, going)
    else:
        yield lambda left, going: _calculated_here(left, workers, going)


def _calculated_here(left: list[Chunk], asked: int | None, going: Going) -> Generator[Any, None, None]:
    workers = min(asked or processors(), len(left))
    if workers <= 1:
        return execution.run_here(left, going)
    return execution.run_in_processes(left, workers, going)
