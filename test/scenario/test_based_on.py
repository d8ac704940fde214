"""Controllers that differ from another in a few parameters."""

from __future__ import annotations

from pathlib import Path

import pytest

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.parts.controller_file import load_controller

TEXT = """\
name: mine
behaviour: boids_blt
description: mine
based_on: boids_blt
parameters:
  alignment_weight: {value: 3, unit: "1", allowed: [0, 100], description: d, source: s}
"""


def test_parameters_are_merged_by_name(tmp_path: Path) -> None:
    """One parameter is the file's own, all others are the base's."""
    (tmp_path / "mine.yaml").write_text(TEXT)
    mine, base = load_controller(tmp_path / "mine.yaml").values, load_controller("boids_blt").values
    assert {name: mine[name] for name in mine if mine[name] != base[name]} == {"alignment_weight": 3.0}
    assert list(mine) == list(base)


def test_a_circle_is_refused(tmp_path: Path) -> None:
    """Two files based on each other get a sentence that names the controller."""
    for name, other in (("a", "b"), ("b", "a")):
        (tmp_path / f"{name}.yaml").write_text(TEXT.replace("based_on: boids_blt", f"based_on: ./{other}.yaml"))
    with pytest.raises(CocorosimError, match="based on this controller itself"):
        load_controller(tmp_path / "a.yaml")
