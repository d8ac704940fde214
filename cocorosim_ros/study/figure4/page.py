"""The search as a Markdown page: how it was made, what each choice does, the best reading, and what none gives back."""

from __future__ import annotations

from collections.abc import Sequence

from cocorosim_ros.study.claims.markdown import markdown_table
from cocorosim_ros.study.figure4.best_reading import best_part, never_part
from cocorosim_ros.study.figure4.choices_page import choices_part
from cocorosim_ros.study.figure4.published import Number, PublishedFigure
from cocorosim_ros.study.figure4.search import Done, Searched


def figure_page(searches: Sequence[Searched]) -> str:
    """The whole page."""
    parts = [
        "# Figure 4 of the paper, by a designed experiment",
        "Which common reading of all that Read et al. 2013 leave open gives back most of their figure 4, what each "
        "choice does to it, and what no reading gives back, as `cocorosim figure4` finds it. "
        "[The studies of the paper](the_paper.md) says how the page was made and what follows from it.",
        "All choices are varied at once: a screening runs a fraction of all settings, a folded Hadamard matrix "
        "(resolution IV), so that no main effect is mixed with an interaction of two choices. The five best settings "
        "and the one that main effects alone choose are run again with other seeds, then the neighbours of the best; "
        "the nearest of these have more runs, by which the best is chosen, and that one is run often, with seeds that "
        "chose nothing. How metrics are taken costs no runs: each setting is judged by the readings of the metrics "
        "that bring it nearest to the figure, and the best one keeps those by which it was chosen.",
        "**Distance.** Of each box the figure tells whether it is a large effect against the baseline, and in which "
        "direction. Its distance is how far A is on the wrong side of 0.71 or 0.29, in units of 0.21: 0 where the "
        "claim holds, 1 where a large effect is claimed and none is there. A number of the figure is as far away as "
        "factors of two lie between, at most 3. Both units are chosen: how wide the figure's boxes are is not known "
        "here.",
        *(part for each in searches for part in _chapter(each)),
    ]
    return "\n\n".join(part for part in parts if part) + "\n"


def _chapter(searched: Searched) -> list[str]:
    factorial, figure, stages = searched.factorial, searched.figure, searched.stages
    return [
        f"## {factorial.name}: {factorial.description}",
        _numbers(figure),
        _made_from(stages),
        *choices_part(factorial, figure, stages[0]),
        *best_part(factorial, figure, stages),
        *never_part(figure, stages),
    ]


def _numbers(figure: PublishedFigure) -> str:
    numbers = [each for each in figure.shown if isinstance(each, Number)]
    told = "; ".join(f"{each.name} {each.value:g} (to {each.digit:g})" for each in numbers)
    words = f"{figure.boxes} boxes are known by side and size"
    return f"Of the figure, {words}, and as numbers: {told}." if numbers else f"Of the figure, {words}; no numbers."


def _made_from(stages: Sequence[Done]) -> str:
    rows = []
    for part in stages:
        seconds = sum(part.results.table["wall_seconds"].to_pylist())
        rows.append(
            (
                part.stage.name,
                str(len(part.stage.settings)),
                str(part.stage.runs),
                str(part.results.table.num_rows),
                f"{part.results.about['ticks']:,}",
                ", ".join(part.results.numerics),
                part.results.about["digest"],
                ", ".join(sorted(set(part.results.table["version"].to_pylist()))),
                f"{seconds / 60:.1f}",
            )
        )
    heading = ("stage", "settings", "runs a group", "all runs", "ticks", "numerics", "digest", "version of the code")
    return markdown_table((*heading, "minutes of one worker"), rows)
