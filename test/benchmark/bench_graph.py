"""How fast the node graph is, and what bounds it: `make bench-graph`, or with --repeat and --share of the full length.

Every run starts in a fresh process. Figures are those of the run between its first tick and its last, everything
recorded; starting (about two seconds) and the statistics at the end are not in them. "others": cores that everybody
else on the machine used meanwhile; where that is not near zero the figures are too low.
"""

from __future__ import annotations

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # as `cocorosim run` does

import argparse
import statistics
import sys
import tempfile
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from multiprocessing import get_context
from pathlib import Path

from conditions import conditions, cores
from graph_runs import LABELS, Case, NotCleanError, Result, composed, graph, graph_in_parts, without_ros
from rich.console import Console
from rich.table import Table

from cocorosim_ros.scenario.reading.config_files import shipped_file

MUST, GOAL = 40.0, 100.0  # x real time, for eleven Lilys at 0.5 s
ATTEMPTS = 3  # at a run in which nobody is late


@dataclass(frozen=True)
class Row:
    """One row of the table: a case, how it is run, how often."""

    title: str
    mode: Callable[[Case], Result]
    scenario: str
    seconds: float
    repeat: int


def rows(fine: str, crowd: str) -> list[Row]:
    """The table; `fine` is the scenario with ticks of 0.1 s, `crowd` that of 200 robots."""
    return [
        Row("11 Lilys, 0.5 s ticks", graph, "eleven_lilys", 600.0, 5),
        Row("11 Lilys, 0.1 s ticks", graph, fine, 60.0, 3),
        Row("30 Lilys, 0.5 s ticks", graph, "thirty_lilys", 300.0, 3),
        Row("50 Lilys, 0.5 s ticks", graph, "fifty_lilys", 300.0, 3),
        Row("200 Lilys, 0.5 s ticks", graph, crowd, 60.0, 1),
        Row("11 Lilys, --composed", composed, "eleven_lilys", 600.0, 2),
        Row("11 Lilys, --in-process", without_ros, "eleven_lilys", 600.0, 2),
    ]


def fine_scenario(folder: Path) -> str:
    """A file with eleven Lilys at ticks of 0.1 s."""
    changes = {"tick: 0.5 s": "tick: 0.1 s", "step: 0.25 s": "step: 0.1 s", "name: eleven_lilys": "name: fine_lilys"}
    return _changed_scenario("eleven_lilys", changes, folder / "fine_lilys.yaml")


def crowded_scenario(folder: Path) -> str:
    """A file with 200 Lilys, as close to each other as fifty are."""
    changes = {"count: 50": "count: 200", "[1.6 m, 1.6 m": "[3.2 m, 3.2 m", "name: fifty_lilys": "name: crowd"}
    return _changed_scenario("fifty_lilys", changes, folder / "crowd.yaml")


def _changed_scenario(name: str, changes: dict[str, str], file: Path) -> str:
    text = shipped_file(f"scenarios/{name}.yaml").read_text()
    for old, new in changes.items():
        if old not in text:
            raise RuntimeError(f"{name}.yaml no longer says '{old}'")
        text = text.replace(old, new, 1)
    file.write_text(text)
    return str(file)


def in_fresh_process(mode: Callable[[Case], Result], case: Case) -> Result:
    """The result of one run in a process of its own.

    A run in which answers were missing, because something else kept the machine busy, has no speed: it is done again.
    """
    for left in reversed(range(ATTEMPTS)):
        with ProcessPoolExecutor(1, mp_context=get_context("spawn")) as executor:
            try:
                return executor.submit(mode, case).result()
            except NotCleanError as error:
                if not left:
                    raise
                print(f"{case.source}: {error}; once more", file=sys.stderr, flush=True)
    raise AssertionError("at least one attempt is made")


