"""A controller that cannot work is found when the scenario is loaded, before any recording begins."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.world.checks.loading import load_scenario

CONFIG = Path(__file__).parents[2] / "config"


def scenario_with(folder: Path, *, controller: str = "", platform: str = "") -> Path:
    """The scenario one_lily with the text of a controller or a platform of one's own."""
    text = (CONFIG / "scenarios/one_lily.yaml").read_text("utf-8")
    for key, name, own in (("controller", "constant", controller), ("platform", "lily", platform)):
        if own:
            (folder / f"{key}.yaml").write_text(own, "utf-8")
            text = text.replace(f"{key}: {name}", f"{key}: ./{key}.yaml")
    if controller:
        text = re.sub(r" +overrides: .*\n", "", text)
    (folder / "scenario.yaml").write_text(text, "utf-8")
    return folder / "scenario.yaml"


def boids(pattern: str, replacement: str) -> str:
    """The file of a shipped controller, changed in one place."""
    text, changes = re.subn(
        pattern, replacement, (CONFIG / "controllers/boids_blt.yaml").read_text("utf-8"), count=1, flags=re.DOTALL
    )
    assert changes == 1
    return text


@pytest.mark.parametrize(
    ("pattern", "replacement", "sentence"),
    [
        ("behaviour: boids_blt", "behaviour: boid_blt", r"'behaviour' has 'boid_blt', which does not exist; allowed: "),
        (
            r"  separation_weight:\n.*?confidence: \w+\n",
            "",
            r"'parameters' lacks 'separation_weight', which behaviour 'boids_blt' needs; add it\.",
        ),
        (
            "  separation_weight:",
            "  separation_wait:",
            r"'parameters' lacks 'separation_weight'",
        ),
        (
            "behaviour: boids_blt",
            "behaviour: idle",
            r"'parameters\.cohesion_weight' is no parameter of behaviour 'idle'",
        ),
    ],
)
def test_behaviour_and_parameters_are_checked(tmp_path: Path, pattern: str, replacement: str, sentence: str) -> None:
    """The sentence names the controller's file and the key."""
    path = scenario_with(tmp_path, controller=boids(pattern, replacement))
    with pytest.raises(CocorosimError, match=rf"controller\.yaml: {sentence}"):
        load_scenario(path)


def test_a_controller_with_nothing_to_move(tmp_path: Path) -> None:
    """A platform without actuators is a passive body, which the controller 'idle' fits."""
    lily = (CONFIG / "platforms/lily.yaml").read_text("utf-8")
    passive = re.sub(r"actuators:\n.*?\nsensors:", "actuators: []\n\nsensors:", lily, flags=re.DOTALL)
    path = scenario_with(tmp_path, platform=passive)
    with pytest.raises(CocorosimError, match=r"'swarm\[0\]\.controller' has 'constant'.* no actuators.* 'idle'"):
        load_scenario(path)
    text = re.sub(r" +overrides: .*\n", "", path.read_text("utf-8")).replace("constant", "idle")
    path.write_text(text, "utf-8")
    assert load_scenario(path).robots[0].platform.actuators == ()
