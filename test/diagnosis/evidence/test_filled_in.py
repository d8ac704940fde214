"""Readings that were interpolated or repeated are found, and nothing else is taken for them."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.evidence.streams.filled_in import filled_in
from cocorosim_ros.diagnosis.evidence.streams.noise import noise_of
from cocorosim_ros.diagnosis.evidence.streams.turning import FULL_TURN

TIME = 0.5 * np.arange(400)


def noisy(seed: int, count: int) -> Any:
    """A slow swing of a metre with a tenth of a metre of noise."""
    return np.sin(0.02 * np.arange(count)) + 0.1 * np.random.default_rng(seed).standard_normal(count)


@pytest.mark.parametrize("every", [2, 3, 10])
@pytest.mark.parametrize("rounding", [None, 2])
def test_readings_between_two_are_found(every: int, rounding: int | None) -> None:
    """One reading in `every` was measured: all others are flagged, also where they are written with two decimals."""
    knots = np.arange(0, 400, every)
    value = 1000.0 + np.interp(np.arange(400), knots, 30.0 * noisy(0, len(knots)))
    value = value if rounding is None else np.round(value, rounding)
    made_up = filled_in(TIME, value)
    between = np.ones(400, dtype=bool)
    between[knots] = False
    inner = slice(1, knots[-1])  # beyond the last knot everything is the same
    assert np.mean(made_up[inner] == between[inner]) > 0.97


def test_readings_that_repeat_the_last_one_are_found() -> None:
    """A sensor of 1 Hz whose logger writes 2 Hz: every second reading says nothing."""
    value = np.repeat(noisy(1, 200), 2)
    made_up = filled_in(TIME, value)
    assert made_up[1:-1:2].all()
    assert not made_up[0::2].any()


@pytest.mark.parametrize(
    "value",
    [
        noisy(2, 400),
        np.sin(0.02 * np.arange(400)),
        np.where(np.arange(400) % 100 < 50, 0.0, np.sin(0.3 * np.arange(400))),
        np.round(noisy(3, 400), 1),
        np.round(10.0 * np.sin(0.02 * np.arange(400)) + 0.01 * noisy(4, 400), 2),
        np.zeros(400),
        np.full(400, np.nan),
        noisy(5, 10),
    ],
    ids=["noise", "swing", "rests", "coarse", "rounded", "constant", "missing", "few"],
)
def test_measured_readings_are_none_of_these(value: Any) -> None:
    """Noise, smooth motion, rests between motions, coarse instruments: nothing is left out."""
    assert not filled_in(TIME[: len(value)], value).any()


def test_missing_readings_do_not_hide_the_pattern() -> None:
    """Every fifth reading is lost: what lies between two others is still found, under the right numbers."""
    knots = np.arange(0, 400, 4)
    value = np.interp(np.arange(400), knots, noisy(6, len(knots)))
    value[2::20] = np.nan
    made_up = filled_in(TIME, value)
    assert made_up[1:-4:4].mean() > 0.9
    assert not made_up[knots].any()
    assert not made_up[np.isnan(value)].any()


@pytest.mark.parametrize("step", [2.0, 1.9], ids=["of which a turn has 180", "of which a turn has no whole number"])
@pytest.mark.parametrize("lost", [0.0, 2.4e-7], ids=["exact", "single precision"])
def test_a_coarse_heading_of_a_vehicle_that_turns_is_measured(step: float, lost: float) -> None:
    """Headings in steps of 2 degrees, counted on over 17 turns, with the digits that are lost on the way."""
    rng = np.random.default_rng(6)
    time = 0.1 * np.arange(3000)
    degrees = np.degrees(0.8 * time * (np.floor(time / 30.0) % 2)) + 0.8 * rng.standard_normal(3000)
    turns = np.floor(degrees / 360.0)
    shown = np.radians(step) * np.rint((degrees - 360.0 * turns) / step) + lost * rng.uniform(-1.0, 1.0, 3000)
    counted_on = shown + FULL_TURN * turns
    assert not filled_in(time, counted_on, FULL_TURN).any()
    noise = np.radians(np.hypot(0.8, step / np.sqrt(12.0)))
    assert noise_of(time, counted_on, FULL_TURN) == pytest.approx(noise, rel=0.15)
