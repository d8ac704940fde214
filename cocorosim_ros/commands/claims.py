"""`cocorosim claims`: the paper's claims beside what tables of results show."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import click
from rich.console import Console
from rich.table import Table

from cocorosim_ros.commands.examples import with_examples
from cocorosim_ros.commands.json_output import console_beside, give_json, json_option
from cocorosim_ros.commands.terminal import say, show_table
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.foundation.output_file import check_file, write_text

if TYPE_CHECKING:
    from cocorosim_ros.study.claims.answers import Answer

_STYLES = {"reproduced": "green", "not reproduced": "red", "not decidable": "yellow", "no runs": "dim"}


@dataclass(frozen=True)
class _ClaimsChoices:
    """The options of one call."""

    results: tuple[Path, ...]
    runs: Path | None
    replicates: int | None
    out: Path | None
    json_file: Path | None
    force: bool

    def __post_init__(self) -> None:
        """Raise CocorosimError for options that contradict each other."""
        if bool(self.results) == (self.runs is not None):
            raise CocorosimError(
                "Give either RESULTS, folders of finished experiments, or --run and a folder to run them in."
            )


@with_examples(
    "cocorosim claims results/boids results/turbulence",
    "cocorosim claims --run results --replicates 50 --out claims.md",
)
@click.command("claims", short_help="the paper's claims against results")
@click.argument("results", nargs=-1, type=click.Path(path_type=Path))
@click.option("--run", "runs", metavar="FOLDER", type=click.Path(path_type=Path), help="run what is needed there first")
@click.option("--replicates", type=int, help="with --run: runs per group instead of the designs' own")
@click.option("--out", type=click.Path(path_type=Path), help="Markdown page to write")
@json_option
@click.option("--force", is_flag=True, help="replace files that are there")
@click.pass_context
def command(ctx: click.Context, /, **options: object) -> None:
    """Hold the claims of the paper against RESULTS, folders of the designs `boids` and `turbulence`.

    With --run the designs are run, or gone on with, in FOLDER/boids and so on; the two designs of single choices too.
    """
    choices = _ClaimsChoices(**options)  # type: ignore[arg-type]
    console = console_beside(choices.json_file, force=choices.force)
    check_file(choices.out, force=choices.force)
    results = choices.results
    from cocorosim_ros.study.experiments.folder_layout import check_folder

    for folder in results:
        check_folder(folder)
    from cocorosim_ros.study.claims.all_claims import STUDIES, all_answers
    from cocorosim_ros.study.claims.claims_page import by_claim, claims_page
    from cocorosim_ros.study.results.results import load_all

    if choices.runs is not None:
        results = tuple(_run(ctx, name, choices.runs / name, choices.replicates, told=console) for name in STUDIES)
    experiments = {found.about["design"]: found for found in load_all(results)}
    if not experiments.keys() & set(STUDIES):
        raise CocorosimError(
            f"No claim is about the design '{next(iter(experiments))}'; give results of 'boids' or 'turbulence'."
        )
    answers = sorted(all_answers(experiments), key=by_claim)
    show_table(console, _table(answers))
    if choices.out is not None:
        write_text(choices.out, claims_page(answers, experiments))
        say(console, f"{choices.out}: the same as a page")
    give_json(console, choices.json_file, {"answers": [asdict(answer) for answer in answers]})


def _run(ctx: click.Context, design: str, folder: Path, replicates: int | None, *, told: Console) -> Path:
    """Run a design, or go on with it; its folder."""
    from cocorosim_ros.commands.experiment import Kept, run_all
    from cocorosim_ros.study.experiments.design import load_design

    status, _ = run_all(load_design(design, replicates), Kept(folder), told)
    if status:
        ctx.exit(status)
    return folder


def _table(answers: list[Answer]) -> Table:
    table = Table(title="claims of Read et al. 2013", title_justify="left")
    for heading in ("claim", "what", "paper", "numerics", "ours", "verdict"):
        table.add_column(heading)
    for answer in answers:
        verdict = f"[{_STYLES[answer.verdict]}]{answer.verdict}[/]"
        table.add_row(answer.claim, answer.subject, answer.paper, answer.numerics, answer.ours, verdict)
    return table
