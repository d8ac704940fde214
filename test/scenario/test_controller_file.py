"""Controller files: the boids numbers, overrides, and the sentences about wrong ones."""

from __future__ import annotations

from pathlib import Path

import pytest

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.parts.controller_file import controller_tree, load_controller, read_controller
from cocorosim_ros.scenario.reading.yaml_file import parse_yaml, yaml_text

FILE = """\
name: c
behaviour: boids_blt
description: a test
parameters:
  gain: {value: 3, unit: "1", allowed: [0, 20], description: turn gain, source: hand}
  reach: {value: 15, unit: cm, allowed: [0, 50], description: a length, source: hand}
  backwards: {value: true, description: a switch, source: hand}
"""


def complaint(tmp_path: Path, old: str, new: str) -> str:
    """The sentence about the file with one piece replaced."""
    assert old in FILE
    path = tmp_path / "c.yaml"
    path.write_text(FILE.replace(old, new))
    with pytest.raises(CocorosimError) as caught:
        load_controller(path)
    return str(caught.value)


def test_boids_have_the_numbers_of_the_paper() -> None:
    """Weights 1, 1, 10; separation below 0.15 m; at most a tenth of the thrust; vision all around."""
    values = load_controller("boids_blt").values
    names = ("cohesion_weight", "separation_weight", "alignment_weight", "separation_threshold", "speed_cap")
    assert [values[name] for name in names] == [1, 1, 10, 0.15, 0.10]
    assert values["observe_backwards"] is True
    assert values["neighbour_trust"] == pytest.approx(0.95 * 0.5)


def test_parameters_are_in_si(tmp_path: Path) -> None:
    """Value and range are converted with the same unit; a switch is 0 to 1."""
    (tmp_path / "c.yaml").write_text(FILE)
    reach = load_controller(tmp_path / "c.yaml").parameters["reach"]
    assert (reach.value, reach.unit, reach.minimum, reach.maximum) == (0.15, "m", 0.0, 0.5)
    switch = load_controller(tmp_path / "c.yaml").parameters["backwards"]
    assert (switch.value, switch.unit, switch.minimum, switch.maximum) == (True, "", 0.0, 1.0)


def test_idle_has_no_parameters() -> None:
    """Nothing to set, nothing in the way."""
    assert load_controller("idle").parameters == {}


def test_controller_reads_back() -> None:
    """Writing a controller out and reading it again changes nothing."""
    for name in ("boids_blt", "idle", "constant"):
        controller = load_controller(name)
        assert read_controller(parse_yaml(yaml_text(controller_tree(controller)), "t")) == controller


@pytest.mark.parametrize(
    ("old", "new", "sentence"),
    [
        (
            "value: 3,",
            "value: 30,",
            "c.yaml line 5: 'parameters.gain.value' has 30, outside what is allowed; choose from 0 to 20.",
        ),
        ("value: 15,", "value: 60,", "has 0.6 m, outside what is allowed; choose from 0 to 0.5 m."),
        ("unit: cm", "unit: parsec", "'parameters.reach' has '15 parsec', whose unit is unknown"),
        ("allowed: [0, 50], ", "", "'parameters.reach' lacks 'allowed'; add it."),
        ("allowed: [0, 50]", "allowed: [0]", "'parameters.reach.allowed' has [0]; write 2 values"),
        ("description: a switch, ", "", "'parameters.backwards' lacks 'description'; add it."),
        ("behaviour:", "behavior:", "'behavior' is not a known key; did you mean 'behaviour'?"),
        (
            "{value: true, description: a switch, source: hand}",
            "5",
            "'parameters.backwards' has '5' without a source",
        ),
    ],
)
def test_wrong_files(tmp_path: Path, old: str, new: str, sentence: str) -> None:
    """Each mistake is one sentence with line and key."""
    assert sentence in complaint(tmp_path, old, new)


def test_overrides() -> None:
    """Numbers are SI, text carries its unit, switches are truth values; the original stays as it was."""
    controller = load_controller("boids_blt")
    changed = controller.with_overrides(
        {"alignment_weight": 5, "separation_threshold": "20 cm", "dive_gain": 0.2, "observe_backwards": False}
    )
    names = ("alignment_weight", "separation_threshold", "dive_gain", "observe_backwards")
    assert [changed.values[name] for name in names] == [5, 0.2, 0.2, False]
    assert controller.values["alignment_weight"] == 10


@pytest.mark.parametrize(
    ("name", "value", "sentence"),
    [
        (
            "alignement_weight",
            1,
            "is no parameter of controller 'boids_blt'; did you mean 'alignment_weight'?",
        ),
        ("alignment_weight", -1, "'alignment_weight' has -1, outside what is allowed; choose from 0 to 100."),
        ("alignment_weight", float("nan"), "is not a finite number"),
        ("separation_threshold", "2 s", "has '2 s', which is not a length"),
        ("observe_backwards", 1, "has '1'; write true or false."),
        ("alignment_weight", True, "has 'true', which is not a pure number"),
    ],
)
def test_wrong_overrides(name: str, value: float | bool | str, sentence: str) -> None:
    """Each wrong override names the controller and the parameter."""
    with pytest.raises(CocorosimError) as caught:
        load_controller("boids_blt").with_overrides({name: value})
    assert sentence in str(caught.value)
    assert str(caught.value).startswith("override of controller 'boids_blt'")
