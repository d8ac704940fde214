"""What a fit knows of a common factor of all that turns a made boat: its priors, since the random moment is fitted too.

The course is SciPy's, of formulas written out in made/boats.py. Moments, inertia and drag of a boat that turns by its
thrusters alone may all be twice as large: nothing that it does is otherwise, with twice the random moment.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import boats
import numpy as np
import pytest

from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES
from cocorosim_ros.diagnosis.fitting.beside_noise import variances_beside_noise
from cocorosim_ros.diagnosis.fitting.candidate import expand
from cocorosim_ros.diagnosis.fitting.fit import Fit, covariance, evaluated
from cocorosim_ros.diagnosis.fitting.recalibration import base_fit, first_fit
from cocorosim_ros.scenario.parts.platform import load_platform

OF_TURNS = ("yaw_torque_gain", "yaw_drag", "inertia")
RATED = {"linear": 0.0, "lag": 0.0, "choppy": 0.5}


@pytest.fixture(scope="module")
def fit(tmp_path_factory: pytest.TempPathFactory) -> Fit:
    """The recalibrated model of a boat all of whose numbers of turns are fitted."""
    open_inertia = boats.PLATFORM.replace("yaw_inertia: {{value: 1.5,", "yaw_inertia: {{value: 1.5, range: [0.15, 15],")
    boat = boats.platform(tmp_path_factory.mktemp("boat"), "drag_form: own_speed", open_inertia)
    return base_fit(boats.recorded(boat, boats.Truth(**RATED), 120.0, 5))


def test_a_common_factor_is_known_by_the_priors_alone(fit: Fit) -> None:
    """Its variance is one over the sum of the precisions of all that share it; the noise held hides that."""
    names = [unknown.owner.parameter for unknown in fit.unknowns]
    assert all(fit.unknowns[names.index(name)].logarithmic for name in OF_TURNS)
    moment = next(unknown for unknown in fit.noise if unknown.column == "random.moment")
    priors = [moment.prior, *(fit.unknowns[names.index(name)].prior for name in OF_TURNS)]
    common = 1.0 / sum(prior**-2 for prior in priors)
    found, held = variances_beside_noise(fit), np.diag(covariance(fit))
    for name in OF_TURNS:
        place = names.index(name)
        assert common * 0.999 < found[place] < common + 4.0 * held[place]
        assert held[place] < 0.8 * common


def test_other_numbers_stay_about_as_sure(fit: Fit) -> None:
    """About: thrust and drag are known by the mass, which is given. Nothing becomes surer than with the noise held."""
    found, held = variances_beside_noise(fit), np.diag(covariance(fit))
    assert (found >= held).all()
    others = [place for place, unknown in enumerate(fit.unknowns) if unknown.owner.parameter in ("thrust_gain", "drag")]
    assert others and (found[others] < 2.0 * held[others]).all()


@pytest.mark.parametrize(
    ("identifier", "topic", "q"), [("thruster_deadband", None, 0.5), ("sensor_latency", "velocity", 0.4)]
)
def test_what_changes_in_jumps_is_known_by_the_step_of_its_slopes(
    swim_with_logs: Callable[..., Any], identifier: str, topic: str | None, q: float
) -> None:
    """A width that no command is near, or a delay within a step, seemed as unknown as its prior, of deviation 1."""
    fit = first_fit(swim_with_logs(load_platform("lily"), 60.0, 3))
    entry = next(each for each in ENTRIES if (each.id, each.topic) == (identifier, topic))
    (candidate,) = expand([entry], fit.tracks, fit.rows)
    unknowns = (*fit.unknowns, *candidate.amplitudes())
    more = evaluated(
        replace(fit, unknowns=unknowns, q=np.concatenate([fit.q, np.full(len(candidate.amplitudes()), q)]))
    )
    assert math.sqrt(variances_beside_noise(more)[-1]) < 0.2
