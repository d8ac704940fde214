"""The slender AUV of the Concealer: its water, its lift, its propellers, its pilot and its log against closed forms."""

from __future__ import annotations

import json
import math
from pathlib import Path

import numpy as np
import pytest


def test_the_slender_hull_has_the_water_of_its_spheroid() -> None:
    """Lamb's integrals of a prolate spheroid, here by quadrature over the confocal ones around it.

    Added mass along an axis is A / (2 - A) of the displaced water, with A = a b^2 times the integral over l from 0 of
    1 / ((axis^2 + l) (a^2 + l)^1/2 (b^2 + l)).
    """
    from concealer.six_degrees.makes import SLENDER
    from scipy.integrate import quad

    a, b = 0.7, 0.17
    water = 1000.0 * 4.0 / 3.0 * math.pi * a * b * b
    for axis, told in ((a, SLENDER.mass[0]), (b, SLENDER.mass[1])):
        integral = quad(lambda x, s=axis: 1.0 / ((s * s + x) * math.sqrt(a * a + x) * (b * b + x)), 0.0, math.inf)[0]
        share = a * b * b * integral
        assert told == pytest.approx(water * (1.0 + share / (2.0 - share)), rel=2e-3)


def test_a_hull_that_drifts_is_lifted_at_its_centre() -> None:
    """40 kg/m, 0.5 m/s astern and 0.1 m/s to the left: Y = -2 N less the stall's share, N = Y times 0.2 m behind."""
    from concealer.six_degrees import layout as at
    from concealer.six_degrees.makes import SLENDER
    from concealer.six_degrees.motion import loads

    p, s = SLENDER.nominal(), np.zeros(at.STATE)
    p[at.LINEAR : at.LINEAR + 12] = p[at.LIFT] = 0.0
    s[at.QUATERNION], s[at.VELOCITY], s[at.VELOCITY + 1] = 1.0, -0.5, 0.1
    p[[at.HULL_LIFT, at.HULL_CENTRE, at.HULL_STALL]] = 40.0, -0.2, 0.26
    force, moment = loads(p, s, np.zeros(4), 0.0)
    assert force == pytest.approx([0.0, -2.0 * (1.0 - 0.26 * 0.01 / 0.26), 0.0], abs=1e-12)
    assert moment == pytest.approx([0.0, 0.0, 0.2 * 1.98], abs=1e-12)


@pytest.mark.parametrize(
    ("front", "rear", "lost_front", "lost_rear"),
    [
        (0.4, 0.4, 0.0, 1.0),  # the rear one lies in the jet
        (-0.4, -0.4, 1.0, 0.0),  # jets go ahead
        (0.2, 0.4, 0.0, 0.5),  # by the ratio of both thrusts
        (0.4, 0.2, 0.0, 1.0),  # but no more
        (0.4, -0.4, 0.0, 0.0),  # jets meet
        (0.4, 0.0, 0.0, 0.0),
    ],
)
def test_a_propeller_in_a_jet_loses_what_the_rule_says(
    front: float, rear: float, lost_front: float, lost_rear: float
) -> None:
    """One diameter behind another propeller three quarters of the jet are left; tunnel thrusters lie beside it."""
    from concealer.six_degrees import layout as at
    from concealer.six_degrees.makes import SLENDER
    from concealer.six_degrees.motion import washed

    p, s = SLENDER.nominal(), np.zeros(at.STATE)
    p[at.WASH] = 0.8
    s[at.LEVEL : at.LEVEL + 6] = front, rear, 0.3, 0.3, 0.3, 0.3
    expected = [0.6 * lost_front, 0.6 * lost_rear, 0.0, 0.0, 0.0, 0.0]
    assert [washed(p, s, k) for k in range(6)] == pytest.approx(expected, rel=1e-9)


