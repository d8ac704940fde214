"""`cocorosim calibrate`: section 4 of the paper again, or a platform fitted to the bag of a calibration run."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
from rich.console import Console
from rich.table import Table

from cocorosim_ros.commands.completion import config_or_file
from cocorosim_ros.commands.examples import with_examples
from cocorosim_ros.commands.json_output import console_beside, give_json, json_option
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.foundation.output_file import check_file

if TYPE_CHECKING:
    from cocorosim_ros.study.calibration.fit import Fit
    from cocorosim_ros.study.calibration.section_four import Row


@with_examples("cocorosim calibrate", "cocorosim calibrate runs/calibration_run --platform lily --out my_lily.yaml")
@click.command("calibrate", short_help="calibrate a platform")
@click.argument("bag", required=False, type=click.Path(path_type=Path))
@click.option(
    "--platform",
    "platform_name",
    default="lily",
    show_default=True,
    shell_complete=config_or_file("platforms"),
    help="platform to begin with",
)
@click.option("--robot", help="whose run it is, if the recording has several")
@click.option("--out", type=click.Path(path_type=Path), help="platform file to write")
@json_option
@click.option("--force", is_flag=True, help="replace files that are there")
def command(
    bag: Path | None, platform_name: str, robot: str | None, out: Path | None, json_file: Path | None, force: bool
) -> None:
    """Without BAG: Lily from the published measurements, with what does not fit together.

    With the BAG of a calibration run (see the scenario calibration_run): fit the platform to it.
    """
    from cocorosim_ros.library.diagnose import inputs_of

    if bag is None and (out is not None or robot is not None):
        raise CocorosimError("--out and --robot belong to a recording; give the BAG of a calibration run too.")
    read = [] if bag is None else inputs_of([bag], platform_name, None)
    console = console_beside(json_file, force=force, inputs=read)
    if bag is None:
        tree = _show_section_four(console)
    else:
        tree = _fit(console, bag, platform_name, robot, _Target(out, force, read))
    give_json(console, json_file, tree)


@dataclass(frozen=True)
class _Target:
    """Where the fitted platform goes: None for nowhere; whether a file there is replaced; what is read."""

    out: Path | None
    force: bool
    inputs: Sequence[Path]


def _fit(console: Console, bag: Path, platform_name: str, robot: str | None, target: _Target) -> dict[str, Any]:
    from cocorosim_ros.scenario.parts.platform import load_platform
    from cocorosim_ros.wire.bags.bag_reader import check_there

    check_file(target.out, force=target.force, inputs=target.inputs)
    platform = load_platform(platform_name)
    check_there(bag)
    # Loaded here: a path that is wrong is said before the weight comes.
    from cocorosim_ros.study.calibration.calibration_run import read_calibration_run
    from cocorosim_ros.study.calibration.fit import fit_platform
    from cocorosim_ros.study.calibration.platform_file import write_platform

    fit = fit_platform(platform, read_calibration_run(bag, platform, robot))
    console.print(fit_table(fit, platform_name))
    for name in fit.not_shown:
        console.print(f"[yellow]The recording does not show {name}; it stays as it was.[/yellow]")
    x, y, z, yaw = fit.scatter
    console.print(f"left over (rms): {x:.2g} m, {y:.2g} m, depth {z:.2g} m, heading {yaw:.2g} rad")
    if target.out is not None:
        write_platform(target.out, platform, fit, str(bag), force=target.force)
        console.print(f"{target.out}: the fitted platform")
    left_over = {"x_m": x, "y_m": y, "depth_m": z, "heading_rad": yaw}
    numbers = [asdict(number) for number in fit.numbers]
    return {"platform": platform_name, "numbers": numbers, "not_shown": list(fit.not_shown), "left_over": left_over}


def _show_section_four(console: Console) -> dict[str, Any]:
    from cocorosim_ros.study.calibration.section_four import calibration_rows, findings

    rows, sentences = calibration_rows(), findings()
    console.print(section_table(rows))
    for number, sentence in enumerate(sentences, 1):
        console.print(f"{number}. {sentence}", highlight=False)
    return {"rows": [asdict(row) for row in rows], "findings": sentences}


def section_table(rows: list[Row]) -> Table:
    """Paper, measured and ours, side by side."""
    table = Table(title="Lily from the measurements of Read et al. 2013, section 4", title_justify="left")
    table.add_column("quantity")
    for heading in ("paper", "measured", "ours, paper's integrator", "ours, accurate"):
        table.add_column(heading, justify="right")
    table.add_column("unit")
    for row in rows:
        numbers = [_digits(value) for value in (row.paper, row.measured, row.paper_integrator, row.accurate)]
        table.add_row(row.quantity, *numbers, row.unit)
    return table


def fit_table(fit: Fit, platform: str) -> Table:
    """Each number before and after, with its interval."""
    table = Table(title=f"{platform}, fitted to the recording", title_justify="left")
    table.add_column("parameter")
    for heading in ("before", "fitted", "95 % from", "to"):
        table.add_column(heading, justify="right")
    table.add_column("unit")
    for number in fit.numbers:
        values = (number.nominal, number.value, number.low, number.high)
        table.add_row(number.name, *(_digits(value) for value in values), number.unit)
    return table


def _digits(value: float | None) -> str:
    return "-" if value is None else f"{value:.4g}"
