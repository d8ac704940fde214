"""What the paper claims about shoaling, as data, and whether tables of results bear it out.

A claim compares a group with another by one metric and says: large and higher, large and lower, or not large. It is
reproduced when A lies on the claimed side of the thresholds 0.29 and 0.71, not reproduced when it lies on the other,
and not decidable while the interval of A contains the threshold.
Source: Read et al. 2013, section 5 and figure 4.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from cocorosim_ros.study.claims.answers import DASH, NO_RUNS, NOT_DECIDABLE, NOT_REPRODUCED, REPRODUCED, Answer
from cocorosim_ros.study.results.effect_size import LARGE, Effect, effect
from cocorosim_ros.study.results.results import Results

HIGHER, LOWER, NOT_LARGE = "higher", "lower", "not large"
_THRESHOLDS = (1.0 - LARGE, LARGE)


@dataclass(frozen=True)
class Claim:
    """One sentence of the paper that a table can answer."""

    name: str
    design: str
    group: str
    against: str
    metric: str
    paper: str  # HIGHER or LOWER: and large; or NOT_LARGE


@dataclass(frozen=True)
class Finding:
    """The answer in one kind of numerics."""

    claim: Claim
    numerics: str
    effect: Effect
    verdict: str


def _claims(design: str, against: str, rows: str) -> tuple[Claim, ...]:
    words = [line.split() for line in rows.strip().splitlines()]
    signs = {"+": HIGHER, "-": LOWER, "0": NOT_LARGE}
    return tuple(Claim(name, design, group, against, metric, signs[sign]) for name, group, metric, sign in words)


CLAIMS: tuple[Claim, ...] = (
    *_claims(
        "boids",
        "Van",
        """
        S1  BLT polarisation +
        S2  BLC polarisation +
        S3  NA  polarisation -
        S4  BLT angular_momentum -
        S5  BLC angular_momentum -
        S6  NA  angular_momentum +
        S7  BLT shoal_speed 0
        S8  BLC shoal_speed 0
        S9  NA  shoal_speed -
        S10 BLT separation -
        S11 BLC separation -
        S12 NA  separation +
        S13 BLT lost -
        S14 BLC lost 0
        S15 NA  lost +
        S16 BLT shoals -
        S17 BLC shoals 0
        S18 NA  shoals 0
        """,
    ),
    *_claims("boids", "BLT", "S21 BLC lost +\nS21 BLC shoals +"),
    *_claims(
        "turbulence",
        "T0",
        """
        T1 T5e-4 polarisation -
        T1 T5e-4 shoal_speed -
        T2 T5e-4 angular_momentum 0
        T2 T5e-4 separation 0
        T2 T5e-4 lost 0
        T2 T5e-4 shoals 0
        T3 T5e-3 polarisation -
        T3 T5e-3 angular_momentum +
        T3 T5e-3 shoal_speed -
        T3 T5e-3 separation +
        T3 T5e-3 lost +
        T3 T5e-3 shoals +
        """,
    ),
)
"""S19, S20, T4 and T5 sum these up (claims.overall_claims); S22 is about a mechanism (claims.mechanism)."""


def verdict_of(paper: str, found: Effect) -> str:
    """Whether an effect is what the paper says, as far as its interval tells."""
    if found.size == "undefined":
        return NO_RUNS
    low, high = _THRESHOLDS
    borders = {HIGHER: (high,), LOWER: (low,), NOT_LARGE: (low, high)}[paper]
    if any(found.low < border < found.high for border in borders):
        return NOT_DECIDABLE
    right = (found.size == "large" and found.direction == paper) or (paper == NOT_LARGE and found.size != "large")
    return REPRODUCED if right else NOT_REPRODUCED


def found_in(results: Results, numerics: str, claim: Claim) -> Finding:
    """The answer to a claim by the runs of its groups."""
    ours = results.values(numerics, claim.group, claim.metric)
    found = effect(ours, results.values(numerics, claim.against, claim.metric))
    return Finding(claim, numerics, found, verdict_of(claim.paper, found))


def findings(experiments: Mapping[str, Results]) -> Iterator[Finding]:
    """Every claim in every kind of numerics; those of designs that are not there are left out."""
    for claim in CLAIMS:
        results = experiments.get(claim.design)
        for numerics in results.numerics if results is not None else ():
            if results is not None:
                yield found_in(results, numerics, claim)


def with_interval(found: Effect) -> str:
    """A and its interval in words."""
    return f"A = {found.value:.3f} ({found.low:.3f} to {found.high:.3f})"


def shown(found: Effect) -> str:
    """An effect in words: direction, size, A with its interval."""
    if found.size == "undefined":
        return DASH
    how = f"{found.direction}, {found.size}" if found.size != "none" else "no effect"
    return f"{how}; {with_interval(found)}"


def claim_answers(experiments: Mapping[str, Results]) -> list[Answer]:
    """The findings in words."""
    answers = []
    for finding in findings(experiments):
        claim = finding.claim
        subject = f"{claim.group} against {claim.against}: {claim.metric.replace('_', ' ')}"
        paper = claim.paper if claim.paper == NOT_LARGE else f"{claim.paper}, large"
        answers.append(Answer(claim.name, subject, paper, finding.numerics, shown(finding.effect), finding.verdict))
    return answers
