"""The second vehicle: six degrees of freedom against closed forms and what a free body keeps; sealed recordings."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest


def _moved(p: Any, s: Any, seconds: float, command: Any = None) -> Any:
    """The state after a time without random forces."""
    from concealer.six_degrees import layout as at
    from concealer.six_degrees.motion import advance

    commands = np.zeros(8) if command is None else command
    for step in range(round(seconds / at.STEP)):
        advance(p, s, commands, np.zeros(4), step * at.STEP)
    return s


def _bare(**places: float) -> Any:
    """(SIZE,) the vehicle without drag, lift and righting, but for these numbers."""
    from concealer.six_degrees import layout as at
    from concealer.six_degrees.makes import ROV

    p = ROV.nominal()
    p[at.LINEAR : at.LINEAR + 12] = 0.0
    p[at.LIFT] = p[at.RIGHTING] = 0.0
    for name, value in places.items():
        p[getattr(at, name.upper())] = value
    return p


def test_a_free_body_keeps_energy_and_its_momenta_in_the_world() -> None:
    """Kirchhoff's equations without forces keep kinetic energy, and linear momentum as the world sees it."""
    from concealer.six_degrees import layout as at
    from concealer.six_degrees.motion import turned

    p, s = _bare(), np.zeros(at.STATE)
    s[at.QUATERNION] = 1.0
    s[at.VELOCITY : at.VELOCITY + 3], s[at.RATE : at.RATE + 3] = (0.4, -0.2, 0.3), (0.5, 0.2, -0.4)

    def kept() -> Any:
        v, w = s[at.VELOCITY : at.VELOCITY + 3], s[at.RATE : at.RATE + 3]
        energy = 0.5 * np.sum(p[at.MASS : at.MASS + 3] * v**2) + 0.5 * np.sum(p[at.INERTIA : at.INERTIA + 3] * w**2)
        return np.array([energy, *turned(s[at.QUATERNION : at.QUATERNION + 4], p[at.MASS : at.MASS + 3] * v)])

    before = kept()
    _moved(p, s, 20.0)
    assert np.linalg.norm(s[at.QUATERNION : at.QUATERNION + 4]) == pytest.approx(1.0, abs=1e-12)
    assert abs(s[at.QUATERNION]) < 0.999
    assert kept() == pytest.approx(before, rel=1e-6, abs=1e-6)


def test_a_tilted_vehicle_swings_as_a_pendulum() -> None:
    """A small roll swings with the period 2 pi sqrt(I / righting) where nothing damps it."""
    from concealer.six_degrees import layout as at

    p, s = _bare(righting=4.0), np.zeros(at.STATE)
    s[at.QUATERNION], s[at.QUATERNION + 1] = math.cos(0.01), math.sin(0.01)
    _moved(p, s, round(math.pi * math.sqrt(0.28 / 4.0) / at.STEP) * at.STEP)
    assert 2.0 * math.asin(s[at.QUATERNION + 1]) == pytest.approx(-0.02, abs=1e-4)


def test_steady_speed_is_where_drag_is_thrust() -> None:
    """All four vectored thrusters at c: 4 cos(45 deg) 40 N c = d u + q u^2; the vehicle goes straight."""
    from concealer.six_degrees import layout as at
    from concealer.six_degrees.makes import ROV

    p, s = ROV.nominal(), np.zeros(at.STATE)
    p[at.LIFT], p[at.RIGHTING] = 0.0, 1e3  # as good as level
    s[at.QUATERNION] = 1.0
    _moved(p, s, 30.0, 0.1 * np.array(ROV.allocation[0]))
    u = (-4.03 + math.sqrt(4.03**2 + 4.0 * 18.18 * 0.4 * math.sqrt(0.5) * 40.0)) / (2.0 * 18.18)
    assert s[at.VELOCITY] == pytest.approx(u, rel=1e-3)
    assert s[at.VELOCITY + 1] == pytest.approx(0.0, abs=1e-9) and s[at.RATE + 2] == pytest.approx(0.0, abs=1e-9)


