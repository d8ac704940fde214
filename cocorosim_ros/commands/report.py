"""`cocorosim report`: results of experiments as one page."""

from __future__ import annotations

from pathlib import Path

import click
from rich.console import Console

from cocorosim_ros.foundation.output_file import check_file, write_text


@click.command("report", short_help="results of experiments as one page")
@click.argument("results", nargs=-1, required=True, type=click.Path(path_type=Path))
@click.option("--out", type=click.Path(path_type=Path), help="the page [default: report.html in the first folder]")
@click.option("--table", "summary", type=click.Path(path_type=Path), help="CSV file of all medians and quartiles")
@click.option("--force", is_flag=True, help="replace files that are there")
def command(results: tuple[Path, ...], out: Path | None, summary: Path | None, force: bool) -> None:
    """Write one self-contained HTML page about RESULTS, folders that `cocorosim experiment` has made."""
    from cocorosim_ros.study.experiments.folder_layout import check_folder

    if out is None:  # the page lies with the results then, and would be said to lie in no folder
        check_folder(results[0])
    page = out or results[0] / "report.html"
    for path in (page, summary):
        check_file(path, force=force)
    for folder in results:
        check_folder(folder)
    from cocorosim_ros.study.results.report import render_report
    from cocorosim_ros.study.results.results import load_all

    experiments = load_all(results)
    write_text(page, render_report(experiments))
    Console().print(f"{page}: {page.stat().st_size / 1e6:.1f} MB, open it in a browser")
    if summary:
        from cocorosim_ros.study.results.summary_table import summary_csv

        write_text(summary, summary_csv(experiments))
        Console().print(f"{summary}: medians, quartiles and effects of every metric")
