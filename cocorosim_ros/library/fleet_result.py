"""What a fleet's recordings show, as a record: table, drifts, groups, what is common, problems."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

from cocorosim_ros.diagnosis.fleet.store import PAGE, TABLE, write_whole
from cocorosim_ros.foundation.card import Card, Shown, card_markdown
from cocorosim_ros.foundation.data_frame import loaded_pandas
from cocorosim_ros.scenario.parts.platform import Platform

if TYPE_CHECKING:
    import pandas as pd

    from cocorosim_ros.diagnosis.fleet.findings import FleetFindings


@dataclass(frozen=True, eq=False, repr=False)
class FleetResult(Shown):
    """What the recordings of a fleet show, each by itself and together."""

    platform: Platform
    fleet: Path
    """Where the recordings lie."""
    folder: Path
    """Where the outcomes are kept; `diagnose_fleet` with the same folder goes on."""
    found: FleetFindings
    """Rows, drifts, groups and what is common, typed."""
    remarks: tuple[str, ...]
    """What happened on the way, in sentences: processes that died, recordings that have changed since."""

    @property
    def sentence(self) -> str:
        """The finding as an engineer would say it."""
        from cocorosim_ros.diagnosis.fleet.sentence import fleet_sentence

        return fleet_sentence(self.found)

    @property
    def missing(self) -> int:
        """How many recordings are not diagnosed yet, after an interruption."""
        return self.found.missing

    @property
    def problems(self) -> Mapping[str, str]:
        """Why recordings could not be diagnosed, a sentence each, by their names."""
        return {row.recording: row.problem for row in self.found.problems}

    @property
    def files(self) -> tuple[Path, Path]:
        """The table and the page."""
        return self.folder / TABLE, self.folder / PAGE

    def save(self) -> None:
        """Write the table and the page into the folder. Raises CocorosimError if they cannot be written."""
        from cocorosim_ros.diagnosis.fleet.page import FleetOrigin, render_fleet
        from cocorosim_ros.diagnosis.fleet.table import parquet_bytes

        write_whole(self.folder / TABLE, parquet_bytes(self.table))
        write_whole(
            self.folder / PAGE,
            render_fleet(self.found, FleetOrigin(str(self.fleet), self.platform.name, self.remarks)).encode(),
        )

    @cached_property
    def table(self) -> Any:
        """pyarrow.Table, one row a robot and recording; meaning and unit of each column are in its field's metadata."""
        from cocorosim_ros.diagnosis.fleet.table import table_of

        return table_of(self.found.rows)

    def to_frame(self) -> pd.DataFrame:
        """The table as a DataFrame. Raises CocorosimError if pandas is not installed."""
        loaded_pandas()
        return self.table.to_pandas()

    def tree(self) -> dict[str, Any]:
        """What `cocorosim diagnose --fleet --json` writes: the sentence, drifts, groups, what is common, problems."""
        from cocorosim_ros.diagnosis.fleet.fleet_tree import fleet_tree

        return {"sentence": self.sentence, **fleet_tree(self.found), "remarks": list(self.remarks)}

    def markdown(self) -> str:
        """The finding as Markdown, for the page of a run or a comment."""
        return card_markdown(self.card())

    def card(self) -> Card:
        """The sentence, and the numbers that drift."""
        from cocorosim_ros.diagnosis.fleet.page import drift_cells

        facts = {
            "recordings": str(self.found.recordings),
            "robots": str(len(self.found.robots)),
            "finding": self.sentence,
            "folder": str(self.folder),
        }
        rows = [drift_cells(each) for each in self.found.drifting]
        headings = ("robot", "number", "a week", "95 % interval", "recordings", "weeks")
        told = (*self.remarks, *self.problems.values())
        return Card(f"fleet of {self.platform.name}", facts, headings, rows, told)
