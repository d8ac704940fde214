"""The released reading as a part of the page of the claims: beside the original's figures, and claim by claim."""

from __future__ import annotations

from cocorosim_ros.study.claims.answers import MARKS
from cocorosim_ros.study.claims.claims import claim_answers
from cocorosim_ros.study.claims.markdown import markdown_table
from cocorosim_ros.study.claims.original import DESIGN, RUNS_OF_ORIGINAL, Comparison, comparisons
from cocorosim_ros.study.results.results import Results

IN_CURRENTS = "turbulence_released"
ASKED_AS = {DESIGN: "boids", IN_CURRENTS: "turbulence"}
"""Designs of the released reading, and the designs of the paper's text whose claims are asked of them."""


def released_part(results: Results) -> str:
    """Heading, what is compared, and the claims of one design of the released reading; nothing for another design."""
    design = results.about["design"]
    if design not in ASKED_AS:
        return ""
    parts = [
        f"## The released reading: `{design}`",
        *(_beside_original(results) if design == DESIGN else _in_currents()),
    ]
    answers = [
        (each.claim, each.subject, each.paper, each.ours, MARKS[each.verdict])
        for each in claim_answers({ASKED_AS[design]: results})
    ]
    table = markdown_table(("claim", "what", "the paper", "released", "reproduced"), answers)
    return "\n\n".join((*parts, "The paper's claims asked of this reading:", table))


def _beside_original(results: Results) -> tuple[str, str]:
    return (
        "The boids, Lily and numerics of the authors' released model, beside figures that this model itself gave "
        f"when it was run, medians of {RUNS_OF_ORIGINAL} runs a group. A figure agrees when it lies, "
        f"as far as its digits tell, within the middle 95 % of medians of {RUNS_OF_ORIGINAL} of our runs.",
        markdown_table(
            ("group", "column", "the original", "ours, median", "quartiles", "95 % of medians of four", "agrees"),
            [_row(each) for each in comparisons(results, results.numerics[0])],
        ),
    )


def _in_currents() -> tuple[str]:
    return (
        "The same robots in the water of the released model: its diffusion, walls, cold spots and lever. Its wakes of "
        "50 times the thruster's force are the thruster's own force here, since motion runs away with them in steps "
        "of 0.5 s. Figures of the original in currents are not known.",
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
