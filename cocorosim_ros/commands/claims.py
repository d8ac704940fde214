"""`cocorosim claims`: the paper's claims beside what tables of results show."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click
from rich.console import Console
from rich.table import Table

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.foundation.output_file import check_file, write_text

if TYPE_CHECKING:
    from cocorosim_ros.study.claims.answers import Answer

_STYLES = {"reproduced": "green", "not reproduced": "red", "not decidable": "yellow", "no runs": "dim"}


@click.command("claims", short_help="the paper's claims against results")
@click.argument("results", nargs=-1, type=click.Path(path_type=Path))
@click.option("--run", "runs", metavar="FOLDER", type=click.Path(path_type=Path), help="run what is needed there first")
@click.option("--replicates", type=int, help="with --run: runs per group instead of the designs' own")
@click.option("--out", type=click.Path(path_type=Path), help="Markdown page to write")
@click.option("--force", is_flag=True, help="replace a page that is there")
@click.pass_context
def command(
    ctx: click.Context,
    /,
    results: tuple[Path, ...],
    runs: Path | None,
    replicates: int | None,
    out: Path | None,
    force: bool,
) -> None:
    """Hold the claims of the paper against RESULTS, folders of the designs `boids` and `turbulence`.

    With --run the designs are run, or gone on with, in FOLDER/boids and so on; the two designs of single choices too.
    """
    if bool(results) == (runs is not None):
        raise CocorosimError(
            "Give either RESULTS, folders of finished experiments, or --run and a folder to run them in."
        )
    check_file(out, force=force)
    from cocorosim_ros.study.experiments.folder_layout import check_folder

    for folder in results:
        check_folder(folder)
    from cocorosim_ros.study.claims.all_claims import STUDIES, all_answers
    from cocorosim_ros.study.claims.claims_page import by_claim, claims_page
    from cocorosim_ros.study.results.results import load_all

    if runs is not None:
        results = tuple(_run(ctx, name, runs / name, replicates) for name in STUDIES)
    experiments = {found.about["design"]: found for found in load_all(results)}
    if not experiments.keys() & set(STUDIES):
        raise CocorosimError(
            f"No claim is about the design '{next(iter(experiments))}'; give results of 'boids' or 'turbulence'."
        )
    answers = sorted(all_answers(experiments), key=by_claim)
    Console().print(_table(answers))
    if out is not None:
        write_text(out, claims_page(answers, experiments))
        Console().print(f"{out}: the same as a page")


def _run(ctx: click.Context, design: str, folder: Path, replicates: int | None) -> Path:
    """Run a design, or go on with it; its folder."""
    from cocorosim_ros.commands import experiment

    try:
        ctx.invoke(experiment.command, design=design, out=folder, replicates=replicates)
    except click.exceptions.Exit as ended:
        if ended.exit_code:
            raise
    return folder


def _table(answers: list[Answer]) -> Table:
    table = Table(title="claims of Read et al. 2013", title_justify="left")
    for heading in ("claim", "what", "paper", "numerics", "ours", "verdict"):
        table.add_column(heading)
    for answer in answers:
        verdict = f"[{_STYLES[answer.verdict]}]{answer.verdict}[/]"
        table.add_row(answer.claim, answer.subject, answer.paper, answer.numerics, answer.ours, verdict)
    return table
