"""A vehicle of which all is slower is diagnosed as the quick one: no time of a diagnosis is a Lily's.

The same recording, with all times k times as long, of a vehicle with forces to match (`made/slowed.py`): verdict and
names are the same, and so are numbers, by the vehicle's own time. A boat that coasts for one second becomes a ship that
coasts for twenty.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any, NamedTuple

import boats
import numpy as np
import pytest
from slowed import POWER_OF_TIME, slow_platform, slowed

from cocorosim_ros.diagnosis.diagnose import diagnose
from cocorosim_ros.diagnosis.evidence.intake import take_in
from cocorosim_ros.diagnosis.tracks.vehicle_model import vehicle_model
from cocorosim_ros.diagnosis.tracks.vehicle_size import coasting_time

K, WIDTH, SECONDS = 20.0, 0.09, 120.0
LAG = "  thruster_lag: {time_constant: {value: 0.35, unit: s, source: made}}\n"
# The quick boat's grid is as fine as a millimetre asks for, the slow one's as a tenth of a second does: so they take a
# random push that holds for half a second for other numbers of noise. What hangs on these is alike to a few percent.
BY_NOISE = 0.1


def plain(command: Any) -> Any:
    """Shares of the full force as they are commanded."""
    return command


def beyond(command: Any) -> Any:
    """Shares of the full force: what exceeds the dead band."""
    return np.sign(command) * np.maximum(np.abs(command) - WIDTH, 0.0)


class Hidden(NamedTuple):
    """What the platform's file says, what the thrusters do, and what a diagnosis has to name, with its true size."""

    known: str
    thrust: Callable[[Any], Any]
    named: dict[str, dict[str, float]]


HIDDEN = {
    "nothing": Hidden(boats.KNOWN, plain, {}),
    "lag": Hidden(boats.KNOWN.replace(LAG, ""), plain, {"thruster_lag": {"time_constant": 0.35}}),
    "dead band": Hidden(boats.KNOWN, beyond, {"thruster_deadband": {"width": WIDTH}}),
}


class Alike(NamedTuple):
    """What a diagnosis found: numbers by the vehicle's own time, in which 1 s is k seconds."""

    verdict: str
    named: dict[str, dict[str, float]]
    moved: dict[str, float]
    nats: dict[str, float]
    errors: dict[str, float]


def found(evidence: Any, k: float) -> Alike:
    """Diagnose a recording of which all times are k times as long."""
    diagnosis = diagnose(evidence, lambda words, share: None)

    def quick(estimate: Any) -> float:
        return float(estimate.value / k ** POWER_OF_TIME[estimate.unit])

    return Alike(
        diagnosis.verdict,
        {each.id: {name: quick(number) for name, number in each.parameters.items()} for each in diagnosis.effects},
        {each.parameter: quick(each.estimate) for each in diagnosis.recalibrated},
        {each.id: each.nats for each in diagnosis.effects},
        {channel: row.augmented for channel, row in diagnosis.fit.items()},
    )


@pytest.mark.parametrize("hidden", HIDDEN)
def test_a_slow_vehicle_is_diagnosed_as_a_quick_one(tmp_path: Path, hidden: str) -> None:
    """The same names with the same numbers; evidence and errors of free runs, too, as far as noise is alike."""
    case = HIDDEN[hidden]
    boat = boats.platform(tmp_path, case.known)
    evidence = boats.recorded(boat, boats.Truth(choppy=0.5), SECONDS, 1, case.thrust)
    quick, slow = found(evidence, 1.0), found(slowed(evidence, tmp_path / "boat.yaml", K), K)
    assert slow.verdict == quick.verdict
    assert slow.named.keys() == quick.named.keys() == case.named.keys()
    for effect, numbers in case.named.items():
        assert slow.named[effect] == pytest.approx(quick.named[effect], rel=0.01)
        assert slow.named[effect] == pytest.approx(numbers, rel=0.1)
    assert slow.moved == pytest.approx(quick.moved, rel=0.01)
    assert slow.nats == pytest.approx(quick.nats, rel=BY_NOISE)
    assert slow.errors == pytest.approx(quick.errors, rel=BY_NOISE)


def test_a_slowed_boat_coasts_for_so_much_longer(tmp_path: Path) -> None:
    """A boat of 12 kg coasts for 1.5 / sqrt(0.2 * 10) s, until half of its turn is gone; a ship made of it K times."""
    boat = vehicle_model(boats.platform(tmp_path, boats.KNOWN))
    ship = vehicle_model(slow_platform(tmp_path / "boat.yaml", K))
    assert coasting_time(boat, boat.row) == pytest.approx(boats.INERTIA / np.sqrt(0.2 * 2 * boats.FULL * boats.ARM))
    assert coasting_time(ship, ship.row) == pytest.approx(K * coasting_time(boat, boat.row), rel=1e-9)


@pytest.mark.parametrize("k", [1.0, K, 60.0])
def test_a_mirrored_axis_of_a_slow_vehicle_is_seen(tmp_path: Path, k: float) -> None:
    """Yaw is recorded clockwise; of the slowest, which coasts for a minute, once in six seconds."""
    boat = boats.platform(tmp_path, boats.KNOWN)
    evidence = boats.recorded(boat, boats.Truth(choppy=0.5), SECONDS, 1)
    (recording,) = evidence.recordings
    (log,) = recording.robots
    clockwise = replace(log.streams["pose"], value=log.streams["pose"].value * (1.0, 1.0, 1.0, -1.0))
    log = replace(log, streams={"pose": clockwise})
    wrong = replace(evidence, recordings=(replace(recording, robots=(log,)),))
    (mixup,) = take_in(slowed(wrong, tmp_path / "boat.yaml", k)).mixups
    assert mixup.correction.matrix is not None
    np.testing.assert_array_equal(mixup.correction.matrix, np.diag([1.0, 1.0, 1.0, -1.0]))
