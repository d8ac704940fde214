"""The best common reading as parts of the page: which it is, which claims hold under it, what nothing gives back."""

from __future__ import annotations

from collections.abc import Sequence

from cocorosim_ros.study.claims.answers import MARKS
from cocorosim_ros.study.claims.claims import NOT_LARGE, shown
from cocorosim_ros.study.claims.markdown import markdown_table
from cocorosim_ros.study.experiments.factorial import Factorial, digits
from cocorosim_ros.study.figure4.claims_found import asked_of
from cocorosim_ros.study.figure4.published import Number, PublishedFigure
from cocorosim_ros.study.figure4.scores import Score
from cocorosim_ros.study.figure4.search import Done, best
from cocorosim_ros.study.metrics import METRICS


def best_part(factorial: Factorial, figure: PublishedFigure, stages: Sequence[Done]) -> list[str]:
    """The refined settings, and the best of them by many runs."""
    chosen, last = best(stages), stages[-1]
    confirmed, runs = last.scores[0], last.stage.runs
    return [
        "### The best common reading",
        _refined(factorial, figure, stages),
        f"The best is `{digits(chosen.setting)}`. Its choices: "
        + "; ".join(_in_words(name, told) for name, told in _choices(factorial, chosen)),
        "Its readings of the metrics: " + ", ".join(f"`{column}`" for column in chosen.columns.values()) + ".",
        f"With {runs} runs a group of other seeds its mean distance is {confirmed.total:.3f} ({chosen.total:.3f} by "
        f"the runs that chose it), and {confirmed.given_back} of {figure.boxes} boxes are on the figure's side.",
        _claims(figure, last, chosen),
        _medians(figure, last, confirmed),
    ]


def _refined(factorial: Factorial, figure: PublishedFigure, stages: Sequence[Done]) -> str:
    """The settings that were chosen among, and both ends of the screening beside them."""
    chosen_among = stages[-2]
    rows = [_row(figure, one, chosen_among) for one in sorted(chosen_among.scores, key=lambda one: one.total)]
    names = ", ".join(factor.name for factor in factorial.factors)
    told = (
        "The settings among which the best was chosen, and the two of the screening with every choice at its lower "
        f"and at its upper level. A digit stands for a choice, in this order: {names}."
    )
    ends = [one for one in stages[0].scores if len(set(one.setting)) == 1]
    rows += [_row(figure, one, stages[0]) for one in ends]
    return f"{told}\n\n" + markdown_table(("setting", "stage", "runs", "mean distance", "boxes given back"), rows)


def _row(figure: PublishedFigure, one: Score, part: Done) -> tuple[str, ...]:
    back = f"{one.given_back} of {figure.boxes}"
    return f"`{digits(one.setting)}`", part.stage.name, str(part.stage.runs), f"{one.total:.3f}", back


def _choices(factorial: Factorial, chosen: Score) -> list[tuple[str, str]]:
    levels = []
    for factor, upper in zip(factorial.factors, chosen.setting, strict=True):
        high, _, low = factor.description.partition(", else ")
        levels.append((factor.name, high if upper else low))
    return levels


def _in_words(name: str, told: str) -> str:
    return f"**{name}**: {told}"


def _claims(figure: PublishedFigure, last: Done, chosen: Score) -> str:
    asked = asked_of(last.results, figure.name, chosen.columns, figure.columns)
    counts = {mark: sum(MARKS[one.chosen.verdict] == mark for one in asked) for mark in MARKS.values()}
    told = ", ".join(f"{count} {mark.strip('*')}" for mark, count in counts.items() if count)
    rows = [
        (
            one.claim.name,
            f"{one.claim.group} against {one.claim.against}: {one.claim.metric.replace('_', ' ')}",
            one.claim.paper if one.claim.paper == NOT_LARGE else f"{one.claim.paper}, large",
            shown(one.chosen.effect),
            MARKS[one.chosen.verdict],
            f"{one.usual.effect.value:.3f} {MARKS[one.usual.verdict]}",
            f"{one.reproduced_in} of {one.columns}",
        )
        for one in asked
    ]
    heading = ("claim", "what", "the paper", "found", "reproduced", "this project's usual reading of the metric: A")
    return f"The paper's claims under it ({told}):\n\n" + markdown_table((*heading, "readings that reproduce it"), rows)


def _medians(figure: PublishedFigure, last: Done, confirmed: Score) -> str:
    """Medians and quartiles of every group in the chosen readings, with the figure's number where it is known."""
    known = {(each.group, each.metric): each.value for each in figure.shown if isinstance(each, Number)}
    rows = []
    for metric, column in confirmed.columns.items():
        unit = METRICS[metric].unit
        cells = []
        for group in last.results.groups:
            spread = last.results.spread(last.results.numerics[0], group, column)
            text = f"{spread.median:.4g} ({spread.lower:.4g} to {spread.upper:.4g})"
            number = known.get((group, metric))
            cells.append(text if number is None else f"{text}; figure {number:g}")
        rows.append((f"`{column}`" + ("" if unit == "1" else f" [{unit}]"), *cells))
    return "Medians and quartiles of its runs:\n\n" + markdown_table(("reading", *last.results.groups), rows)


def never_part(figure: PublishedFigure, stages: Sequence[Done]) -> list[str]:
    """In how many settings each box is on the figure's side, whatever else they give back."""
    tried = [one for part in stages[:-1] for one in part.scores]
    last = stages[-1].scores[0]
    rows = []
    for place, each in enumerate(figure.shown):
        back = sum(one.distances[place] == 0.0 for one in tried)
        near = min(one.distances[place] for one in tried)
        count = f"nearest {near:.2f}" if isinstance(each, Number) else f"{back} of {len(tried)}"
        rows.append(((isinstance(each, Number), back), (each.name, each.told, count, f"{last.distances[place]:.2f}")))
    ordered = [row for _, row in sorted(rows, key=lambda pair: pair[0])]
    return [
        "### Seldom or never given back",
        "In how many settings of all stages before the last each box is on the figure's side, by so few runs that some "
        "are so by chance, each setting in its nearest readings of the metrics; and how far it is under the best one.",
        markdown_table(
            ("box or number", "the figure", "settings that give it back", "distance under the best"), ordered
        ),
    ]
