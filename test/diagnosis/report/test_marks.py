"""Marks beside numbers that stand at a limit, whose interval leaves one, or that are of another regime."""

from __future__ import annotations

import io
import math
from collections.abc import Callable
from dataclasses import replace

import pytest
from rich.console import Console

from cocorosim_ros.diagnosis.findings import Diagnosis, Estimate
from cocorosim_ros.diagnosis.fitting.unknowns import PLATFORM, Owner, Unknown
from cocorosim_ros.diagnosis.report.json_file import diagnosis_tree
from cocorosim_ros.diagnosis.report.marks import limit_words, marked_words, unlike_words
from cocorosim_ros.diagnosis.report.model_file import Origin
from cocorosim_ros.diagnosis.report.report import render_report
from cocorosim_ros.diagnosis.report.sentence import detail_lines
from cocorosim_ros.diagnosis.report.terminal_table import terminal_tables
from cocorosim_ros.diagnosis.showing.estimates import Fitted
from cocorosim_ros.scenario.parts.platform import load_platform

Example = Callable[[str], Diagnosis]
AT_END = Estimate(2.0, 1.8, 2.2, "kg/m", limits=(1.5, 2.0), at_limit=True)
BEYOND = Estimate(0.4, 0.1, 1.03, "1", limits=(0.2, 1.0))
INSIDE = replace(BEYOND, low=0.3, high=0.5)


def plain(text: str) -> str:
    """With usual spaces."""
    return text.replace("\u00a0", " ")


def test_a_number_is_marked_by_where_it_stands() -> None:
    """At an end, beyond an end, or not at all; one end alone is said as such, and no limits are no mark."""
    assert plain(limit_words(AT_END)) == "at an end of its limits, 1.5 kg/m to 2 kg/m"
    assert plain(limit_words(BEYOND)) == "its interval leaves its limits, 0.2 to 1"
    assert limit_words(INSIDE) == limit_words(Estimate(1.0, 0.0, 9.0, "1")) == ""
    assert limit_words(replace(BEYOND, limits=(0.2, math.inf))).endswith("limits, from 0.2 on")
    assert limit_words(replace(BEYOND, limits=(-math.inf, 1.0))).endswith("limits, up to 1")
    assert limit_words(replace(BEYOND, low=0.3, limits=(-math.inf, 1.1))) == ""
    value, interval = marked_words(AT_END)
    assert plain(value) == "2.00 kg/m" and plain(interval).startswith("1.80 to 2.20 kg/m; at an end")


def test_limits_are_those_of_the_fit() -> None:
    """A platform's range in its own unit, both ends; of an effect only the ends at which it is not absent."""
    owner = Owner(PLATFORM, ("lily_01",), "drag", "kg/m")
    bounds = (math.log(1.5 / 1.8), math.log(2.0 / 1.8))
    drag = Unknown(owner, "drag", (0,), base=1.8, logarithmic=True, bounds=bounds)
    at_end, inside = Fitted(drag, bounds[1], 0.02).estimate, Fitted(drag, 0.0, 0.01).estimate
    assert at_end.limits == pytest.approx((1.5, 2.0)) and at_end.at_limit and not inside.at_limit
    assert "its interval leaves" in limit_words(Fitted(drag, 0.0, 0.1).estimate)  # 1.48 to 2.19
    loss = Unknown(
        Owner("reverse_loss", ("lily_01",), "loss", "1"), "reverse_loss.loss", (0,), 0.0, 0.3, bounds=(0.0, 10 / 3)
    )
    low = Fitted(loss, 0.1, 0.2).estimate  # -0.09 to 0.15, which is told as holding zero
    assert low.limits == pytest.approx((-math.inf, 1.0)) and limit_words(low) == ""
    assert "at an end" in limit_words(Fitted(loss, 10 / 3, 0.1).estimate)
    declared = replace(loss, owner=Owner(PLATFORM, ("lily_01",), "reverse_loss.loss", "1"))
    assert "at an end of its limits, 0 to 1" in limit_words(Fitted(declared, 0.0, 0.2).estimate)


def doubtful(found: Diagnosis) -> Diagnosis:
    """A diagnosis with a number of the platform at its end, an effect's interval beyond, and runs in other regimes."""
    drag, inertia = found.all_recalibrated
    effect = replace(found.effects[0], parameters={"sway_minus_surge": BEYOND, "yaw": INSIDE})
    drag = replace(drag, estimate=AT_END)
    return replace(
        found, recalibrated=(drag,), all_recalibrated=(drag, inertia), effects=(effect,), unlike=("speed", "thrust")
    )


def rows(text: str, name: str) -> list[str]:
    """Rows of the tables of a page that begin with a name."""
    return [row for row in plain(text).split("<tr>") if row.startswith(f"<th>{name}</th>")]


def test_marks_stand_in_the_rows_of_the_page(example: Example) -> None:
    """Beside the number at its end, the interval beyond and every error of free runs; beside no other number."""
    origin = Origin(load_platform("lily"), ("bags/tank_7",), ("lily_01",), 600.0)
    text = render_report(doubtful(example("mismatch")), origin)
    (drag,), (inertia,) = rows(text, "drag"), rows(text, "inertia")
    assert "at an end of its limits, 1.5 kg/m to 2 kg/m" in drag and "limits" not in inertia
    (beyond,), (*_, inside) = rows(text, "sway minus surge"), rows(text, "yaw")  # the first of yaw is what is located
    assert "its interval leaves its limits, 0.2 to 1" in beyond and "limits" not in inside
    for channel in ("position, horizontal", "heading", "depth"):
        assert "unlike the fitted parts in speed and thrust" in rows(text, channel)[0]
    assert "did not see (unlike the fitted parts in speed and thrust)" in text
    plain_page = render_report(example("mismatch"), origin)
    assert "its limits" not in plain_page and "unlike the fitted" not in plain_page


def test_marks_stand_in_the_rows_of_the_terminal(example: Example) -> None:
    """The same on the terminal, and in the lines below the headline."""
    found = doubtful(example("mismatch"))
    stream = io.StringIO()
    Console(file=stream, width=300).print(terminal_tables(found))
    lines = plain(stream.getvalue()).splitlines()
    (drag,) = (line for line in lines if "\u2502 drag " in line)
    (sway,) = (line for line in lines if "sway_minus_surge" in line)
    (depth,) = (line for line in lines if "\u2502 depth " in line)
    assert "at an end of its limits" in drag and "its interval leaves its limits" in sway
    assert "unlike the fitted parts in speed and thrust" in depth
    told = [plain(line) for line in detail_lines(found)]
    assert any("sway minus surge 0.40 (its interval leaves its limits, 0.2 to 1)" in line for line in told)
    assert any(line.endswith("unlike the fitted parts in speed and thrust") for line in told)


def test_marked_numbers_have_their_limits_in_the_file(example: Example) -> None:
    """Those that are not marked have the keys of the contract alone."""
    tree = diagnosis_tree(doubtful(example("mismatch")))
    assert tree["recalibrated"][0]["limits"] == [1.5, 2.0]
    numbers = tree["effects"][0]["parameters"]
    assert numbers["sway_minus_surge"]["limits"] == [0.2, 1.0]
    assert set(numbers["yaw"]) == {"value", "ci95", "unit"}


def test_regimes_are_listed() -> None:
    """One, two, three or no quantity."""
    assert unlike_words(()) == ""
    assert unlike_words(("depth",)) == "unlike the fitted parts in depth"
    assert unlike_words(("speed", "turn rate", "depth")) == "unlike the fitted parts in speed, turn rate and depth"
