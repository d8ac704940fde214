"""The claims of the paper asked of the best common reading: in its readings of the metrics, and in all others."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

from cocorosim_ros.study.claims.answers import REPRODUCED
from cocorosim_ros.study.claims.claims import CLAIMS, Claim, Finding, found_in
from cocorosim_ros.study.results.results import Results


@dataclass(frozen=True)
class Asked:
    """One claim under the best setting."""

    claim: Claim
    chosen: Finding
    """In the reading of its metric that was chosen before these runs."""
    usual: Finding
    """In this project's own reading of its metric."""
    columns: int
    reproduced_in: int
    """In how many of so many readings of its metric it is reproduced."""


def asked_of(
    results: Results, figure: str, chosen: Mapping[str, str], columns: Mapping[str, tuple[str, ...]]
) -> list[Asked]:
    """Every claim about the figure; `columns` are the readings of each metric that can be meant."""
    numerics = results.numerics[0]
    found = []
    for claim in (one for one in CLAIMS if one.design == figure):
        every = [found_in(results, numerics, replace(claim, metric=column)) for column in columns[claim.metric]]
        found.append(
            Asked(
                claim,
                found_in(results, numerics, replace(claim, metric=chosen[claim.metric])),
                found_in(results, numerics, claim),
                len(every),
                sum(one.verdict == REPRODUCED for one in every),
            )
        )
    return found
