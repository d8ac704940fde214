"""Every claim of the paper with its answers."""

from __future__ import annotations

from collections.abc import Mapping

from cocorosim_ros.analysis.answers import Answer
from cocorosim_ros.analysis.calibration_claims import calibration_answers
from cocorosim_ros.analysis.claims import claim_answers
from cocorosim_ros.analysis.mechanism import mechanism_answers
from cocorosim_ros.analysis.method_claims import method_answers
from cocorosim_ros.analysis.overall_claims import overall_answers
from cocorosim_ros.analysis.results import Results

STUDIES = ("boids", "turbulence", "boids_choices", "turbulence_choices")
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
