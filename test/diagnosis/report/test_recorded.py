"""Pages and terminal leave out what recordings do not show; diagnosis.json keeps what the contract names."""

from __future__ import annotations

import io
import re
from collections.abc import Callable
from dataclasses import replace

import pytest
from rich.console import Console

from cocorosim_ros.diagnosis.findings import (
    Comparison,
    Diagnosis,
    Estimate,
    FoundEffect,
    PassedOver,
    Recalibrated,
    ScreenedEffect,
    Unrecorded,
)
from cocorosim_ros.diagnosis.report.json_file import diagnosis_json
from cocorosim_ros.diagnosis.report.model_file import Origin
from cocorosim_ros.diagnosis.report.recorded import as_recorded
from cocorosim_ros.diagnosis.report.report import render_report
from cocorosim_ros.diagnosis.report.terminal_table import terminal_tables
from cocorosim_ros.scenario.parts.platform import load_platform

Example = Callable[[str], Diagnosis]
ONE = Estimate(1.0, 0.9, 1.1, "1")
ORIGIN = Origin(load_platform("hovercraft_epfl"), ("floor",), ("lily_01",), 600.0)


def of_a_hovercraft(found: Diagnosis) -> Diagnosis:
    """A diagnosis whose map fixed the height: it has errors of depth, numbers and noise of motion upwards."""
    effect = replace(found.effects[0], parameters={**found.effects[0].parameters, "heave_minus_surge": ONE})
    gain = Recalibrated("buoyancy_gain", 1.0, ONE, ("lily_01",))
    drag = Recalibrated("linear_drag.heave", 1.0, ONE, ("lily_01",))
    noise = {"reading.pose_z": ONE, "reading.pose_xy": ONE, "random.heave_force": ONE, "random.force": ONE}
    size = {"surge": 1.0, "heave": 2.0}
    return replace(
        found,
        effects=(effect,),
        recalibrated=(gain,),
        all_recalibrated=(*found.all_recalibrated, gain, drag),
        noise=noise,
        screened=(
            ScreenedEffect("stratification", 1.0, {"force": 1.0}), ScreenedEffect("pump_lag", 0.0, {}),
            ScreenedEffect("linear_drag", 1.0, size),
        ),
        screened_laws=(ScreenedEffect("unknown:heave~v", 60.0, {}), ScreenedEffect("unknown:sway~r", 50.0, {})),
        not_shown=("stratification", "pump_lag", "linear_drag"),
    )  # fmt: skip


def told(found: Diagnosis) -> tuple[str, str]:
    """The words of the page, pictures and all, and of the terminal."""
    stream = io.StringIO()
    Console(file=stream, width=300).print(terminal_tables(found))
    return re.sub(r"<style.*?</style>", "", render_report(found, ORIGIN), flags=re.DOTALL), stream.getvalue()


ABSENT = ("buoyancy", "heave", "stratification", "pump lag", "random force, vertical", "a reading of pose, z")


def test_a_fixed_height_is_no_reading(example: Example) -> None:
    """No row, list or picture is about depth or motion upwards where the height never varies; else all are there."""
    found = of_a_hovercraft(example("mismatch"))
    fixed = replace(found, unrecorded=Unrecorded(("pose_z",), depth=True))
    page, terminal = told(fixed)
    for words in (*ABSENT, "error of depth", "<th>depth</th>", "height z"):
        assert words not in page, words
    assert "depth" not in terminal and "heave" not in terminal and "buoyancy" not in terminal
    for words in (
        "<th>heading</th>",
        "random force, horizontal",
        "a reading of pose, x and y",
        "linear drag: from about",
    ):
        assert words in page, words
    page, terminal = told(found)
    for words in (*ABSENT[:3], *ABSENT[4:], "error of depth", "<th>depth</th>"):
        assert words in page, words
    assert "buoyancy_gain" in terminal and "heave_minus_surge" in terminal


def test_the_file_keeps_what_the_contract_names(example: Example) -> None:
    """All that is left out of the page stands in diagnosis.json."""
    found = of_a_hovercraft(example("mismatch"))
    assert diagnosis_json(replace(found, unrecorded=Unrecorded(("pose_z",), depth=True))) == diagnosis_json(found)
    assert "heave_minus_surge" in diagnosis_json(found) and "depth" in diagnosis_json(found)


