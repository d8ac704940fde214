"""What a platform with six_degrees is in surge, sway, heave and yaw: numbers, ranges, and what is said of the rest."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import pytest

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.parts.in_four_degrees import in_four_degrees
from cocorosim_ros.scenario.parts.platform import Platform, load_platform
from cocorosim_ros.scenario.reading.ranges import Range

SHIPPED = Path(__file__).parents[2] / "config/platforms"
RANGED = re.compile(r"(?m)^(  (?:volume|linear_damping|quadratic_damping): .*?)range: \[[^a-z]*\], ")
Make = Callable[..., Platform]
SLIDING = """\
  - name: battery
    kind: sliding_mass
    mass: {value: 2, unit: kg, source: made up}
    direction: {value: [1, 0, 0], unit: "1", source: made up}
    travel: {value: 0.05, unit: m, source: made up}

sensors:
"""


@pytest.fixture
def changed(tmp_path: Path) -> Make:
    """Function of (name, (old, new), ...): the platform of a changed file, in four degrees of freedom.

    What ranges stand below its six_degrees are taken out before.
    """

    def make(name: str, *changes: tuple[str, str]) -> Platform:
        text = RANGED.sub(r"\1", (SHIPPED / f"{name}.yaml").read_text("utf-8"))
        for old, new in changes:
            assert old in text
            text = text.replace(old, new, 1)
        path = tmp_path / "own.yaml"
        path.write_text(text, "utf-8")
        return in_four_degrees(load_platform(path))

    return make


def test_numbers_of_the_bluerov() -> None:
    """By hand from those of von Benzon et al. (2022)."""
    found = in_four_degrees(load_platform("bluerov2_heavy"))
    assert found.six_degrees is None
    assert (found.mass, found.yaw_inertia, found.drag, found.yaw_drag) == pytest.approx((19.86, 0.592, 141.0, 1.5))
    assert found.drag_form == "own_speed"
    assert {name: pytest.approx(numbers) for name, numbers in found.effects.items()} == {
        "added_mass": {"sway_minus_surge": 0.76, "heave_minus_surge": 12.32},
        "linear_drag": {"surge": 13.7, "sway": 0.0, "heave": 33.0},
        "anisotropic_drag": {"sway_ratio": 217.0 / 141.0, "heave_ratio": 190.0 / 141.0},
        "buoyancy_trim": {"force": -0.982},
    }


def test_ranges_go_over_to_what_is_made_of_them(changed: Make) -> None:
    """Of a sum those of both, of a ratio that of what is divided; a number that is the same at both ends has none."""
    found = changed(
        "bluerov2_heavy",
        ("mass: {value: 13.5, unit: kg,", "mass: {value: 13.5, unit: kg, range: [13.4, 13.7], ci95: [13.45, 13.55],"),
        ("value: [6.36, 7.12, 18.68],", "value: [6.36, 7.12, 18.68], range: [[4, 5, 18.68], [9, 10, 18.68]],"),
        ("value: [13.7, 0, 33.0],", "value: [13.7, 0, 33.0], range: [[0, 0, 33], [20, 30, 33]],"),
        ("value: [141, 217, 190],", "value: [141, 217, 190], range: [[141, 141, 95], [141, 282, 190]],"),
        ("value: 0.0134, unit: m^3,", "value: 0.0134, unit: m^3, range: [0.0133, 0.0136],"),
    )  # fmt: skip
    expected = {
        "mass": (17.4, 22.7, "kg"),
        "effects.added_mass.sway_minus_surge": (-1.36, 3.64, "kg"),
        "effects.linear_drag.surge": (0.0, 20.0, "N s/m"),
        "effects.linear_drag.sway": (0.0, 30.0, "N s/m"),
        "effects.anisotropic_drag.sway_ratio": (1.0, 2.0, "1"),
        "effects.anisotropic_drag.heave_ratio": (95.0 / 141.0, 190.0 / 141.0, "1"),
        "effects.buoyancy_trim.force": (-3.928, 1.964, "N"),
        "drag": (50.0, 300.0, "kg/m"),
        "yaw_drag": (0.3, 6.0, "N m s^2"),
    }
    assert found.ranges.keys() == expected.keys()
    for key, (low, high, unit) in expected.items():
        assert found.ranges[key].unit == unit
        assert (found.ranges[key].low, found.ranges[key].high) == pytest.approx((low, high), abs=1e-9)
    assert found.effects["linear_drag"]["sway"] == 0.0
    assert not found.intervals  # of added mass none is known, so none of the whole mass


def test_what_is_measured_stays_so(changed: Make) -> None:
    """An interval of a number that one other is made of is that one's."""
    old = "value: [1.19, 0.47, 1.5],"
    found = changed("bluerov2_heavy", (old, f"{old} ci95: [[1, 0.4, 1.4], [1.4, 0.6, 1.7]],"))
    assert found.intervals == {"yaw_drag": Range(1.4, 1.7, "N m s^2")}


