"""A mass that slides in the hull, by closed forms: its moment, where the vehicle comes to rest, how it swings there."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.parts.platform import load_platform, platform_tree, read_platform
from cocorosim_ros.scenario.reading.entry import entry_of
from cocorosim_ros.world.six_degrees.description import vehicle_of
from cocorosim_ros.world.six_degrees.vehicle import Vehicle
from cocorosim_ros.world.vehicle_model.platform_effects import check_platform

Make = Callable[..., Any]
MASS, HEIGHT, GRAVITY = 10.0, 0.05, 9.81  # kg, m of buoyancy over weight, m/s^2
SLIDING, TRAVEL = 2.0, 0.1  # kg, m
SHIPPED = Path(__file__).parents[3] / "config/platforms/bluerov2_heavy.yaml"
PART = """  - name: battery
    kind: sliding_mass
    mass: {value: 2, unit: kg, source: made}
    direction: {value: [1, 0, 0], unit: "1", source: made}
    travel: {value: 5, unit: cm, source: made}
"""


def glider(direction: Any = (1.0, 0.0, 0.0), damping: float = 0.0) -> Vehicle:
    """A neutral vehicle whose one actuator is a mass that slides along `direction`."""
    return Vehicle(
        mass=MASS, inertia=np.diag([0.3, 0.5, 0.6]), added_mass=np.diag([3.0, 3.0, 3.0, 0.1, 0.2, 0.25]),
        linear=damping * np.eye(6), centre_of_buoyancy=np.array([0.0, 0.0, HEIGHT]), weight=MASS * GRAVITY,
        buoyancy=MASS * GRAVITY, gravity=GRAVITY, wrench=np.zeros((1, 6)), limit=np.full((1, 2), TRAVEL),
        sliding={0: SLIDING * np.array(direction)},
    )  # fmt: skip


def angles(states: Any) -> Any:
    """(n, 3) roll, pitch and yaw [rad]."""
    return Rotation.from_quat(states[:, 3:7]).as_euler("xyz")


@pytest.mark.parametrize("pitch", [0.0, 0.4, -1.1])
@pytest.mark.parametrize("share", [1.0, -0.3])
def test_its_moment_falls_with_the_cosine(swim: Make, start: Make, pitch: float, share: float) -> None:
    """After a millisecond q = (m_s g s cos(pitch) - m g d sin(pitch)) t / I, to a millionth part."""
    q = swim(glider(), start(pitch=pitch), 0.001, 0.001, [share])[-1, 11]
    moment = SLIDING * GRAVITY * share * TRAVEL * math.cos(pitch) - MASS * GRAVITY * HEIGHT * math.sin(pitch)
    assert q == pytest.approx(moment * 0.001 / 0.7, rel=1e-5)


@pytest.mark.parametrize(
    ("direction", "axis", "sign"), [((1.0, 0.0, 0.0), 1, 1.0), ((0.0, 1.0, 0.0), 0, -1.0)], ids=["pitch", "roll"]
)
@pytest.mark.parametrize("share", [0.8, -0.25])
def test_it_rests_where_buoyancy_is_over_weight(
    swim: Make, start: Make, direction: Any, axis: int, sign: float, share: float
) -> None:
    """tan(angle) = m_s s / (m d): bow down for a mass ahead, left side down for one to the left."""
    found = angles(swim(glider(direction, damping=1.0), start(), 60.0, 0.05, [share]))[-1]
    expected = np.zeros(3)
    expected[axis] = sign * math.atan(SLIDING * share * TRAVEL / (MASS * HEIGHT))
    np.testing.assert_allclose(found, expected, atol=1e-9)


def test_it_swings_about_that_rest(swim: Make, start: Make) -> None:
    """As a pendulum of the whole moment, hypot(m g d, m_s g s): angle = rest + a cos(omega t), to the cube of a."""
    rest, amplitude = math.atan(SLIDING * TRAVEL / (MASS * HEIGHT)), 0.001
    states = swim(glider(), start(pitch=rest + amplitude), 10.0, 0.01, [1.0])
    omega = math.sqrt(GRAVITY * math.hypot(MASS * HEIGHT, SLIDING * TRAVEL) / 0.7)
    swing = angles(states)[:, 1] - rest
    assert np.abs(swing - amplitude * np.cos(omega * np.arange(len(states)) * 0.01)).max() < 10 * amplitude**3


def test_in_the_middle_it_is_not_there(swim: Make, start: Make) -> None:
    """At command 0 the vehicle moves bit for bit as without it."""
    without = replace(glider(), sliding={})
    tumbling = start([0.3, 0.1, -0.2, 0.5, -0.4, 0.2], roll=0.3, pitch=-0.2)
    assert np.array_equal(swim(glider(), tumbling, 5.0, 0.05, [0.0]), swim(without, tumbling, 5.0, 0.05, [0.0]))


def shipped(folder: Path, part: str = PART, old: str = "", new: str = "") -> Any:
    """The ROV with a sliding mass, and a piece of its file replaced."""
    text = SHIPPED.read_text("utf-8").replace("\nsensors:", f"{part}\nsensors:", 1)
    assert old in text
    path = folder / "rov.yaml"
    path.write_text(text.replace(old, new, 1) if old else text)
    return load_platform(path)


def test_a_platform_has_it(tmp_path: Path) -> None:
    """Its numbers reach the vehicle, and it is written and read back."""
    platform = shipped(tmp_path)
    vehicle = vehicle_of(platform)
    assert vehicle.sliding[8].tolist() == [2.0, 0.0, 0.0]
    assert vehicle.limit[8].tolist() == [0.05, 0.05]
    assert not vehicle.wrench[8].any()
    check_platform(platform)
    assert read_platform(entry_of(platform_tree(platform), "written")) == platform


@pytest.mark.parametrize(
    ("old", "new", "sentence"),
    [
        ("mass: {value: 2,", "mass: {value: 20,", "'mass' has '13.5 kg', and its sliding masses have 20 kg; these are"),
        ("value: 5, unit: cm", "value: 50, unit: cm", r"'battery' has the 'travel' 0\.5 m to each side, .* 'hull' of"),
        ("value: 5, unit: cm", "value: 0, unit: cm", "must be greater than zero"),
        ("unit: kg, source: made", "unit: m, source: made", "which is not a mass"),
    ],
)
def test_what_cannot_be_is_one_sentence(old: str, new: str, sentence: str, tmp_path: Path) -> None:
    """More than the whole vehicle, out of the hull, no way to go."""
    with pytest.raises(CocorosimError, match=sentence):
        check_platform(shipped(tmp_path, old=old, new=new))


def test_a_level_vehicle_has_none(tmp_path: Path) -> None:
    """The sentence says what to do where roll and pitch are recorded."""
    text = (SHIPPED.parent / "remus100.yaml").read_text("utf-8")
    text = text.replace("\nsensors:", f"{PART}\nsensors:", 1)
    path = tmp_path / "level.yaml"
    path.write_text(text[: text.index("six_degrees:\n")] + text[text.index("actuators:\n") :])
    with pytest.raises(CocorosimError, match=r"\[3\]' is a sliding mass, which acts .* leave it out: where roll"):
        load_platform(path)
