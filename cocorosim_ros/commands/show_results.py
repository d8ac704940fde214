"""The end of a run: statistics as a table on the terminal and as JSON, the picture, what to do next."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from rich.console import Console
from rich.markup import escape
from rich.table import Table

from cocorosim_ros.commands.run_modes import Outcome
from cocorosim_ros.commands.terminal import say, show_table
from cocorosim_ros.graph.runs.results import draw_picture, measure_recording, summary_of, write_json
from cocorosim_ros.scenario.scenario import Scenario
from cocorosim_ros.wire.bags.bag_reader import read_bag


def show_results(console: Console, scenario: Scenario, folder: Path, outcome: Outcome) -> None:
    """Write metrics.json and shoal.png into the run's folder and show the table."""
    if outcome.ticks == 0:
        say(console, f"Not a single tick was run; {folder} holds what there is.")
        return
    bag = read_bag(folder / "bag")
    tracks, samples, monitor = measure_recording(bag)
    summary = summary_of(bag, samples, monitor)
    write_json(folder / "metrics.json", summary)
    draw_picture(folder / "shoal.png", bag, tracks, monitor)
    show_table(console, metrics_table(summary, paper_only=True))
    for sentence in summary["findings"]:
        say(console, sentence, "yellow")
    say(console, _pace(scenario, outcome))
    say(console, f"digest {bag_digest(summary)}")
    say(console, f"{folder}: bag, metrics.json, shoal.png")


def _pace(scenario: Scenario, outcome: Outcome) -> str:
    words = f"{outcome.ticks} ticks, {outcome.ticks * scenario.tick:g} s simulated"
    if outcome.seconds > 0:
        factor = (outcome.ticks - 1) * scenario.tick / outcome.seconds
        words += f" in {outcome.seconds:.2f} s, {factor:.1f} x real time, after {outcome.starting:.2f} s of starting"
    return words + (" (interrupted)" if outcome.interrupted else "")


def bag_digest(summary: dict[str, Any]) -> str:
    """The recording's digest."""
    return str(summary["digest"] or "unknown")


def metrics_table(summary: dict[str, Any], *, paper_only: bool) -> Table:
    """The statistics of a recording as a table; numbers have four significant digits."""
    table = Table(title=f"shoaling statistics of {escape(summary['recording'])}", title_justify="left")
    for heading in ("metric", "value", "unit", "mean", "median", "value is the"):
        table.add_column(heading, justify="right" if heading in ("value", "mean", "median") else "left")
    for name, entry in summary["metrics"].items():
        if entry["paper"] or not paper_only:
            numbers = [_digits(entry[key]) for key in ("value", "mean", "median")]
            table.add_row(name, numbers[0], entry["unit"], *numbers[1:], entry["summarised_by"])
    return table


def _digits(value: float | None) -> str:
    return "-" if value is None else f"{value:.4g}"
