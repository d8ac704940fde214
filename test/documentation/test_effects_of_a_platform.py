"""The site shows every effect, with every number, as a platform file has it; config/README.md the laws."""

from __future__ import annotations

import re
import textwrap
from pathlib import Path

from site_builder.effects import example

from cocorosim_ros.scenario.parts.platform import load_platform
from cocorosim_ros.world.effects import CATALOGUE_EFFECTS
from cocorosim_ros.world.laws.laws_of_platform import effects_of
from cocorosim_ros.world.sensors.errors import ERRORS
from cocorosim_ros.world.terms.regressors import REGRESSORS
from cocorosim_ros.world.vehicle_model.platform_effects import KNOWN_EFFECTS
from cocorosim_ros.world.vehicle_model.vehicle_assembly import build_vehicles

TEXT = (Path(__file__).parents[2] / "config" / "README.md").read_text("utf-8")
SECTION = TEXT.partition("## Effects of a platform")[2].partition("\n## ")[0]


def test_the_example_is_a_platform_with_everything(tmp_path: Path) -> None:
    """The examples together load and build; they name each effect, and each number of all but the laws."""
    laws = "".join(code for code in re.findall(r"```yaml\n(.*?)```", SECTION, re.DOTALL) if "law_1:" in code)
    shown = {name: effect for name, effect in {**CATALOGUE_EFFECTS, **ERRORS}.items() if effect.numbers}
    examples = "\n".join([*(example(name, effect) for name, effect in shown.items()), laws])
    path = tmp_path / "example.yaml"
    path.write_text(f"name: example\ndescription: all\nbased_on: lily\neffects:\n{textwrap.indent(examples, '  ')}")
    platform = load_platform(path)
    assert build_vehicles([platform]).active[0, 0] > 0
    effects = effects_of(platform)
    assert set(effects) == set(KNOWN_EFFECTS)
    for effect, parameters in KNOWN_EFFECTS.items():
        if not effect.startswith(("law_", "sensor_law_")):
            assert set(effects[effect]) == set(parameters), effect


def test_regressors_stand_in_their_order() -> None:
    """The list of regressors is the table's."""
    assert ", ".join(regressor.name for regressor in REGRESSORS) in " ".join(SECTION.split())
