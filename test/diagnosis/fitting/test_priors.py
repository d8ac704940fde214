"""The prior of a number of the platform is normal near its centre and exponential beyond; all others are normal."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import quad

from cocorosim_ros.diagnosis.fitting.unknowns import PLATFORM, RANDOM_FORCE, Owner, Unknown, log_prior, prior_weights


def number(effect: str = PLATFORM, prior: float = 0.2, centre: float = 0.0) -> Unknown:
    """One number with a prior."""
    return Unknown(Owner(effect, ("a",), "drag", "kg/m"), "drag", (0,), 1.0, prior=prior, centre=centre)


@pytest.mark.parametrize(("q", "density"), [(0.1, -0.125), (0.2, -0.5), (-0.4, -1.5), (2.0, -9.5)])
def test_the_density_of_huber(q: float, density: float) -> None:
    """By hand, of t = q / 0.2: -t^2 / 2 up to |t| = 1, 1/2 - |t| beyond."""
    assert log_prior([number()], np.array([q])) == pytest.approx(density)


@pytest.mark.parametrize("q", [0.05, 0.19, 0.21, -0.7, 3.0])
def test_the_pull_is_the_slope_of_the_density(q: float) -> None:
    """Between any place and the centre, the pull adds up to the density."""
    unknown = number(centre=0.01)
    whole, _ = quad(lambda at: -float(prior_weights([unknown], np.array([at]))[0]) * (at - 0.01), 0.01, q, limit=200)
    assert whole == pytest.approx(log_prior([unknown], np.array([q])), rel=1e-6)


def test_other_numbers_have_normal_priors() -> None:
    """Five standard deviations of a noise count 12.5 nats, and its weight is that at the centre."""
    noise = number(RANDOM_FORCE)
    assert log_prior([noise], np.array([1.0])) == pytest.approx(-12.5)
    assert prior_weights([noise, number(prior=np.inf)], np.array([1.0, 5.0])).tolist() == pytest.approx([25.0, 0.0])


@pytest.mark.parametrize("truth", [0.1, 1.0, 5.0])
def test_a_second_fit_stays_where_the_first_one_ended(truth: float) -> None:
    """A measurement of standard deviation s and the prior balance within s^2 / 0.2 of the measurement, however far it
    is; so a fit that begins at the balance of another one moves by less than that. By hand.
    """
    spread = 0.02
    before = 0.0
    for _ in range(2):
        unknown = number(centre=before)
        q = np.linspace(before, truth + 0.1, 200_001)
        objective = [log_prior([unknown], np.array([each])) for each in q[::100]]
        best = q[::100][np.argmax(np.array(objective) - 0.5 * ((q[::100] - truth) / spread) ** 2)]
        assert truth - best <= spread**2 / 0.2 + (q[100] - q[0])
        before = float(best)