def test_a_resting_accelerometer_feels_gravity_and_effects_pull_as_they_are_said_to() -> None:
    """At rest, without lift: 9.81 m/s^2 upward; a tether of 2 N/m and 1.5 m pulls 3 N, to be shared by the mass."""
    from concealer.six_degrees import layout as at
    from concealer.six_degrees.motion import felt, level_of

    p, s = _bare(tether=2.0, tether_x=1.5), np.zeros(at.STATE)
    s[at.QUATERNION] = 1.0
    assert felt(p, s, np.zeros(4), 0.0) == pytest.approx([3.0 / 17.0, 0.0, 9.81])
    p = _bare(dead=0.1, reverse=0.2)
    assert [level_of(p, c) for c in (0.1, -0.1, 0.3, -0.5)] == pytest.approx([0.0, 0.0, 0.3, -0.4])


def test_a_towed_cable_takes_what_its_pieces_take() -> None:
    """Straight, 5 m long, at 0.4 m/s across it: an eighth of rho C d l V^2, by twelve pieces but for 1/288 of it.

    Along it there is a fiftieth of that. A bow has drag along the line to the anchor as well, and never gives energy.
    """
    from concealer.six_degrees import layout as at
    from concealer.six_degrees.motion import cable_drag

    p, s = _bare(cable=1.2, cable_x=-3.0), np.zeros(at.STATE)
    s[at.Z], s[at.QUATERNION], s[at.VELOCITY + 1] = -4.0, 1.0, 0.4
    across = 1000.0 * 1.2 * 0.0076 * 5.0 * 0.4**2 / 8.0
    assert cable_drag(p, s) == pytest.approx([0.0, -across * (1.0 - 1.0 / 288.0), 0.0], rel=1e-9, abs=1e-12)
    s[at.VELOCITY : at.VELOCITY + 3] = 0.24, 0.0, -0.32
    along = cable_drag(p, s)
    assert along == pytest.approx(0.02 * across * (1.0 - 1.0 / 288.0) * np.array([-0.6, 0.0, 0.8]), rel=1e-9)
    p[at.CABLE_BOW] = 0.15
    assert cable_drag(p, s) @ s[at.VELOCITY : at.VELOCITY + 3] < along @ s[at.VELOCITY : at.VELOCITY + 3]


@pytest.mark.parametrize(("sign", "lever"), [(1.0, 0.03 * 1.2), (-1.0, 0.03 * 0.8)])
def test_thrust_to_the_side_turns_by_its_lever(sign: float, lever: float) -> None:
    """All four vectored thrusters at c, for sway alone: Y = 4 sin(45 deg) 40 N c; N = lever Y, longer to the left."""
    from concealer.six_degrees import layout as at
    from concealer.six_degrees.makes import ROV
    from concealer.six_degrees.motion import loads

    p, s = _bare(side_lever=0.03, side_uneven=0.2), np.zeros(at.STATE)
    s[at.QUATERNION] = 1.0
    s[at.LEVEL : at.LEVEL + 8] = sign * 0.2 * np.array(ROV.allocation[1])
    force, moment = loads(p, s, np.zeros(4), 0.0)
    sideways = sign * 0.2 * 4.0 * math.sqrt(0.5) * 40.0
    assert force[1] == pytest.approx(sideways)
    assert moment[2] == pytest.approx(lever * sideways, abs=1e-12)


