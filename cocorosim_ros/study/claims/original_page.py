"""The released reading as a part of the page of the claims: beside the original's figures, and claim by claim."""

from __future__ import annotations

from cocorosim_ros.study.claims.answers import MARKS
from cocorosim_ros.study.claims.claims import claim_answers
from cocorosim_ros.study.claims.markdown import markdown_table
from cocorosim_ros.study.claims.original import DESIGN, RUNS_OF_ORIGINAL, Comparison, comparisons
from cocorosim_ros.study.results.results import Results


def released_part(results: Results) -> str:
    """Both tables; nothing for another design."""
    if results.about["design"] != DESIGN:
        return ""
    numerics = results.numerics[0]
    return "\n\n".join(
        (
            f"## The released reading: `{DESIGN}`",
            "The boids, Lily and numerics of the authors' released model, beside figures that this model itself gave "
            f"when it was run, medians of {RUNS_OF_ORIGINAL} runs a group. A figure agrees when it lies, "
            f"as far as its digits tell, within the middle 95 % of medians of {RUNS_OF_ORIGINAL} of our runs.",
            markdown_table(
                ("group", "column", "the original", "ours, median", "quartiles", "95 % of medians of four", "agrees"),
                [_row(each) for each in comparisons(results, numerics)],
            ),
            "The paper's claims asked of this reading:",
            markdown_table(
                ("claim", "what", "the paper", "released", "reproduced"),
                [
                    (each.claim, each.subject, each.paper, each.ours, MARKS[each.verdict])
                    for each in claim_answers({"boids": results})
                ],
            ),
        )
    )


def _row(each: Comparison) -> tuple[str, ...]:
    figure, ours = each.figure, each.ours
    return (
        figure.group,
        f"`{figure.column}`",
        figure.text,
        f"{ours.median:.4g}",
        f"{ours.lower:.4g} to {ours.upper:.4g}",
        f"{each.low:.4g} to {each.high:.4g}",
        "yes" if each.agrees else "**no**",
    )
