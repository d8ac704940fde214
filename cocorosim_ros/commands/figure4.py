"""`cocorosim figure4`: the common reading of all open choices that gives back most of the paper's figure 4."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
from rich.console import Console
from rich.table import Table

from cocorosim_ros.commands.examples import with_examples
from cocorosim_ros.commands.json_output import console_beside, give_json, json_option
from cocorosim_ros.commands.terminal import say, show_table
from cocorosim_ros.foundation.output_file import check_file, write_text

if TYPE_CHECKING:
    from cocorosim_ros.study.experiments.factorial import Factorial
    from cocorosim_ros.study.figure4.published import PublishedFigure
    from cocorosim_ros.study.figure4.search import Done, Searched

FACTORIALS = ("figure4_boids", "figure4_turbulence")


@with_examples("cocorosim figure4 --run results/figure4 --factorial figure4_boids --out figure4.md")
@click.command("figure4", short_help="which reading gives back the paper's figure")
@click.option("--run", "folder", type=click.Path(path_type=Path), required=True, help="folder of the results")
@click.option(
    "--factorial",
    "factorials",
    multiple=True,
    default=FACTORIALS,
    show_default=True,
    help="a name in config/factorials, or a file (repeatable)",
)
@click.option("--workers", type=int, help="processes [default: one per processor]")
@click.option("--out", type=click.Path(path_type=Path), help="Markdown page to write")
@json_option
@click.option("--force", is_flag=True, help="replace the page that is there")
@click.pass_context
def command(ctx: click.Context, /, **options: Any) -> None:
    """Run a designed experiment over all that the paper leaves open, or go on with it, and show what it gives back.

    The stages of each factorial are run in FOLDER/NAME/STAGE: a screening of a fraction of all settings, rounds about
    the best of them, and many runs of the best.
    """
    from cocorosim_ros.commands.experiment import check_workers
    from cocorosim_ros.study.experiments.factorial import load_factorial
    from cocorosim_ros.study.figure4.page import figure_page
    from cocorosim_ros.study.figure4.published import published_figure
    from cocorosim_ros.study.figure4.search import Searched

    console = console_beside(options["json_file"], force=options["force"])
    check_file(options["out"], force=options["force"])
    check_workers(options["workers"])
    loaded = [load_factorial(name) for name in options["factorials"]]
    figures = [published_figure(factorial.figure) for factorial in loaded]
    found = []
    for factorial, figure in zip(loaded, figures, strict=True):
        found.append(Searched(factorial, figure, _search(ctx, factorial, figure, console)))
        show_table(console, _table(found[-1]))
    if options["out"] is not None:
        write_text(options["out"], figure_page(found))
        say(console, f"{options['out']}: all of it as a page")
    give_json(console, options["json_file"], {"factorials": [_tree(each) for each in found]})


def _search(ctx: click.Context, factorial: Factorial, figure: PublishedFigure, console: Console) -> tuple[Done, ...]:
    """All stages, run or gone on with."""
    from cocorosim_ros.commands.experiment import Kept, run_all
    from cocorosim_ros.study.figure4.search import done, next_stage
    from cocorosim_ros.study.results.results import load_results

    stages: list[Done] = []
    while (stage := next_stage(factorial, stages)) is not None:
        place = ctx.params["folder"] / factorial.name / stage.name
        status, _ = run_all(factorial.design(stage), Kept(place, ctx.params["workers"]), console)
        if status:
            ctx.exit(status)
        stages.append(done(factorial, figure, stage, load_results(place), stages))
    return tuple(stages)


def _table(searched: Searched) -> Table:
    """The best setting of each stage."""
    from cocorosim_ros.study.experiments.factorial import digits

    table = Table(title=f"{searched.factorial.name}: nearest to figure 4", title_justify="left")
    for heading in ("stage", "settings", "runs", "best setting", "mean distance", "boxes given back"):
        table.add_column(heading)
    for part in searched.stages:
        nearest = min(part.scores, key=lambda one: one.total)
        counts = str(len(part.scores)), str(part.stage.runs), digits(nearest.setting)
        table.add_row(
            part.stage.name, *counts, f"{nearest.total:.3f}", f"{nearest.given_back} of {searched.figure.boxes}"
        )
    return table


def _tree(searched: Searched) -> dict[str, object]:
    """Every setting of every stage, for programs."""
    from cocorosim_ros.study.experiments.factorial import digits

    shown = [each.name for each in searched.figure.shown]
    return {
        "factorial": searched.factorial.name,
        "factors": [factor.name for factor in searched.factorial.factors],
        "stages": [
            {
                "stage": part.stage.name,
                "runs": part.stage.runs,
                "settings": [
                    {
                        "setting": digits(one.setting),
                        "mean_distance": one.total,
                        "columns": dict(one.columns),
                        "responses": dict(zip(shown, one.responses, strict=True)),
                    }
                    for one in part.scores
                ],
            }
            for part in searched.stages
        ],
    }
