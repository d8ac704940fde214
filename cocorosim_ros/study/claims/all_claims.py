"""Every claim of the paper with its answers."""

from __future__ import annotations

from collections.abc import Mapping

from cocorosim_ros.study.claims.answers import Answer
from cocorosim_ros.study.claims.calibration_claims import calibration_answers
from cocorosim_ros.study.claims.claims import claim_answers
from cocorosim_ros.study.claims.mechanism import mechanism_answers
from cocorosim_ros.study.claims.method_claims import method_answers
from cocorosim_ros.study.claims.overall_claims import overall_answers
from cocorosim_ros.study.results.results import Results

STUDIES = ("boids", "turbulence", "boids_choices", "turbulence_choices", "boids_released", "turbulence_released")
"""The designs that the claims are asked of."""


def all_answers(experiments: Mapping[str, Results]) -> list[Answer]:
    """Claims about runs by the results that are there; those about calibration, mechanism and method here and now."""
    return [
        *calibration_answers(),
        *claim_answers(experiments),
        *overall_answers(experiments),
        *mechanism_answers(),
        *method_answers(experiments),
    ]
