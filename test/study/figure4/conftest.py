"""A factorial and a figure that a test can search without a simulation."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest


@pytest.fixture
def searched() -> Callable[..., Any]:
    """Function of (number of factors, mean distance by setting, rounds): every stage of a search, results left out."""
    from cocorosim_ros.scenario.reading.entry import entry_of
    from cocorosim_ros.study.experiments.factorial import Factor, Factorial
    from cocorosim_ros.study.figure4.scores import Score
    from cocorosim_ros.study.figure4.search import Done, next_stage

    def search(factors: int, distance: Callable[[tuple[bool, ...]], float], rounds: int) -> list[Any]:
        nothing = entry_of({}, "a test")
        named = tuple(Factor(f"factor_{number}", "on, else off", ("Van",), nothing) for number in range(factors))
        factorial = Factorial("made", "for tests", "boids", "Van", named, ("Van",), 4, 6, rounds, 3, 20, 400, {})
        stages: list[Any] = []
        while (stage := next_stage(factorial, stages)) is not None:
            scores = tuple(Score(one, {}, (), (distance(one),)) for one in stage.settings)
            stages.append(Done(stage, None, scores))  # type: ignore[arg-type]
        return stages

    return search
