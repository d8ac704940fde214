"""Made boats with four thrusters that push aslant, one of which is weak: it is named alone, and written as its gain.

The courses are SciPy's, of formulas written out in made/boats.py.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import boats
import numpy as np
import pytest

from cocorosim_ros.diagnosis.diagnose import diagnose
from cocorosim_ros.diagnosis.report.changed_vehicle import as_platform
from cocorosim_ros.diagnosis.report.model_file import Origin, model_yaml
from cocorosim_ros.diagnosis.report.words import check_words
from cocorosim_ros.diagnosis.tracks.own_numbers import gain_key
from cocorosim_ros.scenario.parts.platform import Platform, load_platform
from cocorosim_ros.scenario.parts.steering import Azimuth

CHOPPY = 0.3  # N
DRAG = boats.KNOWN.replace(boats.KNOWN[boats.KNOWN.index("  thruster_lag") :], "")  # known, thrusters follow at once


def drive(platform: Platform, seed: int, weak: str = "", share: float = 1.0) -> Any:
    """Evidence of a drive with one thruster that gives a share of its thrust."""
    shares = np.array([share if name == weak else 1.0 for name in boats.NAMES])
    truth = boats.Truth(lag=0.0, choppy=CHOPPY)
    return boats.recorded(platform, truth, 160.0, seed, lambda commands: shares * commands, boats.vectored)


def found(evidence: Any) -> Any:
    """The diagnosis, without its progress."""
    return diagnose(evidence, lambda words, share: None)


@pytest.mark.parametrize(("seed", "weak", "share"), [(1, "front_left", 0.8), (2, "rear_right", 0.7)])
def test_one_weak_thruster_of_four(tmp_path: Path, seed: int, weak: str, share: float) -> None:
    """It is named with its share, and nothing else is; with the model that is written, nothing is missing."""
    boat = boats.platform(tmp_path, DRAG, boats.with_four())
    told = found(drive(boat, seed, weak, share))
    (effect,) = told.effects
    assert effect.id == "thruster_gain"
    assert effect.name == f"thrust of {weak} unlike that of the others" and check_words(effect.id)
    assert set(effect.parameters) == {weak}
    assert effect.parameters[weak].holds(share) and effect.parameters[weak].value == pytest.approx(share, abs=0.03)
    path = tmp_path / "model.yaml"
    path.write_text(model_yaml(as_platform(told, boat), Origin(boat, ("made",), ("boat",), 160.0)), encoding="utf-8")
    model = load_platform(path)
    gains = {each.name: each.gain for each in model.actuators}
    assert gains == {name: effect.parameters[weak].value if name == weak else None for name in boats.NAMES}
    assert found(drive(model, seed, weak, share)).verdict == "consistent"


def test_one_weak_thruster_of_four_that_follow_three_wishes(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Four commands that are sums of each other, as a pilot's sticks give them: the weak one is named all the same."""
    whole = boats.drive
    monkeypatch.setattr(boats, "drive", lambda seconds, seed: 0.4 * whole(seconds, seed))
    evidence = drive(boats.platform(tmp_path, DRAG, boats.with_four()), 3, "rear_left", 0.6)
    assert np.linalg.matrix_rank(evidence.recordings[0].robots[0].command) == 3
    (effect,) = found(evidence).effects
    assert effect.id == "thruster_gain"
    assert effect.parameters["rear_left"].value == pytest.approx(0.6, abs=0.03)


def test_thrusters_that_push_alike_are_not_told_apart(tmp_path: Path) -> None:
    """Two in one place that push the same way with the same command, beside two that do not: one stands for both."""
    from cocorosim_ros.diagnosis.fitting.recalibration import first_fit
    from cocorosim_ros.diagnosis.naming.single_thrusters import looked_for_alone

    boat = boats.platform(tmp_path, DRAG, boats.with_four())
    twin = replace(boat.actuators[0], name=boats.NAMES[1])
    alike = replace(boat, actuators=(boat.actuators[0], twin, *boat.actuators[2:]))
    evidence = drive(alike, 1)
    (recording,) = evidence.recordings
    (log,) = recording.robots
    command = log.command[:, [0, 0, 2, 3]]
    evidence = replace(evidence, recordings=(replace(recording, robots=(replace(log, command=command),)),))
    told = [each.id for each in looked_for_alone(first_fit(evidence).tracks)]
    assert told == [f"thruster_gain:{name}" for name in (boats.NAMES[0], *boats.NAMES[2:])]


