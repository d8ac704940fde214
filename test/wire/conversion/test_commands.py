"""Commands: angles and rates, numbers of single recordings, forces on the whole vehicle."""

from __future__ import annotations

import math
from collections.abc import Callable
from types import SimpleNamespace

import numpy as np
import pytest

from cocorosim_ros.foundation.errors import CocorosimError

Convert = Callable[..., SimpleNamespace]


def table(streams: str, files: str = "a.csv") -> str:
    """One table of a map."""
    return f"  - {{files: '{files}', robot: boat, time: {{column: t, unit: s}}, streams: {{{streams}}}}}\n"


def commands(result: SimpleNamespace) -> list[list[float]]:
    """The commands of all messages."""
    return [list(message.content.command) for message in result.topics["/boat/thruster_command"]]


@pytest.mark.parametrize(
    ("limits", "cell", "fraction"),
    [
        ("unit: deg, stop: 0 deg, forward: 35 deg, reverse: -35 deg", 7.0, 0.2),
        ("unit: rad, stop: 0 rad, forward: 90 deg, reverse: -90 deg", -math.pi / 4, -0.5),
        ("unit: rpm, stop: 0 rpm, forward: 1200 rpm", 300.0, 0.25),
        ("unit: rev/s, stop: 0 rpm, forward: 1200 rpm", 5.0, 0.25),
        ("unit: rad/s, stop: 0 rpm, forward: 60 rpm", 2 * math.pi, 1.0),
        ("unit: N m, stop: 0 N m, forward: 4 N m, reverse: -2 N m", -1.0, -0.5),
    ],
)
def test_angles_and_rates(convert_csv: Convert, limits: str, cell: float, fraction: float) -> None:
    """A rudder in degrees and a propeller in rpm or rev/s, as fractions of their limits."""
    streams = f"thruster_command: {{rudder: {{column: c, {limits}}}}}"
    result = convert_csv(table(streams), {"a.csv": f"t,c\n1,{cell!r}\n"})
    assert commands(result)[0] == pytest.approx([fraction], rel=1e-14)


def test_a_rudder_without_limits(convert_csv: Convert) -> None:
    """Degrees say nothing of the maximum."""
    with pytest.raises(CocorosimError, match="lacks 'stop' and 'forward'"):
        convert_csv(table("thruster_command: {rudder: {column: c, unit: deg}}"), {"a.csv": "t,c\n1,7\n"})


OFFSETS = 'compass: {heading: {column: h, unit: deg, offset: {"day1_*": 90 deg, day2_b: -10 deg}}}'


def test_offsets_of_recordings(convert_csv: Convert) -> None:
    """Each recording has the offset whose pattern fits its name first."""
    files = {name: "t,h\n1,0\n" for name in ("day1_a.csv", "day2_b.csv")}
    done = convert_csv(table(OFFSETS, "{run}.csv"), files).done
    found = {made.conversion.run: made.conversion.streams[0].rows.values[0, 0] for made in done}
    assert found == pytest.approx({"day1_a": math.pi / 2, "day2_b": math.radians(-10)})


def test_a_recording_without_its_offset(convert_csv: Convert) -> None:
    """No silent zero: the recording and the patterns are named."""
    sentence = "no number for the recording 'day3', only for 'day1_.*' or 'day2_b'; add 'day3'"
    with pytest.raises(CocorosimError, match=sentence):
        convert_csv(table(OFFSETS, "day3.csv"), {"day3.csv": "t,h\n1,0\n"}, "day3.csv")


def test_constants_of_recordings_in_formulas(convert_csv: Convert) -> None:
    """A constant of the map, in SI, another one for each recording; fixed numbers too."""
    tables = (
        "  - {files: '{run}.csv', robot: boat, time: {column: t, unit: s}, streams: {"
        'velocity: {x: {formula: "gain * u", unit: m/s}, y: {fixed: {one: 1 cm/s, "*": 2 cm/s}}}}}\n'
        "constants: {gain: {one: 50 %, two: 2}}\n"
    )
    done = convert_csv(tables, dict.fromkeys(("one.csv", "two.csv"), "t,u\n1,3\n")).done
    values = [made.conversion.streams[0].rows.values[0, :2].tolist() for made in done]
    assert values == [[1.5, 0.01], [6.0, 0.02]]


@pytest.mark.parametrize(
    ("constants", "sentence"),
    [
        ("{cos: 1}", "is no name of a constant"),
        ("{pi: 3}", "is no name of a constant"),
        ('{"a b": 3}', "is no name of a constant"),
        ("{lever: 3 bananas}", "whose unit is unknown"),
        ("{lever: {}}", "is empty; give a number"),
    ],
)
def test_wrong_constants(convert_csv: Convert, constants: str, sentence: str) -> None:
    """Each wrong constant is one sentence."""
    tables = table("velocity: {x: {column: u, unit: m/s}}") + f"constants: {constants}\n"
    with pytest.raises(CocorosimError, match=sentence):
        convert_csv(tables, {"a.csv": "t,u\n1,3\n"})


