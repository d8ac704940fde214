"""The tables of a diagnosis in the terminal."""

from __future__ import annotations

import io
from collections.abc import Callable
from dataclasses import replace

from rich.console import Console

from cocorosim_ros.diagnosis.findings import ActuatorReport, Diagnosis, Estimate, HeldOut, PassedOver
from cocorosim_ros.diagnosis.report.model_file import Origin
from cocorosim_ros.diagnosis.report.report import render_report
from cocorosim_ros.diagnosis.report.terminal_table import terminal_tables
from cocorosim_ros.scenario.parts.platform import load_platform

Example = Callable[[str], Diagnosis]


def shown(diagnosis: Diagnosis) -> str:
    """The tables on a wide terminal."""
    stream = io.StringIO()
    Console(file=stream, width=200).print(terminal_tables(diagnosis))
    return stream.getvalue().replace("\u00a0", " ")


def test_a_mismatch_shows_effects_numbers_and_errors(example: Example) -> None:
    """Effect with interval and rival, moved parameter, held-out errors."""
    text = shown(example("mismatch"))
    row = next(line for line in text.splitlines() if "sway_minus_surge" in line)
    assert [cell.strip() for cell in row.strip("\u2502").split("\u2502")] == [
        "added_mass, confirmed", "lily_01", "sway_minus_surge", "44.3 g", "43.1 to 45.5 g", "563",
        "anisotropic_drag (\u22122.1)",
    ]  # fmt: skip
    assert "1.853 kg/m" in text
    assert "11.1 mm" in text and "readings" in text


def test_what_has_no_name_has_a_table_of_its_own(example: Example) -> None:
    """With interval and nats; there is no table of effects."""
    text = shown(example("nameless"))
    assert "explains something, but is not named" in text and "what is missing" not in text
    row = next(line for line in text.splitlines() if "gyro_scale of imu" in line)
    assert "0.97" in row and "1.07" in row and "52.3" in row


def test_a_size_that_may_be_nothing_is_said_beside_the_name(example: Example) -> None:
    """On the page and in the terminal; not where a number is clear."""
    (munk,) = example("mismatch").effects
    numbers = {name: replace(each, low=-1.0, high=1.0) for name, each in munk.parameters.items()}
    doubtful = replace(example("mismatch"), effects=(replace(munk, parameters=numbers, tier="suspected"),))
    assert "added_mass, suspected; its size may as well be nothing" in shown(doubtful)
    assert "may as well be nothing" not in shown(example("mismatch"))
    origin = Origin(load_platform("lily"), ("bags/tank_7",), ("lily_01",), 600.0)
    name = '<span class="quiet">added_mass</span><br><span class="mark">its size may as well be nothing</span></h3>'
    assert name in render_report(doubtful, origin) and name not in render_report(example("mismatch"), origin)


def test_each_number_that_may_be_nothing_is_marked_beside_others(example: Example) -> None:
    """In the tables of what is named and of what is not, on the page and in the terminal."""
    (munk,) = example("mismatch").effects
    numbers = munk.parameters | {"yaw": Estimate(1e-5, -2e-5, 4e-5, "kg m^2")}
    found = replace(munk, parameters=numbers)
    passed = PassedOver(found, stands=True, because=("Free runs gain nothing.",), shortly="free runs gain nothing")
    named = replace(example("mismatch"), effects=(found,))
    nameless = replace(example("mismatch"), effects=(), passed_over=(passed,))
    origin = Origin(load_platform("lily"), ("bags/tank_7",), ("lily_01",), 600.0)
    for diagnosis, words in ((named, "May as well be nothing, as"), (nameless, "; may as well be nothing: yaw (")):
        rows = [line for line in shown(diagnosis).splitlines() if "may as well be nothing" in line]
        assert len(rows) == 1 and "yaw" in rows[0]
        assert words in render_report(diagnosis, origin)


def test_a_force_without_a_name_is_no_bound_where_a_model_errs_less(example: Example) -> None:
    """Said of a channel that a model foretells better by more than its interval; of no other, nor of a stream."""
    sure = {"recalibrated": (0.06, 0.08), "augmented": (0.02, 0.03)}
    for floor, said in ((0.031, True), (0.029, False)):
        row = HeldOut(0.1, 0.07, 0.025, floor, "m", sure)
        table = {"position": row, "heading": replace(row, unit="rad"), "compass": replace(row, noise_floor=0.5)}
        found = replace(example("mismatch"), fit=table)
        origin = Origin(load_platform("lily"), ("bags/tank_7",), ("lily_01",), 600.0)
        page, lines = render_report(found, origin), shown(found).splitlines()
        assert ("In position and heading a model without such a force errs less" in page) is said
        assert page.count('<span class="mark">no bound</span>') == 2 * said
        assert [line.split()[1] for line in lines if "no bound" in line] == ["position", "heading"] * said
        assert "little can be better" not in page and "floor" not in page + "".join(lines)


def test_probabilities_are_one_line(example: Example) -> None:
    """Whole percents of the sets of suspects; silence is said in words."""
    lines = [line for line in shown(example("mismatch")).splitlines() if line.startswith("probability: ")]
    assert len(lines) == 1 and "% added mass" in lines[0] and "% anisotropic drag" in lines[0]
    silent = next(line for line in shown(example("consistent")).splitlines() if line.startswith("probability: "))
    assert silent.split(", ")[1].endswith("% that nothing is missing")
    assert "probability: " not in shown(example("insufficient"))


def test_empty_tables_are_left_out(example: Example) -> None:
    """A recording that cannot tell shows what to record, and no table."""
    text = shown(example("insufficient"))
    assert "next: Drive at three speeds" in text
    assert "\u2502" not in text


def test_what_actuators_report_is_a_table(example: Example) -> None:
    """A row for each number, with intervals; the reason where nothing is told; what was before where it is known."""
    late = {"lateness": Estimate(0.66, 0.64, 0.69, "s"), "gain": Estimate(0.9, 0.88, 0.92, "1")}
    reports = (
        ActuatorReport("boat", "rudder", "angle", late, before={"lateness": Estimate(0.3, 0.28, 0.32, "s")}),
        ActuatorReport("boat", "propeller", "rotation", because="its command hardly changes"),
    )
    rows = [
        [cell.strip() for cell in line.strip("\u2502").split("\u2502")]
        for line in shown(replace(example("consistent"), actuators=reports)).splitlines()
        if "rudder" in line or "propeller" in line
    ]
    assert rows[0][:3] == ["rudder", "angle", "660 ms (640 to 690 ms)"] and rows[0][5] == "0.900 (0.880 to 0.920)"
    assert rows[0][-1] == "300 ms (280 to 320 ms)"
    assert rows[1][:3] == ["propeller", "rotation", "not told: its command hardly changes"]
    assert "report" not in shown(example("consistent"))


def test_the_gain_of_a_motor_is_in_rpm(example: Example) -> None:
    """What it turns at full command: 100 rad/s are 955 rpm."""
    motor = ActuatorReport("boat", "left", "rotation", {"gain": Estimate(100.0, 90.0, 110.0, "rad/s")})
    assert "955 rpm (859 to 1\u202f050 rpm)" in shown(replace(example("consistent"), actuators=(motor,)))
