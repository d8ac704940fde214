"""Candidates that no search looks for, and that are asked once all is named."""

from __future__ import annotations

from cocorosim_ros.diagnosis.fitting.candidate import Candidate
from cocorosim_ros.diagnosis.fitting.drag_forms import drag_form_of
from cocorosim_ros.diagnosis.fitting.fit import Fit
from cocorosim_ros.diagnosis.fitting.screening import Screen
from cocorosim_ros.diagnosis.fitting.smoothed import smoothed_tracks
from cocorosim_ros.diagnosis.naming.contest import Refined, begin, log_evidence, refine
from cocorosim_ros.diagnosis.naming.residual import scene_of


def asked_at_last(fit: Fit, candidate: Candidate) -> Refined:
    """Fit a candidate beside all numbers of a fit, from the best of its starts."""
    scene = scene_of(fit.tracks, smoothed_tracks(fit), drag_form_of(fit))
    screen = Screen(fit, scene)
    return refine(begin(fit, screen.searched(screen.test(candidate)), scene), log_evidence(fit))
