"""Arithmetic in maps: values by hand, and a sentence for whatever is no arithmetic."""

from __future__ import annotations

import math
from collections.abc import Callable
from types import SimpleNamespace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from cocorosim_ros.foundation.arrays import Floats
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.reading.entry import Entry
from cocorosim_ros.wire.conversion.formula import parse

Convert = Callable[..., SimpleNamespace]
CELLS = {"a": [3.0, -4.0], "b": [2.0, 0.5], "angle": [30.0, 90.0], "motor.rpm[0]": [10.0, 20.0], "gap": [np.nan, 1.0]}


class Columns:
    """Two rows of known cells."""

    origin, count = "log.csv", 2

    def numbers(self, column: Entry) -> Floats:
        """The cells of a column."""
        if column.value not in CELLS:
            raise column.problem(f"has {column.found()}, no column of log.csv.")
        return np.array(CELLS[str(column.value)])

    def row_name(self, row: int) -> str:
        """Its line, after a header."""
        return f"line {row + 2}"


def value(text: str, **constants: float) -> list[float]:
    """The formula's value for both rows."""
    names = {"short": Entry("motor.rpm[0]", "map.yaml", 1, "names.short")}
    return parse(Entry(text, "map.yaml", 7, "x.formula"), names, constants).numbers(Columns()).tolist()


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("a**2", [9.0, 16.0]),
        ("a*abs(a)", [9.0, -16.0]),
        ("a - b/2 + 1", [3.0, -3.25]),
        ("-a % 2", [1.0, 0.0]),
        ("2e-3 * a", [0.006, -0.008]),
        ("hypot(a, 4)", [5.0, math.hypot(4, 4)]),
        ("motor.rpm[0] / 10", [1.0, 2.0]),
        ("short + 1", [11.0, 21.0]),
        ("where(a > 0, a, 0)", [3.0, 0.0]),
        ("where(a < 0, sqrt(-a), 7)", [7.0, 2.0]),
        ("where(a + 4 != 0, 1 / (a + 4), 5)", [1 / 7, 5.0]),
        ("max(a, b) + min(a, b)", [5.0, -3.5]),
        ("sign(a) * (b >= 2)", [1.0, 0.0]),
        ("pi", [math.pi, math.pi]),
    ],
)
def test_values_by_hand(text: str, expected: list[float]) -> None:
    """Each operation gives what paper gives."""
    assert value(text) == pytest.approx(expected, rel=1e-15)


def test_angles_are_in_radians() -> None:
    """The projection of a force by an azimuth angle in degrees."""
    assert value("cos(radians(angle)) * a") == pytest.approx([3 * math.sqrt(3) / 2, 0.0], abs=1e-15)
    assert value("degrees(atan2(1, 1))") == pytest.approx([45.0, 45.0])


def test_missing_cells_stay_missing_and_constants_count() -> None:
    """No number in, no number out, even where another branch would have one."""
    assert value("gap * 0 + lever", lever=0.3)[1] == 0.3
    assert math.isnan(value("gap * 0")[0])
    assert math.isnan(value("where(gap > 0, 1, 2)")[0])
    assert math.isnan(value("1 / gap")[0])