def speed_table(results: list[tuple[Row, list[Result]]]) -> Table:
    """One line per row: speeds, and the CPU time per tick of each kind of process."""
    table = Table(
        title="speed (median and best of the runs; CPU: ms per tick, of the median run)", title_justify="left"
    )
    for heading in ("case", "processes", "runs", "x real time", "best", "ms/tick", "messages/tick"):
        table.add_column(heading, justify="left" if heading == "case" else "right")
    for heading in ("physics", "controllers", "recorder", "cores busy", "others"):
        table.add_column(heading, justify="right")
    for row, runs in results:
        middle = sorted(runs, key=lambda run: run.factor)[len(runs) // 2]
        cells = [row.title, str(middle.processes), str(len(runs)), f"{median(runs):.1f}"]
        cells += [f"{max(run.factor for run in runs):.1f}", f"{1e3 * middle.per_tick:.2f}"]
        cells.append(f"{middle.messages / middle.ticks:.0f}")
        used = [1e3 * seconds for seconds in middle.cpu.values()]
        busy = [f"{cores:.2f}" for cores in middle.cores_busy] if used else []
        table.add_row(*cells, *(f"{value:.2f}" for value in used), *busy)
    return table


def parts_table(result: Result) -> Table:
    """Where the CPU time of a tick goes, in a run whose functions are timed."""
    title = f"CPU time of one tick, ms, 11 Lilys (all controllers together; timed run: {result.factor:.0f} x real time)"
    table = Table(title=title, title_justify="left")
    table.add_column("part")
    for heading in result.parts:
        table.add_column(heading, justify="right")
    rest = dict(result.cpu)
    for label in LABELS:
        values = [1e3 * result.parts[role][label] for role in result.parts]
        table.add_row(label, *(f"{value:.2f}" if value > 0.0 else "" for value in values))
        for role in result.parts:
            rest[role] = rest.get(role, 0.0) - result.parts[role][label]
    table.add_row("Fast DDS threads", *(f"{1e3 * max(0.0, rest[role]):.2f}" for role in result.parts))
    table.add_section()
    table.add_row("whole process", *(f"{1e3 * result.cpu.get(role, 0.0):.2f}" for role in result.parts))
    return table


def median(runs: list[Result]) -> float:
    """The median speed [x real time]."""
    return statistics.median(run.factor for run in runs)


def bound(runs: list[Result]) -> str:
    """What bounds the main case, in words."""
    middle = sorted(runs, key=lambda run: run.factor)[len(runs) // 2]
    used = sum(middle.cpu.values())
    least = used / cores()
    return (
        f"What bounds it: a tick costs {1e3 * used:.2f} ms of CPU time in all processes together, so {cores()} cores "
        f"cannot do it in less than {1e3 * least:.2f} ms ({middle.tick / least:.0f} x real time); it took "
        f"{1e3 * middle.per_tick:.2f} ms."
    )


def main() -> None:
    """Run everything and print it."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--repeat", type=int, default=0, help="runs per case, instead of the table's own")
    parser.add_argument("--share", type=float, default=1.0, help="share of each case's length")
    options = parser.parse_args()
    console = Console(width=150)
    console.print("\n".join(conditions()), highlight=False)
    with tempfile.TemporaryDirectory() as folder:
        results = []
        for row in rows(fine_scenario(Path(folder)), crowded_scenario(Path(folder))):
            case = Case(row.scenario, f"{max(1.0, row.seconds * options.share):g} s")
            count = options.repeat or row.repeat
            results.append((row, [in_fresh_process(row.mode, case) for _ in range(count)]))
            console.print(f"{row.title}, {case.duration} of simulation: {median(results[-1][1]):.1f} x real time")
    console.print(speed_table(results))
    parts = in_fresh_process(graph_in_parts, Case("eleven_lilys", f"{max(1.0, 300.0 * options.share):g} s"))
    console.print(parts_table(parts))
    main_runs = results[0][1]
    console.print(bound(main_runs), highlight=False, soft_wrap=True)
    reached = median(main_runs)
    console.print(
        f"must {MUST:.0f} x real time: {'reached' if reached >= MUST else 'NOT reached'}; "
        f"goal {GOAL:.0f} x: {'reached' if reached >= GOAL else 'not reached'} (median {reached:.1f} x)",
        highlight=False,
    )


if __name__ == "__main__":
    main()
