"""Sticks of a platform: what becomes of them, and the sentences about what no autopilot can do."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.parts.mixing import FullSticks, Mixing
from cocorosim_ros.scenario.parts.platform import (
    Platform,
    load_platform,
    platform_tree,
    read_platform,
    read_platform_file,
)
from cocorosim_ros.scenario.parts.stick_mixing import StickMixing
from cocorosim_ros.scenario.parts.thrust_curve import ThrustCurve
from cocorosim_ros.scenario.parts.vehicle_parts import Thruster
from cocorosim_ros.scenario.reading.entry import entry_of
from cocorosim_ros.world.six_degrees.description import vehicle_of
from cocorosim_ros.world.vehicle_model.curves import forces_at

LEVER = 0.024969477485675073  # m, of Lily's thrusters in config/platforms/lily.yaml, which push with 0.005 N each
TABLE = """\
based_on: lily
name: steered
description: Lily by sticks
mixing:
  form: table
  rows:
    - {actuator: left, weights: {value: [1, 0, 0, 0, 0, -1], unit: "1", source: made}}
    - {actuator: right, weights: {value: [1, 0, 0, 0, 0, 1], unit: "1", source: made}}
    - {actuator: buoyancy, weights: {value: [0, 0, 0.5, 0, 0, 0], unit: "1", source: made}}
"""
ALLOCATION = f"""\
based_on: lily
name: steered
description: Lily by forces and torques
mixing:
  form: allocation
  full_sticks:
    surge: {{value: 0.01, unit: N, source: made}}
    yaw: {{value: {2 * 0.005 * LEVER!r}, unit: N m, source: made}}