@pytest.fixture(scope="module")
def recordings(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Three sealed recordings of 40 s."""
    from concealer.conceal import conceal
    from concealer.prior import Wish
    from concealer.six_degrees.recording import load

    out = tmp_path_factory.mktemp("rov") / "t"
    assert list(conceal(out, load("rov"), 9, range(3), Wish("single", noise=0.005, duration=40.0))) == [
        "r0000", "r0001", "r0002",
    ]  # fmt: skip
    return out


def test_recordings_of_the_rov_are_sealed_and_the_same_twice(recordings: Path, tmp_path: Path) -> None:
    """All seals hold; the same seed writes the same bytes."""
    from concealer.conceal import conceal
    from concealer.prior import Wish
    from concealer.seal import broken_seals
    from concealer.six_degrees.recording import load

    ledger = recordings / "ledger.json"
    assert broken_seals(ledger, recordings / "envelopes", recordings / "recordings") == []
    again = tmp_path / "t"
    assert len(list(conceal(again, load("rov"), 9, range(3), Wish("single", noise=0.005, duration=40.0)))) == 3
    assert (again / "ledger.json").read_bytes() == ledger.read_bytes()


def test_an_independent_reader_finds_eight_commands_and_an_attitude(recordings: Path) -> None:
    """rosbags reads names and levels of the thrusters and a quaternion of length 1; the envelope names one effect."""
    from concealer.bag import typestore
    from concealer.six_degrees.makes import ROV
    from rosbags.rosbag2 import Reader

    with Reader(recordings / "recordings" / "r0001") as reader:
        first = {
            link.topic.rpartition("/")[2]: typestore().deserialize_cdr(data, link.msgtype)
            for link, _, data in reader.messages()
        }
    assert list(first["thruster_command"].name) == list(ROV.names)
    assert len(first["thruster_command"].command) == 8 and np.abs(first["thruster_command"].command).max() <= 1.0
    q = first["imu"].orientation
    assert math.hypot(q.x, q.y, q.z, q.w) == pytest.approx(1.0, abs=1e-6)
    depth = -first["pose"].pose.position.z
    assert first["pressure"].fluid_pressure == pytest.approx(101325.0 + 9810.0 * depth, abs=6000.0)
    truth = json.loads((recordings / "envelopes" / "r0001.json").read_text())
    assert len(truth["effects"]) == 1 and truth["kind"] == "single"


@pytest.mark.parametrize("name", ["rov", "slender"])
def test_the_platform_file_is_the_vehicle_that_the_concealer_has(name: str) -> None:
    """The file that the tool is given says the Concealer's own nominal numbers, and the same thrusters."""
    from concealer.six_degrees import layout as at
    from concealer.six_degrees.makes import MAKES
    from ruamel.yaml import YAML

    made, file = MAKES[name], Path(__file__).resolve().parents[1] / "trial" / f"{name}_platform.yaml"
    told, p = YAML(typ="safe").load(file.read_text(encoding="utf-8")), made.nominal()
    assert told["name"] == name
    assert told["mass"]["value"] == pytest.approx(p[at.MASS]) and told["drag"]["value"] == p[at.QUADRATIC]
    assert told["yaw_inertia"]["value"] == pytest.approx(p[at.INERTIA + 2])
    added = told["effects"]["added_mass"]
    assert [added[key]["value"] for key in ("sway_minus_surge", "heave_minus_surge")] == pytest.approx(
        list(p[at.MASS + 1 : at.MASS + 3] - p[at.MASS])
    )
    assert [actuator["name"] for actuator in told["actuators"]] == list(made.names)
    for k, actuator in enumerate(told["actuators"]):
        assert actuator["position"]["value"] == pytest.approx(list(made.places[k]))
        assert actuator["direction"]["value"] == pytest.approx(list(made.directions[k]), abs=1e-6)
        assert actuator["maximum"]["value"] == made.thrust
        assert actuator.get("diameter", {"value": p[at.PROPELLER]})["value"] == p[at.PROPELLER]


def test_the_cable_is_that_of_the_platform_file() -> None:
    """The file says its width in millimetres."""
    from concealer.six_degrees import layout as at
    from ruamel.yaml import YAML

    file = Path(__file__).resolve().parents[1] / "trial" / "rov_platform.yaml"
    cable = YAML(typ="safe").load(file.read_text(encoding="utf-8"))["hull"]["cable_diameter"]
    assert cable["value"] == pytest.approx(1e3 * at.CABLE_WIDTH) and cable["unit"] == "mm"


def test_two_effects_are_hidden_where_several_are_wished_for(tmp_path: Path) -> None:
    """They are different entries of the prior, of the sizes of that kind."""
    from concealer.conceal import conceal
    from concealer.prior import Wish
    from concealer.six_degrees.recording import load

    list(conceal(tmp_path / "t", load("rov"), 3, range(2), Wish("several", noise=0.0, duration=20.0)))
    for path in (tmp_path / "t" / "envelopes").iterdir():
        hidden = json.loads(path.read_text())["effects"]
        assert len({effect["id"] for effect in hidden}) == 2
        assert all(effect["id"] in load("rov")["effects"] and 0.3 <= effect["size"] <= 1.0 for effect in hidden)


def test_the_envelope_tells_the_vehicle_by_the_names_of_its_platform_file() -> None:
    """Of the nominal vehicle all numbers are those of the file; another one has its own."""
    from concealer.six_degrees import layout as at
    from concealer.six_degrees.makes import ROV
    from concealer.six_degrees.recording import in_words
    from ruamel.yaml import YAML

    file = Path(__file__).resolve().parents[1] / "trial" / "rov_platform.yaml"
    told, words = YAML(typ="safe").load(file.read_text(encoding="utf-8")), in_words(ROV.nominal(), ROV.nominal())
    for name, value in words.items():
        effect, _, number = name.rpartition(".")
        if effect:
            assert value == pytest.approx(told["effects"][effect][number]["value"], rel=1e-3)
    assert [words[name] for name in ("mass", "inertia", "drag", "yaw_drag")] == pytest.approx(
        [told[name]["value"] for name in ("mass", "yaw_inertia", "drag", "yaw_drag")]
    )
    assert words["assumed"] == pytest.approx({"mass": 17.0, "inertia": 0.28})
    p = ROV.nominal()
    p[at.THRUST], p[at.QUADRATIC] = 44.0, 2.0 * p[at.QUADRATIC]
    words = in_words(p, ROV.nominal())
    assert words["thrust_gain"] == words["yaw_torque_gain"] == pytest.approx(1.1)
    assert words["anisotropic_drag.sway_ratio"] == pytest.approx(21.66 / 36.36)


def test_a_model_that_knows_the_truth_errs_by_what_pushes_alone() -> None:
    """1.7 N on 17 kg without drag, unknown to it: the place is off by 0.1 t^2 / 2; without a push it does not err."""
    from concealer.six_degrees import layout as at
    from concealer.six_degrees.oracle import free_run
    from concealer.six_degrees.programme import drive

    plan, time = np.array([[0.0, 0.0, 0.0, 0.0, 2.0, 0.0]]), np.arange(0.0, 1.0 + 0.5 * at.ROW_TIME, at.ROW_TIME)
    for push in (0.0, 1.7):
        knots = np.zeros((81, 4))
        knots[:, 0] = push
        rows, commands = drive(_bare(), plan, knots, 80)
        expected = [np.mean((0.5 * push / 17.0 * time**2) ** 2), 0.0, 0.0, 0.0]
        assert free_run(_bare(), rows, commands, 1.0) == pytest.approx(expected, rel=1e-6, abs=1e-15)


def test_an_effect_that_is_hidden_is_known_to_the_model_that_knows_the_truth() -> None:
    """A swinging force and a battery go on from the moment at which a window begins."""
    from concealer.six_degrees import layout as at
    from concealer.six_degrees.makes import ROV
    from concealer.six_degrees.oracle import free_run
    from concealer.six_degrees.programme import drawn, drive

    p = ROV.nominal()
    p[[at.SWING, at.SWING_OMEGA, at.BATTERY, at.LAG, at.DURATION]] = 3.0, 0.4, 0.5, 0.2, 30.0
    rows, commands = drive(p, drawn(np.random.default_rng(1), 30.0, ROV.pilot), np.zeros((301, 4)), 300)
    assert np.ptp(rows[:, at.X]) > 0.1
    assert free_run(p, rows, commands, 5.0) == pytest.approx(np.zeros(4), abs=1e-12)


def test_the_noise_of_the_pose_is_that_of_its_readings() -> None:
    """A late pose that errs by 2 cm to and fro and turns by 0.01 rad has just that noise, whatever the motion."""
    from concealer.sensors import Stream
    from concealer.six_degrees import layout as at
    from concealer.six_degrees.oracle import noise

    clock = np.arange(0.0, 20.0 + 0.5 * at.ROW_TIME, at.ROW_TIME)
    rows, time = np.zeros((len(clock), at.ROW)), np.arange(2.0, 20.0, 0.25)
    rows[:, at.X], yaw = 0.5 * clock, 0.3 * (time - 0.4)
    rows[:, at.QUATERNION], rows[:, at.QUATERNION + 3] = np.cos(0.15 * clock), np.sin(0.15 * clock)
    sign = np.where(np.arange(time.size) % 2, 1.0, -1.0)
    values = np.zeros((time.size, 7))
    values[:, 0] = 0.5 * (time - 0.4) + 0.02 * sign
    values[:, 5], values[:, 6] = np.sin(0.5 * (yaw + 0.01 * sign)), np.cos(0.5 * (yaw + 0.01 * sign))
    found = noise(Stream("pose", time, time, values), rows, 0.4)
    assert found == pytest.approx([0.02, 0.0, 0.0, 0.01], rel=1e-6, abs=1e-9)
