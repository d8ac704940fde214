"""`cocorosim report`: results of experiments as one page."""

from __future__ import annotations

from pathlib import Path

import click

from cocorosim_ros.commands.examples import with_examples
from cocorosim_ros.commands.json_output import console_beside, give_json, json_option
from cocorosim_ros.commands.terminal import say
from cocorosim_ros.foundation.output_file import check_file, write_text


@with_examples("cocorosim report results/smoke --table medians.csv")
@click.command("report", short_help="results of experiments as one page")
@click.argument("results", nargs=-1, required=True, type=click.Path(path_type=Path))
@click.option("--out", type=click.Path(path_type=Path), help="the page [default: report.html in the first folder]")
@click.option("--table", "summary", type=click.Path(path_type=Path), help="CSV file of all medians and quartiles")
@json_option
@click.option("--force", is_flag=True, help="replace files that are there")
def command(
    results: tuple[Path, ...], out: Path | None, summary: Path | None, json_file: Path | None, force: bool
) -> None:
    """Write one self-contained HTML page about RESULTS, folders that `cocorosim experiment` has made."""
    from cocorosim_ros.study.experiments.folder_layout import check_folder

    if out is None:  # the page lies with the results then, and would be said to lie in no folder
        check_folder(results[0])
    console = console_beside(json_file, force=force)
    page = out or results[0] / "report.html"
    for path in (page, summary):
        check_file(path, force=force)
    for folder in results:
        check_folder(folder)
    from cocorosim_ros.study.results.report import render_report
    from cocorosim_ros.study.results.results import load_all
    from cocorosim_ros.study.results.summary_table import summary_csv, summary_rows

    experiments = load_all(results)
    write_text(page, render_report(experiments))
    say(console, f"{page}: {page.stat().st_size / 1e6:.1f} MB, open it in a browser")
    if summary:
        write_text(summary, summary_csv(experiments))
        say(console, f"{summary}: medians, quartiles and effects of every metric")
    if json_file is not None:  # as large as the whole table
        give_json(console, json_file, {"page": str(page), "rows": summary_rows(experiments)})
