"""Claims C1 to C5: the paper's calibration, done again.

A number is reproduced when it differs from the printed one by no more than one unit of the last digit printed.
Source: Read et al. 2013, section 4.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from cocorosim_ros.study.calibration.section_four import Row, calibration_rows
from cocorosim_ros.study.claims.answers import NOT_REPRODUCED, REPRODUCED, Answer, all_of


@dataclass(frozen=True)
class _Number:
    """A number that the paper prints, with one unit of its last digit."""

    claim: str
    quantity: str  # of calibration.section_four
    printed: float
    digit: float


_TURNS = zip((90, 180, 270, 360), (2.4, 3.7, 4.8, 5.9), strict=True)
NUMBERS: tuple[_Number, ...] = (
    _Number("C1", "rho A Cd / 2", 1.78, 0.01),
    _Number("C1", "terminal speed", 0.075, 0.001),
    _Number("C2", "10 cm from rest", 3.03, 0.01),
    _Number("C3", "pump force at 450 cm^3", 0.1, 0.01),
    _Number("C4", "Cr", 1.14e-4, 1e-6),
    _Number("C4", "terminal yaw rate", 1.48, 0.01),
    *(_Number("C5", f"{angle} deg from rest, I = 0.0005", time, 0.1) for angle, time in _TURNS),
)


_SUBJECTS = {
    "C1": "rho A Cd / 2 [kg/m]; terminal speed [m/s]",
    "C2": "time for 10 cm from rest [s]",
    "C3": "force of the pump at 450 cm^3 [N]",
    "C4": "Cr [N m s^2]; terminal yaw rate [rad/s]",
    "C5": "times to 90, 180, 270, 360 deg with I = 5e-4 kg m^2 [s]",
}


def calibration_answers() -> Iterator[Answer]:
    """C1 to C5 with the paper's integrator and with the accurate one."""
    rows = {row.quantity: row for row in calibration_rows()}
    for claim in dict.fromkeys(number.claim for number in NUMBERS):
        parts = [number for number in NUMBERS if number.claim == claim]
        for numerics in ("paper", "accurate"):
            yield _answer(claim, parts, rows, numerics)


def _answer(claim: str, parts: list[_Number], rows: dict[str, Row], numerics: str) -> Answer:
    ours = [_value(rows[part.quantity], numerics) for part in parts]
    near = [abs(value - part.printed) <= part.digit * (1 + 1e-9) for value, part in zip(ours, parts, strict=True)]
    return Answer(
        claim,
        _SUBJECTS[claim],
        "; ".join(f"{part.printed:g}" for part in parts),
        numerics,
        "; ".join(f"{value:.4g}" for value in ours),
        all_of(REPRODUCED if one else NOT_REPRODUCED for one in near),
    )


def _value(row: Row, numerics: str) -> float:
    value = row.paper_integrator if numerics == "paper" else row.accurate
    if value is None:
        raise ValueError(f"{row.quantity} was not calculated")
    return value
