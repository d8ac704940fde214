"""Section 4 of the paper again, against closed forms and the checks in print."""

from __future__ import annotations

import math

import pytest

from cocorosim_ros.study.calibration import section_four as four
from cocorosim_ros.study.calibration.free_run import ACCURATE, PAPER


def test_drag_and_yaw_drag_by_hand() -> None:
    """0.01 / 0.075^2 = 1.7778 kg/m; 0.01 * 0.055 cos 63 deg / 1.48^2 = 1.13995e-4 N m s^2."""
    assert four.drag_coefficient() == pytest.approx(1.77778, rel=1e-5)
    assert four.yaw_drag_coefficient() == pytest.approx(1.13995e-4, rel=1e-5)


def test_pump_force_by_hand() -> None:
    """10 cm^3 of water weigh 0.0981 N; 440 cm^3 are neutral."""
    assert four.pump_force(450e-6) == pytest.approx(0.0981)
    assert four.pump_force(440e-6) == pytest.approx(0.0, abs=1e-15)


def test_ten_centimetres_from_rest() -> None:
    """Exactly 3.170 s by (m/k) ln cosh; the accurate run agrees; the paper's steps give 2.870 s."""
    assert four.start_time_in_closed_form(0.01, 0.44, four.drag_coefficient()) == pytest.approx(3.170, abs=5e-4)
    assert four.start_time(ACCURATE) == pytest.approx(3.170, abs=1e-3)
    assert four.start_time(PAPER) == pytest.approx(2.870, abs=1e-3)


@pytest.mark.parametrize("stepper", [ACCURATE, PAPER])
def test_terminal_speeds(stepper: object) -> None:
    """7.5 cm/s and 1.48 rad/s with either integrator: a steady state knows no step."""
    assert four.terminal_rate(four.AHEAD, 0, stepper) == pytest.approx(0.075, rel=1e-6)  # type: ignore[arg-type]
    assert four.terminal_rate(four.TURNING, 3, stepper) == pytest.approx(1.48, rel=1e-6)  # type: ignore[arg-type]


@pytest.mark.parametrize("inertia", [4.05e-4, 5e-4])
def test_turns_in_closed_form(inertia: float) -> None:
    """psi = (I/Cr) ln cosh(t sqrt(Cr tau)/I), solved for t, at all four quarters."""
    torque, drag = 0.01 * 0.055 * math.cos(math.radians(63.0)), four.yaw_drag_coefficient()
    for quarter, time in enumerate(four.turn_times(inertia, ACCURATE), 1):
        exact = inertia / math.sqrt(drag * torque) * math.acosh(math.exp(0.5 * math.pi * quarter * drag / inertia))
        assert time == pytest.approx(exact, abs=1e-3)


def test_moments_of_inertia() -> None:
    """Best fits 4.05e-4 (accurate) and 5.08e-4 (the paper's steps); the paper's 5e-4 fits its steps alone."""
    assert four.best_inertia(ACCURATE) == pytest.approx(4.05e-4, rel=0.003)
    assert four.best_inertia(PAPER) == pytest.approx(5.08e-4, rel=0.003)
    assert four.turn_misfit(5e-4, PAPER) == pytest.approx(0.031, abs=1e-3)
    assert four.turn_misfit(5e-4, ACCURATE) == pytest.approx(0.314, abs=1e-3)


def test_findings_name_the_numbers() -> None:
    """The inconsistencies are told with their numbers, each checked by hand."""
    told = " ".join(four.findings())
    for number in ("3.35 mm/s", "0.562 kg/m", "13.3 cm/s", "0.0111 N", "0.396 kg", "450.19 cm^3", "0.243 rad/s"):
        assert number in told


def test_the_table_has_what_was_measured() -> None:
    """Terminal speed, 10 cm, yaw rate and the four quarter turns stand in the table with their measurements."""
    measured = [row.measured for row in four.calibration_rows() if row.measured is not None]
    assert measured == [0.075, 3.03, 1.48, *2 * [2.4, 3.7, 4.8, 5.9]]