"""
FULL = (30.0, 20.0, 40.0, 2.0, 3.0, 4.0)  # N and N m, well within what the ROV can
UNITS = ("N", "N", "N", "N m", "N m", "N m")
AXES = ("surge", "sway", "heave", "roll", "pitch", "yaw")
ROV = "based_on: bluerov2_heavy\nname: rov\ndescription: by sticks\nmixing:\n  form: allocation\n  full_sticks:\n" + (
    "".join(
        f"    {axis}: {{value: {full}, unit: {unit}, source: made}}\n"
        for axis, full, unit in zip(AXES, FULL, UNITS, strict=True)
    )
)


def platform_of(text: str, tmp_path: Path) -> Platform:
    """The platform of this file."""
    path = tmp_path / "steered.yaml"
    path.write_text(text)
    return read_platform_file(path)


def mixing_of(platform: Platform) -> StickMixing:
    """Its mixing, which is there."""
    mixing = platform.stick_mixing()
    assert mixing is not None
    return mixing


def test_a_table_adds_up(tmp_path: Path) -> None:
    """Left is surge less yaw, right both, the pump half of heave; what is more than all is cut, by each alone."""
    mixing = mixing_of(platform_of(TABLE, tmp_path))
    assert (mixing.sticks, mixing.driven) == (("surge", "heave", "yaw"), ("left", "right", "buoyancy"))
    found = mixing.commands(np.array([[0.5, 1.0, 0.25], [1.0, 0.0, -1.0], [-9.0, -0.5, 0.0]]))
    np.testing.assert_allclose(found, [[0.25, 0.75, 0.5], [1.0, 0.0, 0.0], [-1.0, -1.0, -0.25]], atol=1e-15)


def test_an_allocation_of_two_thrusters(tmp_path: Path) -> None:
    """All of surge is both at full, all of yaw one against the other: X = l + r, N = (r - l) LEVER."""
    mixing = mixing_of(platform_of(ALLOCATION, tmp_path))
    assert (mixing.sticks, mixing.driven) == (("surge", "yaw"), ("left", "right"))
    found = mixing.commands(np.array([[1.0, 0.0], [0.0, 1.0], [0.5, -0.25], [0.0, 0.0]]))
    np.testing.assert_allclose(found, [[1, 1], [-1, 1], [0.75, 0.25], [0, 0]], atol=1e-14)


def test_eight_thrusters_give_what_six_sticks_ask_for(tmp_path: Path) -> None:
    """Through the published curve and back: the forces make the wrench, and have no part that makes none."""
    platform = platform_of(ROV, tmp_path)
    sticks = np.random.default_rng(3).uniform(-1.0, 1.0, (20, 6))
    force = forces_at(platform, mixing_of(platform).commands(sticks))
    wrench = vehicle_of(platform).wrench
    np.testing.assert_allclose(force @ wrench, sticks * np.array(FULL), atol=1e-9)
    null = np.linalg.svd(wrench.T)[2][6:]
    np.testing.assert_allclose(force @ null.T, 0.0, atol=1e-9)


@pytest.mark.parametrize(("stick", "upward"), [("heave", True), ("yaw", False)])
def test_thrusters_without_a_part_in_it_rest_within_a_dead_band(stick: str, upward: bool) -> None:
    """Of eight thrusters the four that push up give heave alone, and the four level ones yaw.

    What rounding of the pseudo-inverse leaves of the others would become a command beyond their dead band.
    """
    curve = ThrustCurve("square", dead_band=0.075)
    thrusters = [part for part in load_platform("bluerov2_heavy").actuators if isinstance(part, Thruster)]
    parts = [replace(part, curve=curve) for part in thrusters]
    mixing = StickMixing(Mixing("allocation", full_sticks=FullSticks(*FULL)), parts)
    found = mixing.commands(np.eye(6)[[AXES.index(stick)]])[0]
    driven = np.array([(abs(part.direction[2]) > 0.5) == upward for part in parts])
    assert np.count_nonzero(driven) == 4
    assert (found[~driven] == 0.0).all() and (np.abs(found[driven]) > 0.075).all()


CURVES = {
    "square": "{form: square}",
    "dead band": "{form: square, dead_band: {value: 0.1, unit: '1', source: made}}",
    "linear": "{form: linear, dead_band: {value: 0.2, unit: '1', source: made}}",
    "table": (
        "{form: table, commands: {value: [-1, -0.3, -0.1, 0, 0.1, 0.6, 1], unit: '1', source: made}, "
        "forces: {value: [-8, -1, 0, 0, 0, 5, 16], unit: N, source: made}}"
    ),
    "forwards": (
        "{form: table, commands: {value: [0, 0.2, 1], unit: '1', source: made}, "
        "forces: {value: [0, 0, 16], unit: N, source: made}}"
    ),
}
SINGLE = """\
based_on: lily
name: single
description: one propeller
actuators:
  - name: stern
    kind: thruster
    position: {value: [-0.4, 0, 0], unit: m, source: made}
    direction: {value: [1, 0, 0], unit: "1", source: made}
    maximum: {value: 16, unit: N, source: made}
    maximum_reverse: {value: REVERSE, unit: N, source: made}
    gain: {value: 0.5, unit: "1", source: made}
    curve: CURVE
mixing:
  form: allocation
  full_sticks: {surge: {value: 16, unit: N, source: made}}
