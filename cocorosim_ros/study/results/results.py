"""The results of experiments as arrays, group by group.

A group "X, choice" is X under an open choice. It is compared with the baseline under the same choice where the design
has that, and with the baseline itself where the baseline does not know the choice.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow as pa

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.study.experiments.folder_layout import DESIGN, check_folder
from cocorosim_ros.study.experiments.results_folder import group_rows, read_folder, read_note
from cocorosim_ros.study.metrics import METRICS
from cocorosim_ros.study.results.effect_size import Effect, effect

SEPARATOR = ", "
"""Between a group's name and the choice that it is under."""


@dataclass(frozen=True)
class Spread:
    """Median and quartiles of one column of one group."""

    runs: int
    median: float
    lower: float
    upper: float


@dataclass(frozen=True)
class Results:
    """A table with the design that it belongs to."""

    about: dict[str, Any]
    """What design.json says."""
    table: pa.Table

    @property
    def groups(self) -> list[str]:
        """In the order of the design."""
        return list(dict.fromkeys(cell["group"] for cell in self.about["cells"]))

    @property
    def numerics(self) -> list[str]:
        """In the order of the design."""
        return list(dict.fromkeys(cell["numerics"] for cell in self.about["cells"]))

    @property
    def baseline(self) -> str:
        """The group that the others are compared with."""
        return str(self.about["baseline"])

    def baseline_of(self, group: str) -> str:
        """The group that this one is compared with: the baseline under the same choice, or the baseline."""
        own = f"{self.baseline}{SEPARATOR}{group.partition(SEPARATOR)[2]}"
        return own if own in self.groups and own != group else self.baseline

    @cached_property
    def _rows(self) -> dict[tuple[str, str], pa.Table]:
        """The rows of each cell by numerics and group."""
        cells = [(cell["numerics"], cell["group"]) for cell in self.about["cells"]]
        return {cell: group_rows(self.table, *cell) for cell in cells}

    def values(self, numerics: str, group: str, column: str) -> Floats:
        """One number per run, NaN where undefined; none of a group that the design does not have."""
        rows = self._rows.get((numerics, group), self.table.slice(0, 0))
        return np.asarray(rows[column].to_numpy(zero_copy_only=False), dtype=np.float64)

    def spread(self, numerics: str, group: str, column: str) -> Spread:
        """Median and quartiles over the runs at which the column is defined."""
        values = self.values(numerics, group, column)
        known = values[~np.isnan(values)]
        if known.size == 0:
            return Spread(0, np.nan, np.nan, np.nan)
        lower, median, upper = np.quantile(known, [0.25, 0.5, 0.75])
        return Spread(known.size, float(median), float(lower), float(upper))

    def effect(self, numerics: str, group: str, column: str) -> Effect:
        """A of a group against the one that it is compared with."""
        return effect(self.values(numerics, group, column), self.values(numerics, self.baseline_of(group), column))


def load_all(folders: Sequence[Path]) -> list[Results]:
    """The results in several folders. Raises CocorosimError if one holds none, or two are of the same design."""
    found = [load_results(folder) for folder in folders]
    seen: dict[str, Path] = {}
    for folder, results in zip(folders, found, strict=True):
        name = str(results.about["design"])
        if name in seen:
            raise CocorosimError(
                f"{seen[name]} and {folder} both hold results of a design '{name}', whose groups could not be told "
                "apart; give one of them."
            )
        seen[name] = folder
    return found


def load_results(folder: Path) -> Results:
    """The results of an experiment, finished or not. Raises CocorosimError if the folder holds none."""
    check_folder(folder)
    results = Results(read_note(folder), read_folder(folder))
    _check_metrics(results.about["metrics"], folder)
    if results.table.num_rows == 0:
        raise CocorosimError(f"{folder} holds no finished runs yet; let 'cocorosim experiment' go on.")
    if group_rows(results.table, results.numerics[0], results.baseline).num_rows == 0:
        raise CocorosimError(
            f"{folder} holds no runs of the baseline '{results.baseline}' yet; let it be calculated first."
        )
    return results


def _check_metrics(names: Sequence[str], folder: Path) -> None:
    """Raises CocorosimError if one of them is no metric here."""
    unknown = [name for name in names if name not in METRICS]
    if unknown:
        raise CocorosimError(
            f"{folder / DESIGN} asks for the metric '{unknown[0]}', which this version of the program does not have; "
            "use the version that made it, or run the design again in another folder."
        )
