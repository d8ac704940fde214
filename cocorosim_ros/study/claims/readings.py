"""How far a verdict depends on what a metric is taken to mean.

The paper leaves open over whom, from which centre, in which direction and how over time its metrics are taken. A claim
is asked again of every named variant of its metric, summed up over time as its own definition says and, where that
means something, as mean and as median over time.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from cocorosim_ros.study.claims.answers import REPRODUCED
from cocorosim_ros.study.claims.claims import CLAIMS, Claim, verdict_of
from cocorosim_ros.study.metrics import FAMILIES, METRICS
from cocorosim_ros.study.results.effect_size import effect
from cocorosim_ros.study.results.results import Results


@dataclass(frozen=True)
class Readings:
    """A claim in one kind of numerics: in how many readings of its metric it is reproduced."""

    claim: Claim
    numerics: str
    reproduced: tuple[str, ...]
    """Columns of the table of results."""
    asked: tuple[str, ...]


def columns_of(metric: str) -> list[str]:
    """Every column that is a reading of a metric of the paper; counts have no mean or median over time."""
    family = next(family for family in FAMILIES if metric in [member.name for member in family.metrics])
    columns = []
    for member in family.metrics:
        counts = METRICS[member.name].summary == "last"
        columns += [member.name] if counts else [f"{member.name}{time}" for time in ("_time_mean", "_time_median")]
    return columns


def readings_of(experiments: Mapping[str, Results]) -> Iterator[Readings]:
    """Every claim about a metric, in every kind of numerics."""
    for claim in CLAIMS:
        results = experiments.get(claim.design)
        for numerics in results.numerics if results is not None else ():
            if results is not None:
                asked = columns_of(claim.metric)
                agree = tuple(name for name in asked if _verdict(results, numerics, claim, name) == REPRODUCED)
                yield Readings(claim, numerics, agree, tuple(asked))


def _verdict(results: Results, numerics: str, claim: Claim, column: str) -> str:
    ours, theirs = (results.values(numerics, group, column) for group in (claim.group, claim.against))
    return verdict_of(claim.paper, effect(ours, theirs))