TWO = (
    "thrusters: {left: {force_x: 1, torque_z: -0.25 m, forward: 10 N, reverse: -10 N}, "
    "right: {force_x: 1, torque_z: 0.25 m, forward: 10 N, reverse: -5 N}}"
)
WRENCH = "wrench: {force_x: {column: X, unit: N}, torque_z: {column: N, unit: N m}}"


def test_forces_of_two_thrusters(convert_csv: Convert) -> None:
    """X = l + r, N = (r - l)/4 m: 4 N and 0.5 N m are 1 N and 3 N; a pure turn is -1 N and 1 N."""
    streams = f"thruster_command: {{allocation: {{{WRENCH}, {TWO}}}, pump: {{column: p, unit: '1'}}}}"
    result = convert_csv(table(streams), {"a.csv": "t,X,N,p\n1,4,0.5,0.5\n2,0,0.5,-1\n3,0,-0.5,0\n"})
    names = result.topics["/boat/thruster_command"][0].content.name
    assert list(names) == ["left", "right", "pump"]
    np.testing.assert_allclose(commands(result), [[0.1, 0.3, 0.5], [-0.1, 0.1, -1], [0.1, -0.2, 0]], atol=1e-14)


def test_forces_give_the_wrench_back(convert_csv: Convert) -> None:
    """Eight thrusters, six axes: the forces that come out make the wrench that went in, and no smaller ones do."""
    rng = np.random.default_rng(5)
    matrix = rng.uniform(-1, 1, (6, 8)).round(3)
    wrench = rng.uniform(-1, 1, (4, 6)).round(3)
    axes = [f"{kind}_{axis}" for kind in ("force", "torque") for axis in "xyz"]
    parts = ", ".join(
        f"t{column}: {{"
        + ", ".join(f"{axis}: {matrix[row, column]}{' m' if row > 2 else ''}" for row, axis in enumerate(axes))
        + ", forward: 100 N, reverse: -100 N}"
        for column in range(8)
    )
    given = ", ".join(f"{axis}: {{column: {axis}, unit: {'N' if row < 3 else 'N m'}}}" for row, axis in enumerate(axes))
    lines = "\n".join(f"{row}," + ",".join(map(str, cells)) for row, cells in enumerate(wrench))
    streams = f"thruster_command: {{allocation: {{wrench: {{{given}}}, thrusters: {{{parts}}}}}}}"
    forces = 100 * np.array(commands(convert_csv(table(streams), {"a.csv": f"t,{','.join(axes)}\n{lines}\n"})))
    np.testing.assert_allclose(forces @ matrix.T, wrench, atol=1e-12)
    null = np.linalg.svd(matrix)[2][6:]  # forces that make no wrench; the smallest solution has no part of them
    np.testing.assert_allclose(forces @ null.T, 0, atol=1e-12)


@pytest.mark.parametrize(
    ("old", "new", "sentence"),
    [
        ("torque_z: 0.25 m", "torque_z: -0.25 m", r"matrix of rank 1, and 2 axes are commanded \(force_x, torque_z\)"),
        ("left: {", "left: {force_y: 1, ", "left.force_y' is not a known key; did you mean 'force_x'"),
        ("forward: 10 N, reverse: -10 N", "reverse: -10 N", "lacks 'forward'"),
        ("torque_z: 0.25 m", "torque_z: 0.25 N", "is not a length"),
        ("force_x: {column: X, unit: N}, ", "", "left.force_x' is not a known key"),
        ("unit: N m}", "unit: N}", "has 'N', which is no unit of this number"),
        ("left: {", "'1': {", "is no name of an actuator"),
        (", pump", ", left", "is given by 'allocation' too"),
        (WRENCH, "wrench: {}", "names no axis; add one of force_x, "),
    ],
)  # fmt: skip
def test_wrong_allocations(convert_csv: Convert, old: str, new: str, sentence: str) -> None:
    """The rank and the axes are named, and so is every wrong key."""
    streams = f"thruster_command: {{allocation: {{{WRENCH}, {TWO}}}, pump: {{column: p, unit: '1'}}}}"
    assert old in streams
    with pytest.raises(CocorosimError, match=sentence):
        convert_csv(table(streams.replace(old, new, 1)), {"a.csv": "t,X,N,p\n1,4,0.5,0.5\n"})