def test_a_vehicle_without_thrusters_has_no_entry() -> None:
    """A glider, which pumps and shifts its weight; the thrusters of an ROV that stood still push as nothing does."""
    from types import SimpleNamespace

    from cocorosim_ros.diagnosis.naming.single_thrusters import thruster_entries
    from cocorosim_ros.diagnosis.tracks.vehicle_model import vehicle_model

    for name in ("slocum_glider", "tauv_pool"):
        vehicle = vehicle_model(load_platform(name))
        log = SimpleNamespace(command=np.zeros((20, len(vehicle.is_thruster))))
        track: Any = SimpleNamespace(vehicle=vehicle, log=log)
        assert thruster_entries([track]) == []


def test_four_sound_thrusters_have_no_name(tmp_path: Path) -> None:
    """The same drive with all of their thrust."""
    assert found(drive(boats.platform(tmp_path, DRAG, boats.with_four()), 1)).effects == ()


def test_a_pair_is_an_asymmetry(tmp_path: Path) -> None:
    """Of two thrusters no single one is looked for: which of them is weak, their sum and difference cannot tell."""
    from cocorosim_ros.diagnosis.fitting.recalibration import first_fit
    from cocorosim_ros.diagnosis.naming.single_thrusters import looked_for_alone, thruster_entries

    pair = first_fit(boats.recorded(boats.platform(tmp_path), boats.Truth(), 60.0, 1)).tracks
    assert looked_for_alone(pair) == []
    assert [each.id for each in thruster_entries(pair)] == ["thruster_gain:left", "thruster_gain:right"]


def test_thrusters_that_turn_are_not_looked_for_alone(tmp_path: Path) -> None:
    """Of four aslant all are; with an azimuth at the first one the three others alone, and that is said."""
    from cocorosim_ros.diagnosis.fitting.recalibration import first_fit
    from cocorosim_ros.diagnosis.naming.single_thrusters import looked_for_alone, turned_remarks

    boat = boats.platform(tmp_path, DRAG, boats.with_four())
    assert [each.id for each in looked_for_alone(first_fit(drive(boat, 1)).tracks)] == [
        f"thruster_gain:{name}" for name in boats.NAMES
    ]
    turned = replace(boat, actuators=(*boat.actuators, Azimuth("turn", boats.NAMES[0], 1.0)))
    evidence = drive(turned, 1)
    (recording,) = evidence.recordings
    (log,) = recording.robots
    angles = np.column_stack([log.command, 0.3 * np.sin(log.command_time)])
    evidence = replace(evidence, recordings=(replace(recording, robots=(replace(log, command=angles),)),))
    tracks = first_fit(evidence).tracks
    assert [each.id for each in looked_for_alone(tracks)] == [f"thruster_gain:{name}" for name in boats.NAMES[1:]]
    (said,) = turned_remarks(tracks[0].vehicle)
    assert f"Whether one of {boats.NAMES[0]} is weak is not looked for" in said
    assert turned_remarks(first_fit(drive(boat, 1)).tracks[0].vehicle) == ()


def test_of_thrusters_that_push_alike_the_first_stands_for_all() -> None:
    """Two vertical thrusters under one command: their sum is all that shows, so that each is the other's rival.

    Level ones that are commanded alike push another way each, and are told.
    """
    from cocorosim_ros.diagnosis.naming.single_thrusters import alike_of, looked_for_alone

    names = ("front", "rear", "left_up", "right_up")
    rng = np.random.default_rng(1)
    level, up = rng.uniform(-1.0, 1.0, (2, 200))
    wrench = np.array([[1.0, 0.0, 0.0, 0.2], [1.0, 0.0, 0.0, -0.2], [0.0, 0.0, 2.0, 0.0], [0.0, 0.0, 1.0, 0.0]])
    own = {gain_key(name): SimpleNamespace(column=f"own_gain.{number}") for number, name in enumerate(names, 1)}
    vehicle = SimpleNamespace(
        is_thruster=np.ones(4, dtype=bool), actuator_wrench=wrench, hull=0.4, own=own, actuator_curve=np.zeros((4, 0))
    )
    tracks: Any = [
        SimpleNamespace(vehicle=vehicle, log=SimpleNamespace(command=np.column_stack([level, level, up, up])))
    ]
    assert [each.id for each in looked_for_alone(tracks)] == [f"thruster_gain:{name}" for name in names[:3]]
    assert alike_of(tracks) == {"front": (), "rear": (), "left_up": ("right_up",), "right_up": ("left_up",)}
    tracks[0].log.command[100:, 3] = -up[100:]
    assert [each.id for each in looked_for_alone(tracks)] == [f"thruster_gain:{name}" for name in names]