def test_kept_numbers_are_kept_by_their_new_names(changed: Make) -> None:
    """One of a roll is gone."""
    found = changed(
        "bluerov2_heavy",
        ("value: [13.7, 0, 33.0],", "value: [13.7, 0, 33.0], range: [[0, 0, 0], [20, 30, 40]],"),
        ("value: [1.19, 0.47, 1.5],", "value: [1.19, 0.47, 1.5], range: [[0, 0.47, 1.5], [2, 0.47, 1.5]],"),
        (
            "six_degrees:",
            "kept_as_given: [yaw_drag, six_degrees.linear_damping.2, six_degrees.quadratic_turn_damping.0]\n"
            "six_degrees:",
        ),
    )
    assert found.kept_as_given == ("yaw_drag", "effects.linear_drag.heave")


def test_what_is_left_out_is_one_sentence(changed: Make) -> None:
    """Couplings without a number in four degrees, and numbers outside six_degrees that are other ones."""
    (sentence,) = changed(
        "remus100", ("drag: {value: 1.62,", "drag: {value: 2,"), ("drag_form: own_speed", "drag_form: strips")
    ).told
    assert "own.yaml: the vehicle is diagnosed in surge, sway, heave and yaw" in sentence
    assert sentence.endswith(
        "left out is what makes it roll and pitch, and the 'quadratic_damping' of yaw on sway, the 'quadratic_damping' "
        "of sway on yaw, 'drag' of 2 kg/m (it gives 1.62 kg/m) and 'drag_form: strips' (in it drag goes by each axis' "
        "own speed)."
    )


def test_a_range_of_another_number_is_left_out_with_it(changed: Make) -> None:
    """What stands below six_degrees holds."""
    found = changed("bluerov2_heavy", ("drag: {value: 141,", "drag: {value: 100,"))
    assert found.drag == 141.0
    assert set(found.ranges) == {"yaw_drag"}


def test_robots_of_their_own(changed: Make) -> None:
    """One that is heavier sinks faster, and weighs more."""
    heavy = "robots: {rov_02: {mass: {value: 14, unit: kg, source: made up}}}\nsix_degrees:"
    found = changed("bluerov2_heavy", ("six_degrees:", heavy))
    other = found.of_robot("rov_02")
    assert (found.mass, other.mass) == pytest.approx((19.86, 20.36))
    assert other.six_degrees is None
    assert other.effects["buoyancy_trim"]["force"] == pytest.approx(-0.6 * 9.82)


def test_others_stay_as_they_are() -> None:
    """Nothing is changed of, or said about, one that moves in four degrees anyway."""
    platform = load_platform("tauv_pool")
    assert in_four_degrees(platform) == platform
    assert not in_four_degrees(platform).told


def test_drag_without_any_ahead_is_said(changed: Make) -> None:
    """No ratio to it says what there is across."""
    found = changed("bluerov2_heavy", ("value: [141, 217, 190]", "value: [0, 217, 190]"))
    assert "anisotropic_drag" not in found.effects
    assert "quadratic drag across and upwards" in found.told[0]


@pytest.mark.parametrize(
    ("old", "new", "sentence"),
    [
        ("sensors:\n", SLIDING, r"own\.yaml: a diagnosis knows .*'battery' is a sliding mass, .*take a copy"),
        (
            "  - name: rudders",
            None,
            r"own\.yaml: a diagnosis knows .*4 fins are the most there, where 'actuators' has 5",
        ),
    ],
)
def test_actuators_without_a_part_are_refused(changed: Make, old: str, new: str | None, sentence: str) -> None:
    """A mass that slides, and a fifth fin."""
    if new is None:
        text = (SHIPPED / "remus100.yaml").read_text("utf-8")
        rudders = text[text.index(old) : text.index("  - name: stern_planes")]
        new = "".join(rudders.replace("rudders", f"fin_{number}") for number in range(3)) + old
    with pytest.raises(CocorosimError, match=sentence):
        changed("remus100", (old, new))