@given(
    st.floats(-1e3, 1e3, allow_subnormal=False),
    st.floats(-1e3, 1e3, allow_subnormal=False),
    st.sampled_from(["+", "-", "*"]),
)
def test_operators_are_those_of_python(left: float, right: float, sign: str) -> None:
    """Any two numbers: the same double as Python's own arithmetic."""
    by_python = {"+": left + right, "-": left - right, "*": left * right}[sign]
    assert value(f"left {sign} right", left=left, right=right) == [by_python, by_python]


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("a / (b - 2)", r"map.yaml line 7: 'x.formula' has 'a / \(b - 2\)', which in log.csv line 2 divides by zero"),
        ("a % (b - 2)", "divides by zero"),
        ("a / 0", r"line 2 and 1 more divides by '0', which is zero; correct the formula"),
        ("a % (2 - 2)", r"divides by '2 - 2', which is zero; correct the formula"),
        ("sqrt(a)", "has 'sqrt.a.', which in log.csv line 3 is no finite number"),
        ("log(0 * a)", "line 2 and 1 more is no finite number"),
        ("9**9**9**9", "is no finite number"),
        ("acos(b)", "line 2 is no finite number"),
        ("c + 1", "has 'c', no column of log.csv"),
        ("cosine(a)", "calls 'cosine', no function of formulas; did you mean 'sin'"),
        ("cos(a, b)", "cos takes 1 numbers"),
        ("cos(x=a)", "cos takes 1 numbers"),
        ("a.__class__()", "calls 'a.__class__', no function"),
        ("__import__('os').system('ls')", "no function of formulas"),
        ("(lambda: 1)()", "no function of formulas"),
        ("a if b else 1", "which a formula must not have; allowed: "),
        ("a ^ 2", "which a formula must not have"),
        ("[a, b]", "which a formula must not have"),
        ("'a' * 9", "which a formula must not have"),
        ("a and b", "which a formula must not have"),
        ("1 < a < 2", "which a formula must not have"),
        ("True + 1", "which a formula must not have"),
        ("a +", "which is no formula like"),
        ("a; b", "which is no formula like"),
        ("a" + " + a" * 400, "a formula has at most 1000"),
        ("-" * 90 + "a", "nested too deeply"),
        ("(" * 300 + "a" + ")" * 300, "no formula like|nested too deeply"),
    ],
)
def test_what_is_no_arithmetic(text: str, sentence: str) -> None:
    """The sentence names the place in the map, the piece, and where it matters the row."""
    with pytest.raises(CocorosimError, match=sentence) as caught:
        value(text)
    assert "\n" not in str(caught.value)


def table(streams: str, more: str = "") -> str:
    """One table of a map."""
    return f"  - {{files: a.csv, robot: boat, time: {{column: t, unit: s}}, {more}streams: {{{streams}}}}}\n"


def test_in_a_map(convert_csv: Convert) -> None:
    """Rotations squared, and a velocity levelled by the pitch, with units and short names."""
    streams = (
        'thruster_command: {main: {formula: "rpm*abs(rpm)", unit: "1", stop: 0, forward: 10000, reverse: -40000}}, '
        'velocity: {x: {formula: "u*cos(radians(p))", unit: cm/s}, z: {formula: "-u*sin(radians(p))", unit: cm/s}}'
    )
    log = "t,rpm,u,pitch angle\n1,50,200,60\n2,-100,100,0\n"
    topics = convert_csv(table(streams, "names: {p: pitch angle}, "), {"a.csv": log}).topics
    assert [message.content.command[0] for message in topics["/boat/thruster_command"]] == [0.25, -0.25]
    linear = topics["/boat/velocity"][0].content.twist.linear
    assert (linear.x, linear.z) == pytest.approx((1.0, -math.sqrt(3)))


@pytest.mark.parametrize(
    ("number", "sentence"),
    [
        ('{formula: "u/d", unit: m/s}', "streams.velocity.x.formula' has 'u/d', which in a.csv line 3 divides by zero"),
        ('{formula: "u**2"}', "lacks 'unit'; add one of 'm/s'"),
        ('{formula: "u**2", unit: N}', "has 'N', which is no unit of this number"),
        ('{formula: "u**2", column: u, unit: m/s}', "needs either 'column' or 'formula'"),
        ("{unit: m/s}", "needs either 'column' or 'formula'"),
        ('{formula: "v**2", unit: m/s}', "has 'v', no column of a.csv"),
        ("{formula: 2, unit: m/s}", "where text is needed"),
    ],
)  # fmt: skip
def test_wrong_formulas_in_a_map(convert_csv: Convert, number: str, sentence: str) -> None:
    """File, line, key and row are named."""
    with pytest.raises(CocorosimError, match=sentence):
        convert_csv(table(f"velocity: {{x: {number}}}"), {"a.csv": "t,u,d\n1,1,1\n2,1,0\n"})
