"""What an error of a sensor is: its numbers, and how it changes what is shown."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.scenario.parts.parameter import Parameter

Hook = Callable[..., Any]


@dataclass(frozen=True)
class Change:
    """How an error changes one number of a reading; `numbers` are those of its parameters that it takes.

    shown(value, truth, stamp, *numbers) returns what is shown in place of `value`, which other errors may have changed,
    where an ideal sensor would show `truth` at `stamp` [s]. slope(row, *numbers) returns its derivative by the truth
    at the state `row`; None where that is 1. foreseen: `shown` in the filter, where it needs other functions.
    """

    kind: str  # of sensors.KINDS
    numbers: tuple[str, ...]
    shown: Hook
    slope: Hook | None = None
    foreseen: Hook | None = None


@dataclass(frozen=True)
class SensorError:
    """One way in which instruments, cameras or clocks are wrong by a law; what is random is sensors.corruption.

    sensor: the topic that it is of; '' for all. against: the regressor along which the report draws it.
    """

    summary: str
    parameters: tuple[Parameter, ...]
    sensor: str = ""
    changes: tuple[Change, ...] = ()
    against: str = "t"


@kernel
def added(value: float, truth: float, stamp: float, amount: float) -> float:
    """Return what is shown with a constant amount on top."""
    return value + amount
