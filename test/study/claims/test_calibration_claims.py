"""C1 to C5: verdicts from the closed forms of the calibration."""

from __future__ import annotations

import math

import pytest

from cocorosim_ros.study.claims.calibration_claims import calibration_answers


def test_calibration_claims() -> None:
    """10 cm take 3.17 s (x = m/k ln cosh), not 3.03 s; quarter turns fit the paper's integrator alone."""
    answers = {(answer.claim, answer.numerics): answer for answer in calibration_answers()}
    verdicts = {key: answer.verdict for key, answer in answers.items()}
    assert [verdicts[f"C{number}", "paper"] for number in range(1, 6)] == [
        *("reproduced", "not reproduced", "reproduced", "reproduced", "reproduced")
    ]
    assert verdicts["C5", "accurate"] == "not reproduced"
    drag = 0.01 / 0.075**2
    exact = 0.44 / math.sqrt(drag * 0.01) * math.acosh(math.exp(0.1 * drag / 0.44))
    assert float(answers["C2", "accurate"].ours) == pytest.approx(exact, abs=2e-3)