def test_a_pilot_steers_towards_the_heading_of_a_segment() -> None:
    """A quarter of a minute after 2 rad were asked for, the slender AUV heads about there; the ROV turns as told."""
    from concealer.six_degrees.makes import ROV, SLENDER
    from concealer.six_degrees.programme import drive, heading_of

    plan = np.array([[0.0, 0.1, 0.0, 2.0, 2.0, 1.0]])
    rows, commands = drive(SLENDER.nominal(), plan, np.zeros((151, 4)), 150)
    assert heading_of(rows[-1]) == pytest.approx(2.0, abs=0.3)
    assert commands[-1, :2] == pytest.approx([0.2, 0.0])  # all of the demand by the front propeller
    plan = np.array([[0.0, 0.0, 0.0, 0.03, 2.0, 0.0]])
    rows, commands = drive(ROV.nominal(), plan, np.zeros((41, 4)), 40)
    assert commands[-1, :4] == pytest.approx([0.03, -0.03, 0.03, -0.03], abs=1.0 / 400.0)


def test_a_log_over_ground_shows_the_faults_of_a_log() -> None:
    """At 0.5 m/s ahead and 0.4 rad/s to the left: 4 % too much, askew by 0.1 rad, or 0.3 m before the origin."""
    from concealer.six_degrees import layout as at
    from concealer.six_degrees.effects import Scene
    from concealer.six_degrees.instruments import Instruments
    from concealer.six_degrees.makes import SLENDER

    rows = np.zeros((round(40.0 / at.ROW_TIME) + 1, at.ROW))
    rows[:, at.QUATERNION], rows[:, at.VELOCITY], rows[:, at.RATE + 2] = 1.0, 0.5, 0.4
    numbers = {"ground_velocity": {"rate": 5.0, "noise": [0.0, 0.0]}, "transport": 0.004}
    for fault, expected in (
        ({}, [0.5, 0.0]),
        ({"log_scale": 0.04, "log_warmth": (20.0, 0.3)}, [0.52, 0.0]),
        ({"log_turn": (0.1, 0.1)}, [0.5 * math.cos(0.1), -0.5 * math.sin(0.1)]),
        ({"log_place": (0.3, 0.1)}, [0.5 - 0.04, 0.12]),
    ):
        scene = Scene(SLENDER.nominal())
        for name, value in fault.items():
            setattr(scene.log, name, value)
        told = Instruments(rows, scene, numbers, np.random.default_rng(0)).velocity("ground_velocity")
        assert told.topic == "ground_velocity" and len(told.stamp) == pytest.approx(200, abs=1)
        assert told.values[:, :2].mean(axis=0) == pytest.approx(expected, abs=1e-4)


def test_a_recording_of_the_slender_auv_has_a_log_over_ground_alone(tmp_path: Path) -> None:
    """An independent reader finds its log, six commands and no log through the water."""
    from concealer.bag import typestore
    from concealer.conceal import conceal
    from concealer.prior import Wish
    from concealer.six_degrees.makes import SLENDER
    from concealer.six_degrees.recording import load
    from rosbags.rosbag2 import Reader

    wish = Wish("single", ("ground_log_scale",), size=0.5, noise=0.0, duration=20.0)
    assert list(conceal(tmp_path / "t", load("slender"), 3, range(1), wish)) == ["r0000"]
    truth = json.loads((tmp_path / "t" / "envelopes" / "r0000.json").read_text())
    assert abs(truth["effects"][0]["parameters"]["scale"] - 1.0) == pytest.approx(0.04)
    assert truth["effects"][0]["topic"] == "ground_velocity"
    with Reader(tmp_path / "t" / "recordings" / "r0000") as reader:
        first = {
            link.topic.rpartition("/")[2]: typestore().deserialize_cdr(data, link.msgtype)
            for link, _, data in reader.messages()
        }
    assert set(first) == {"pose", "compass", "pressure", "imu", "ground_velocity", "thruster_command"}
    assert list(first["thruster_command"].name) == list(SLENDER.names) and len(first["thruster_command"].command) == 6
