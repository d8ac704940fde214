"""Information that fits have kept, by closed forms of a parabola."""

from __future__ import annotations

import math
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.against.kept_promises import as_kept, promised_gain
from cocorosim_ros.diagnosis.fitting.screening import Screened

INFORMATION, ESTIMATE = 7.0, -3.0


def screened(estimate: float = ESTIMATE, felt: float = math.nan) -> Screened:
    """A candidate of one number, whose likelihood is a parabola with its summit at the estimate."""
    candidate: Any = SimpleNamespace()
    matrix, z = np.array([[INFORMATION]]), np.array([INFORMATION * estimate / math.sqrt(INFORMATION)])
    return Screened(candidate, {}, np.array([estimate]), 1.0, matrix, z, felt)


def begun(each: Screened, gain: float) -> Any:
    """The fit of a screened candidate, with what it gained."""
    return SimpleNamespace(candidate=each.candidate, gain=gain)


def test_the_promise_is_the_height_of_the_parabola() -> None:
    """Half of the information times the square of the estimate."""
    assert promised_gain(screened()) == pytest.approx(0.5 * INFORMATION * ESTIMATE**2)


@pytest.mark.parametrize(("gain", "share"), [(63.0, 1.0), (31.5, 1.0), (10.5, 1.0 / 3.0), (-5.0, 0.0)])
def test_information_is_the_share_that_was_kept(gain: float, share: float) -> None:
    """Of 31.5 promised nats; never more than slopes say, and nothing where a fit gains nothing."""
    each = screened()
    assert as_kept(each, [begun(screened(), 1.0), begun(each, gain)]).information == pytest.approx(share * INFORMATION)


def test_without_a_fit_all_information_stays() -> None:
    """The fits of other candidates say nothing of this one."""
    each = screened()
    assert as_kept(each, [begun(screened(), 0.0)]) is each


def test_a_small_promise_and_a_tried_delay_stay() -> None:
    """A promise of 3.5 nats is below the threshold; sizes of delays are tried one by one."""
    for each in (screened(1.0), screened(felt=3.0)):
        assert as_kept(each, [begun(each, 0.0)]) is each
