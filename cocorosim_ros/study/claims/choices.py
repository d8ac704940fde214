"""What becomes of the claims when one open choice of the paper is switched.

In a design whose name ends in `_choices` the group "X, choice" is the group X of the paper's design under that
choice. A claim about X against Y is then asked of "X, choice" against "Y, choice", or against Y where Y does not know
the choice.
"""

from __future__ import annotations

from dataclasses import dataclass

from cocorosim_ros.study.claims.claims import CLAIMS, Claim, Finding, found_in
from cocorosim_ros.study.results.results import SEPARATOR, Results

SUFFIX = "_choices"
AS_BEFORE = "as in the paper's design"


@dataclass(frozen=True)
class Choices:
    """The findings of one design of choices in one kind of numerics."""

    design: str
    numerics: str
    choices: tuple[str, ...]
    rows: tuple[tuple[Claim, tuple[Finding | None, ...]], ...]
    """Each claim with its finding under every choice; None where the choice does not touch it."""


def choices_of(results: Results) -> list[Choices]:
    """The tables of a design of choices, one for each kind of numerics; none for other designs."""
    if not results.about["design"].endswith(SUFFIX):
        return []
    claims = [claim for claim in CLAIMS if claim.design == results.about["design"].removesuffix(SUFFIX)]
    names = list(dict.fromkeys(_choice(group) for group in results.groups))
    return [
        Choices(
            results.about["design"],
            numerics,
            tuple(name or AS_BEFORE for name in names),
            tuple((claim, tuple(_found(results, numerics, claim, name) for name in names)) for claim in claims),
        )
        for numerics in results.numerics
    ]


def _choice(group: str) -> str:
    return group.partition(SEPARATOR)[2]


def _found(results: Results, numerics: str, claim: Claim, choice: str) -> Finding | None:
    def under_choice(group: str) -> str:
        wanted = f"{group}{SEPARATOR}{choice}" if choice else group
        return wanted if wanted in results.groups else group

    asked = Claim(
        claim.name, claim.design, under_choice(claim.group), under_choice(claim.against), claim.metric, claim.paper
    )
    if choice and asked.group == claim.group:
        return None
    return found_in(results, numerics, asked)
