"""The maps that config/README.md shows convert the logs that stand below them."""

from __future__ import annotations

import math
import re
from pathlib import Path

import numpy as np
import pytest

from cocorosim_ros.wire.conversion.conversion import Conversion, convert
from cocorosim_ros.wire.conversion.formats import FORMATS
from cocorosim_ros.wire.conversion.formula import FUNCTIONS
from cocorosim_ros.wire.conversion.map_file import load_map

from .documents import ROOT, fenced

TEXT = (ROOT / "config" / "README.md").read_text("utf-8").split("## A map, key by key\n")[1].split("\n## ")[0]


def converted(example: int, file: str, folder: Path) -> Conversion:
    """What comes of an example's log, called so, by its map."""
    (folder / "map.yaml").write_text(fenced(TEXT, "yaml")[example], "utf-8")
    (folder / file).write_text(fenced(TEXT, "text")[example], "utf-8")
    return convert(load_map(folder / "map.yaml"), folder / file, folder / "bag")[0].conversion


@pytest.mark.parametrize(("run", "turn"), [("trial_12", 2.0), ("later", 0.0)])
def test_the_boat(run: str, turn: float, tmp_path: Path) -> None:
    """Levelled speed, a heading of each recording, rotations squared, a rudder in degrees."""
    made = converted(0, f"{run}.csv", tmp_path)
    streams = {stream.topic: stream.rows.values for stream in made.streams}
    np.testing.assert_allclose(streams["velocity"][:, 0], math.cos(math.radians(60 + turn)), rtol=1e-14)
    np.testing.assert_allclose(streams["compass"], math.pi / 2 if turn else 0.0)
    np.testing.assert_allclose(streams["thruster_command"], [[0.25, 0.2], [-1.0, -1.0]])
    assert made.findings == ()


def test_the_wrench(tmp_path: Path) -> None:
    """4 N and 0.5 N m are 1 N and 3 N; -0.5 N m alone 1 N and -1 N."""
    (stream,) = converted(1, "wrench.csv", tmp_path).streams
    np.testing.assert_allclose(stream.rows.values, [[0.1, 0.3], [0.1, -0.1]], atol=1e-15)


def test_the_sticks(tmp_path: Path) -> None:
    """20 of 40 N are half; -250 of a thousand to the right is a quarter to the left."""
    (stream,) = converted(2, "sticks.csv", tmp_path).streams
    assert stream.rows.extra["name"] == ["surge", "yaw"]
    np.testing.assert_allclose(stream.rows.values, [[0.5, 0.25], [-1.0, -1.0]], atol=1e-15)


def test_the_actuators_that_report(tmp_path: Path) -> None:
    """900 rpm are 30 pi rad/s; a current that a row lacks is no number beside what the row has."""
    commands, feedback = converted(3, "reported.csv", tmp_path).streams
    np.testing.assert_allclose(commands.rows.values, [[0.5, 0.0], [1.0, 1.0]])
    assert feedback.rows.extra["name"] == ["propeller.rotation", "propeller.current", "rudder.angle"]
    expected = [[20 * math.pi, 3.5, 0.0], [30 * math.pi, math.nan, math.radians(18)]]
    np.testing.assert_allclose(feedback.rows.values, expected, rtol=1e-14)


def test_the_pump(tmp_path: Path) -> None:
    """The neutral volume is 0, the largest 1, the smallest -1."""
    (line,) = re.findall(r"`(pump: \{.*?\})`", TEXT)
    head = "name: m\nformat: csv\ntables:\n  - {files: a.csv, time: {column: t, unit: s}, robot: glider, streams: "
    (tmp_path / "map.yaml").write_text(f"{head}{{thruster_command: {{{line}}}}}}}\n", "utf-8")
    (tmp_path / "a.csv").write_text("t,volume\n0,20000\n1,20500\n2,19500\n", "utf-8")
    (made,) = convert(load_map(tmp_path / "map.yaml"), tmp_path / "a.csv", tmp_path / "bag")
    np.testing.assert_allclose(made.conversion.streams[0].rows.values, [[0.0], [1.0], [-1.0]])


def test_everything_is_listed() -> None:
    """Every format, function and shipped map stands in the document."""
    for name in (*FORMATS, *(path.stem for path in (ROOT / "config" / "maps").glob("*.yaml"))):
        assert f"`{name}`" in TEXT, name
    listed = TEXT.split("functions abs")[1].split(";")[0]
    assert {"abs", *(word.strip() for word in listed.replace("\n", " ").split(",") if word.strip())} == set(FUNCTIONS)