@pytest.mark.parametrize(
    ("platform", "lacking"),
    [
        ("lily", {"wash_loss"}),  # no propeller of these has a diameter
        # Two fans that push one way, over air.
        ("hovercraft_epfl", {"pump_lag", "reverse_loss", "crashback_loss", "wash_loss", "surface_waves"}),
        ("kvlcc2_hsva", {"pump_lag", "thruster_asymmetry", "wash_loss"}),  # one propeller
        ("slocum_glider", {"reverse_loss", "crashback_loss", "thruster_asymmetry", "wash_loss"}),  # a pump alone
    ],
)
def test_effects_of_actuators_that_are_not_there_are_not_mentioned(
    example: Example, platform: str, lacking: set[str]
) -> None:
    """Neither among what is out of sight nor among what was screened."""
    names = (
        "pump_lag",
        "reverse_loss",
        "crashback_loss",
        "thruster_asymmetry",
        "wash_loss",
        "linear_drag",
        "surface_waves",
    )
    screened = tuple(ScreenedEffect(name, 1.0, {}) for name in names)
    shown = as_recorded(replace(example("mismatch"), not_shown=names, screened=screened), load_platform(platform))
    assert set(names) - set(shown.not_shown) == set(names) - {each.id for each in shown.screened} == lacking


SEEN = {
    "pump_lag": {"time_constant": 1.0},
    "hull_compressibility": {},
    "imu_bias": {"gyro_z": 0.01, "accel_z": 0.2},
    "linear_drag": {"surge": 0.1, "heave": 0.2},
    "sheared_current": {"x": 0.1, "dx_dz": 0.2},
    "thruster_lag": {"time_constant": 0.1},
}
UNSEEN = (
    "pump_lag",
    "hull_compressibility",
    "imu_bias:accel_z",
    "added_mass:heave_minus_surge",
    "linear_drag",
    "sheared_current:dx_dz",
)


def test_a_comparison_tells_sizes_of_what_is_recorded_alone(example: Example) -> None:
    """Neither a pump that is not there, nor accelerations without a number, nor depth; all of them in the file."""
    against = Comparison(("good",), (), (), seen_from=SEEN)
    gone = Unrecorded(("pose_z",), ("accel_x", "accel_y", "accel_z"), depth=True)
    found = replace(example("consistent"), against=against, unrecorded=gone, not_shown=UNSEEN, screened=())
    shown = as_recorded(found, ORIGIN.platform)
    assert shown.not_shown == ("linear_drag",)
    assert shown.against is not None
    assert shown.against.seen_from == {
        "imu_bias": {"gyro_z": 0.01},
        "linear_drag": {"surge": 0.1},
        "sheared_current": {"x": 0.1},
        "thruster_lag": {"time_constant": 0.1},
    }
    page, _ = told(found)
    for words in ("pump lag", "compressib", "accel", "heave", "dx dz"):
        assert words not in page, words
    assert "accel_z" in diagnosis_json(found) and "pump_lag" in diagnosis_json(found)


DRAG = {"surge": (0.02, 0.04), "sway": (-0.01, 0.1), "heave": (0.01, 0.07), "yaw": (-1e-4, 1e-4)}


@pytest.mark.parametrize(
    ("ahead", "equation"), [((0.02, 0.04), "X = -d_u u"), ((-0.02, 0.04), "X = -d_u u, Y = -d_v v, N = -d_r r")]
)
def test_an_equation_has_the_parts_of_shown_numbers(
    example: Example, ahead: tuple[float, float], equation: str
) -> None:
    """Linear drag of a hovercraft: none upwards, as in its table; also where nothing but that one is clear."""
    ends = DRAG | {"surge": ahead}
    numbers = {name: Estimate((low + high) / 2, low, high, "N s/m") for name, (low, high) in ends.items()}
    drag = FoundEffect("linear_drag", "linear drag", "X = -d_u u, Z = -d_w w", ("h",), "suspected", numbers, 40.0)
    passed = PassedOver(drag, stands=False, because=(), shortly="")
    found = replace(example("mismatch"), effects=(drag,), passed_over=(passed,), unrecorded=Unrecorded(depth=True))
    shown = as_recorded(found)
    assert shown.effects[0].equation == shown.passed_over[0].found.equation == equation
    assert set(shown.effects[0].parameters) == {"surge", "sway", "yaw"}
    assert as_recorded(replace(found, unrecorded=Unrecorded())).effects[0].equation == drag.equation


def test_what_is_recorded_is_shown_as_it_is(example: Example) -> None:
    """Nothing is left out where nothing is missing; of readings that never vary only their own noise is."""
    found = of_a_hovercraft(example("mismatch"))
    assert as_recorded(found) == found
    one = as_recorded(replace(found, unrecorded=Unrecorded(("pose_z",))))
    assert set(found.noise) - set(one.noise) == {"reading.pose_z"} and one.fit == found.fit
