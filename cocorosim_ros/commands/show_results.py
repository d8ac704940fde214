"""The end of a run: statistics as a table on the terminal and as JSON, the picture, what to do next."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from rich.console import Console
from rich.markup import escape
from rich.table import Table

from cocorosim_ros.commands.terminal import say, show_table
from cocorosim_ros.foundation.json_file import write_json
from cocorosim_ros.library.recording import read_recording
from cocorosim_ros.library.shoal_statistics import ShoalStatistics
from cocorosim_ros.scenario.scenario import Scenario

if TYPE_CHECKING:
    from cocorosim_ros.commands.run_modes import Outcome  # which loads all ways of running


def show_results(console: Console, scenario: Scenario, folder: Path, outcome: Outcome) -> dict[str, Any]:
    """Write metrics.json and shoal.png into the run's folder and show the table; the same for programs."""
    tree = _tree(scenario, folder, outcome)
    if outcome.ticks == 0:
        say(console, f"Not a single tick was run; {folder} holds what there is.")
        return tree
    recording = read_recording(folder / "bag")
    statistics = recording.measure()
    write_json(folder / "metrics.json", statistics.tree())
    recording.draw(folder / "shoal.png", statistics, force=True)
    show_table(console, metrics_table(statistics, paper_only=True))
    for sentence in statistics.findings:
        say(console, sentence, "yellow")
    say(console, _pace(scenario, outcome))
    say(console, f"digest {statistics.digest or 'unknown'}")
    say(console, f"{folder}: bag, metrics.json, shoal.png")
    return {**tree, "statistics": statistics.tree()}


def _tree(scenario: Scenario, folder: Path, outcome: Outcome) -> dict[str, Any]:
    return {
        "scenario": scenario.name,
        "folder": str(folder),
        "ticks": outcome.ticks,
        "simulated_s": outcome.ticks * scenario.tick,
        "seconds": outcome.seconds,
        "starting_s": outcome.starting,
        "interrupted": outcome.interrupted,
    }


def _pace(scenario: Scenario, outcome: Outcome) -> str:
    words = f"{outcome.ticks} ticks, {outcome.ticks * scenario.tick:g} s simulated"
    if outcome.seconds > 0:
        factor = (outcome.ticks - 1) * scenario.tick / outcome.seconds
        words += f" in {outcome.seconds:.2f} s, {factor:.1f} x real time, after {outcome.starting:.2f} s of starting"
    return words + (" (interrupted)" if outcome.interrupted else "")


def metrics_table(statistics: ShoalStatistics, *, paper_only: bool) -> Table:
    """The statistics of a recording as a table; numbers have four significant digits."""
    table = Table(title=f"shoaling statistics of {escape(statistics.name)}", title_justify="left")
    for heading in ("metric", "value", "unit", "mean", "median", "value is the"):
        table.add_column(heading, justify="right" if heading in ("value", "mean", "median") else "left")
    for name, entry in statistics.summary["metrics"].items():
        if entry["paper"] or not paper_only:
            numbers = [_digits(entry[key]) for key in ("value", "mean", "median")]
            table.add_row(name, numbers[0], entry["unit"], *numbers[1:], entry["summarised_by"])
    return table


def _digits(value: float | None) -> str:
    return "-" if value is None else f"{value:.4g}"
