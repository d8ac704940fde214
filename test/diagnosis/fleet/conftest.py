"""Outcomes of fleets that were never recorded: their numbers are drawn, so that what they hold is known."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.fleet.outcome import Outcome
from cocorosim_ros.diagnosis.fleet.recordings import FileState

NUMBERS = {"thrust_gain": (1.0, "1"), "drag": (1.7778, "kg/m"), "inertia": (4.05e-4, "kg m^2")}
START_NS = 1_700_000_000_000_000_000
USUAL = {"loss": 0.0, "scatter": 0.005, "own": 0.05}
DAY_NS = 24 * 3600 * 10**9
Z95 = 1.959963984540054


def number(parameter: str, off: float, spread: float, robot: str) -> dict[str, Any]:
    """A fitted number whose logarithm is `off` the nominal one, as diagnosis.json has it."""
    nominal, unit = NUMBERS[parameter]
    low, value, high = (nominal * math.exp(off + end * spread) for end in (-Z95, 0.0, Z95))
    return {
        "parameter": parameter, "nominal": nominal, "value": value, "ci95": [low, high], "unit": unit,
        "robots": [robot],
    }  # fmt: skip


@pytest.fixture(scope="session")
def outcome() -> Callable[..., Outcome]:
    """Function of a recording's name, its robot, day, numbers (parameter: off, spread) and effects: its outcome."""

    def make(
        name: str,
        robot: str,
        day: float | None,
        numbers: dict[str, tuple[float, float]],
        effects: Any = (),
        **more: Any,
    ) -> Outcome:
        fitted = [number(parameter, off, spread, robot) for parameter, (off, spread) in numbers.items()]
        moved = [each for each in fitted if not each["ci95"][0] <= each["nominal"] <= each["ci95"][1]]
        diagnosis = {
            "verdict": "mismatch" if effects else "recalibrate" if moved else "consistent",
            "recalibrated": moved, "effects": list(effects), "not_shown_by_this_recording": ["tether"],
            "cannot_be_told": [], "warnings": [], "screened": {}, "missing_in": [],
        } | more.pop("diagnosis", {})  # fmt: skip
        found = {
            "robots": [robot], "start_ns": None if day is None else START_NS + int(day * DAY_NS),
            "dated_by": "nothing" if day is None else "stamps", "duration": 600.0, "sha256": name,
            "sentence": "It <is> so.", "diagnosis": diagnosis, "numbers": fitted, "remarks": [],
        } | more  # fmt: skip
        return Outcome(name, (FileState(f"{name}/a.mcap", 1, 1),), found=found)

    return make


@pytest.fixture(scope="session")
def drawn_fleet(outcome: Callable[..., Outcome]) -> Callable[..., list[Outcome]]:
    """Function of a generator, robots and weeks: outcomes whose numbers scatter more than their intervals say.

    loss: share of its thrust that lily_01 loses a week. scatter: rms between recordings of a robot. own: half-width of
    the robots' own deviations.
    """

    def make(rng: np.random.Generator, robots: int, weeks: int, **drawn: float) -> list[Outcome]:
        loss, scatter, own = (drawn.get(name, usual) for name, usual in USUAL.items())
        made = []
        for robot in range(robots):
            deviations = rng.uniform(-own, own, len(NUMBERS))
            for week in range(weeks):
                day = 7.0 * week + rng.uniform(0.0, 2.0)
                offs = deviations + scatter * rng.standard_normal(len(NUMBERS))
                spreads = 0.002 * rng.uniform(0.7, 1.4, len(NUMBERS))
                offs = offs + spreads * rng.standard_normal(len(NUMBERS))
                if robot == 0:
                    offs[0] += math.log1p(-loss) * day / 7.0
                name = f"lily_{robot + 1:02d}"
                numbers = {parameter: (offs[k], spreads[k]) for k, parameter in enumerate(NUMBERS)}
                made.append(outcome(f"week_{week:02d}/{name}", name, day, numbers))
        return made

    return make