"""


@pytest.mark.parametrize("name", CURVES)
def test_every_curve_is_turned_round(name: str, tmp_path: Path) -> None:
    """The thruster of the data sheet gives the force that is asked for; one of half the gain, half of it."""
    reverse = 0.0 if name == "forwards" else 8.0
    platform = platform_of(SINGLE.replace("CURVE", CURVES[name]).replace("REVERSE", str(reverse)), tmp_path)
    sticks = np.linspace(-1.0, 1.0, 81)
    force = forces_at(platform, mixing_of(platform).commands(sticks[:, np.newaxis]))[:, 0]
    np.testing.assert_allclose(force, 0.5 * np.maximum(16.0 * sticks, -reverse), atol=1e-12)


def test_a_turned_thruster_is_left_out(tmp_path: Path) -> None:
    """What an azimuth turns pushes elsewhere than the allocation would count on."""
    text = SINGLE.replace("CURVE", "{form: square}").replace("REVERSE", "8")
    turning = "  - {name: servo, kind: azimuth, thruster: stern, largest_angle: {value: 90, unit: deg, source: made}}\n"
    with pytest.raises(CocorosimError, match="of rank 0, and 1 axes are commanded"):
        platform_of(text.replace("mixing:", f"{turning}mixing:"), tmp_path)


def test_it_is_written_and_read_back(tmp_path: Path) -> None:
    """What a run or a diagnosis notes of its platform."""
    for text in (TABLE, ALLOCATION, ROV):
        platform = platform_of(text, tmp_path)
        assert read_platform(entry_of(platform_tree(platform), "written")) == platform


@pytest.mark.parametrize(
    ("text", "old", "new", "sentence"),
    [
        (TABLE, "left,", "lef,", r"rows\[0\].actuator' has 'lef', which is no actuator.*did you mean 'left'"),
        (TABLE, "right,", "left,", "has 'left' a second time"),
        (TABLE, "[1, 0, 0, 0, 0, -1]", "[1, 0, 0, 0, 0]", r"rows\[0\].weights' has \[1, 0, 0, 0, 0\]; write 6 values"),
        (TABLE, "[1, 0, 0, 0, 0, -1]", "[1, 0, 0, 0, 0, 1]", r"of rank 2, and 3 axes are commanded \(surge, hea"),
        (TABLE, "form: table", "form: allocation", "mixing' lacks 'full_sticks', which 'form: allocation' needs"),
        (TABLE, "form: table", "form: quadratic", "has 'quadratic'"),
        (TABLE, 'unit: "1", source', "source", "lacks 'unit'"),
        (ALLOCATION, "form: allocation", "form: table", "lacks 'rows'"),
        (ALLOCATION, "unit: N m", "unit: N", "full_sticks.yaw' has .*which is not a torque"),
        (ALLOCATION, "yaw:", "sway:", "full_sticks.sway' has .*which is not a force"),
        (ALLOCATION, "yaw:", "roll:", r"matrix of rank 1, and 2 axes are commanded \(surge, roll\): these 2 thrusters"),
        (ALLOCATION, "value: 0.01", "value: 0", "must be greater than zero"),
        (SINGLE, "name: stern", "name: surge", "has the stick 'surge', and an actuator is called so too"),
        (SINGLE, "{surge: {value: 16, unit: N, source: made}}", "{}", "full_sticks' names no stick"),
        (
            SINGLE,
            "CURVE",
            CURVES["table"].replace("0.1, 0.6", "0.5, 0.6").replace("0, 5, 16", "6, 5, 16"),
            "falls from 6 N to 5 N",
        ),
    ],
)  # fmt: skip
def test_what_cannot_be_is_one_sentence(text: str, old: str, new: str, sentence: str, tmp_path: Path) -> None:
    """File, key, what was found and what is allowed."""
    assert old in text
    wrong = text.replace(old, new, 1).replace("CURVE", "{form: square}").replace("REVERSE", "8")
    with pytest.raises(CocorosimError, match=sentence) as caught:
        platform_of(wrong, tmp_path)
    assert "steered.yaml line " in str(caught.value)


def test_the_examples_of_the_documentation(tmp_path: Path) -> None:
    """Both that config/README.md shows are in order, for the vehicle that `cocorosim new platform` begins."""
    root = Path(__file__).parents[2] / "config"
    vehicle = (root / "templates" / "platform.yaml").read_text("utf-8")
    blocks = [part.split("```")[0] for part in (root / "README.md").read_text("utf-8").split("```yaml\n")[1:]]
    examples = [block for block in blocks if block.startswith("mixing:")]
    assert len(examples) == 2
    commented = vehicle[vehicle.index("# mixing:") :].split("\n\n")[0]
    examples.append("\n".join(line.removeprefix("# ") for line in commented.splitlines()))
    for example in examples:
        mixing = mixing_of(platform_of(f"{vehicle}\n{example}", tmp_path))
        assert (mixing.sticks, mixing.driven) == (("surge", "yaw"), ("left", "right"))
        assert mixing.commands(np.array([[1.0, 0.0]])) == pytest.approx(np.ones((1, 2)))
