"""What a platform file says below `six_degrees`, and the sentences about what cannot be."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.parts.platform import load_platform, read_platform_file
from cocorosim_ros.scenario.parts.six_degrees import COUPLED, unit_of
from cocorosim_ros.world.six_degrees.description import vehicle_of

PITCH = "force: heave, motion: pitch, number: {value: "
EFFECT = "{linear_drag: {surge: {value: 1, unit: N s/m, source: hand}}}"
QUADRATIC = "matrix: quadratic_damping, force: sway, motion: yaw, number: {value: -0.632, unit: kg m,"
LINEAR = "matrix: linear_damping, force: sway, motion: yaw, number: {value: 0.5, unit: N s,"
SHIPPED = Path(__file__).parents[2] / "config/platforms"


@pytest.mark.parametrize(
    ("name", "old", "new", "sentence"),
    [
        ("bluerov2_heavy", "value: [0.26, 0.23, 0.37]", "value: [0.26, 0.23, 0.6]", "which no body has"),
        ("bluerov2_heavy", "value: [0.26, 0.23, 0.37]", "value: [0.26, 0.23]", r"\[xx, yy, zz\]"),
        ("bluerov2_heavy", "value: [13.7, 0, 33.0]", "value: [13.7, -1, 33.0]", "must not be negative"),
        ("bluerov2_heavy", "volume: {value: 0.0134", "volume: {value: 0", "greater than zero"),
        ("bluerov2_heavy", "sensors:\n", f"effects: {EFFECT}\nsensors:\n", "stands beside 'effects'"),
        ("bluerov2_heavy", "six_degrees:", "unknown:", "not a known key"),
        ("remus100", "number: {value: -1.93, unit: kg m,", "number: {value: -1.93, unit: kg,", "write it in kg m"),
        ("remus100", f"{PITCH}1.93", "force: yaw, motion: sway, number: {value: 1.93", "a second time"),
        ("remus100", QUADRATIC, LINEAR.replace("N s", "N s/m"), "write it in N s"),
        ("remus100", f"{PITCH}0.632", "force: sway, motion: sway, number: {value: 0.632", "on itself"),
        ("remus100", "value: 13.6, unit: deg", "value: 90, unit: deg", "less than 90 deg"),
    ],
)  # fmt: skip
def test_what_cannot_be_is_one_sentence(name: str, old: str, new: str, sentence: str, tmp_path: Path) -> None:
    """File, key, what was found and what to do."""
    text = (SHIPPED / f"{name}.yaml").read_text()
    assert old in text
    path = tmp_path / "wrong.yaml"
    path.write_text(text.replace(old, new, 1))
    with pytest.raises(CocorosimError, match=sentence) as caught:
        read_platform_file(path)
    assert "wrong.yaml" in str(caught.value)


def test_four_fins_are_the_most_without_six_degrees(tmp_path: Path) -> None:
    """A platform that neither rolls nor pitches may have an X of fins, and no fifth."""
    text = (SHIPPED / "remus100.yaml").read_text()
    level = text[: text.index("six_degrees:\n")] + text[text.index("actuators:\n") :]
    first, second = level.index("  - name: rudders"), level.index("  - name: stern_planes")
    more = "".join(level[first:second].replace("rudders", f"fin_{number}") for number in range(3))
    path = tmp_path / "wrong.yaml"
    path.write_text(level)
    assert read_platform_file(path).actuator_names == ("propeller", "rudders", "stern_planes")
    path.write_text(level[:first] + more + level[first:])
    with pytest.raises(CocorosimError, match=r"'actuators' has 5 fins; 4 are the most\. Fins that turn together"):
        read_platform_file(path)


def test_added_mass_that_no_body_has_is_refused(tmp_path: Path) -> None:
    """A coupling of 200 kg m leaves a mass matrix that is not positive definite."""
    text = (SHIPPED / "remus100.yaml").read_text()
    path = tmp_path / "wrong.yaml"
    path.write_text(text.replace("number: {value: -1.93", "number: {value: -200", 1))
    with pytest.raises(CocorosimError, match=r"wrong\.yaml: 'six_degrees' cannot be"):
        vehicle_of(read_platform_file(path))


def test_numbers_arrive() -> None:
    """The lower half of the REMUS' mass matrix: M_w_dot, and the weight below the origin, by hand."""
    matrix = vehicle_of(load_platform("remus100")).mass_matrix()
    assert matrix[4, 2] == matrix[2, 4] == 1.93
    assert matrix[0, 4] == pytest.approx(-30.479 * 0.0196, rel=1e-12)
    assert matrix[4, 4] == pytest.approx(3.45 + 4.88, abs=1e-4)


def test_linear_couplings_arrive_and_may_give_no_energy(tmp_path: Path) -> None:
    """-Y_r of 0.5 N s stands at sway by yaw; beside no diagonal it gives energy at some motion, which is refused."""
    text = (SHIPPED / "remus100.yaml").read_text().replace(QUADRATIC, LINEAR, 1)
    assert LINEAR in text
    path = tmp_path / "wrong.yaml"
    diagonals = ("linear_damping: {value: [0, 0, 0]", "linear_turn_damping: {value: [0, 0, 0]")
    path.write_text(text)
    with pytest.raises(CocorosimError, match=r"wrong\.yaml: 'six_degrees' cannot be: The linear damping gives energy"):
        vehicle_of(read_platform_file(path))
    assert all(each in text for each in diagonals)
    for each in diagonals:
        text = text.replace(each, each.replace("[0, 0, 0]", "[2, 2, 2]"), 1)
    path.write_text(text)
    expected = np.diag([2.0] * 6)
    expected[1, 5] = 0.5
    assert (vehicle_of(read_platform_file(path)).linear == expected).all()


def test_the_table_of_couplings_has_the_units_that_are_read() -> None:
    """Each row of config/README.md: of a speed and of a turn on a force, then on a moment."""
    text = (SHIPPED.parent / "README.md").read_text("utf-8").partition("| `matrix` |")[2].partition("\n\n")[0]
    rows = re.findall(r"^\| `(\w+)` \|[^|]*\|(.*)\|$", text, re.MULTILINE)
    units = {matrix: re.findall("`([^`]+)`", cells) for matrix, cells in rows}
    places = [(force, motion) for force in ("sway", "pitch") for motion in ("heave", "yaw")]
    assert units == {matrix: [unit_of(matrix, *place) for place in places] for matrix in COUPLED}
