"""What is told of keys: all that files and tables have, in the units that they have."""

from __future__ import annotations

import re

import pytest

import cocorosim_ros as cocorosim
from cocorosim_ros.library.explaining.index import every_explanation
from cocorosim_ros.library.explaining.shipped import trees
from cocorosim_ros.scenario.reading.config_files import config_names
from cocorosim_ros.scenario.reading.quantity import dimension_of
from cocorosim_ros.study.metrics import METRICS
from cocorosim_ros.wire.topics.topics import TOPICS
from cocorosim_ros.world.effects import CATALOGUE_EFFECTS
from cocorosim_ros.world.sensors import SENSORS
from cocorosim_ros.world.sensors.errors import ERRORS
from cocorosim_ros.world.sensors.law import SENSOR_LAWS
from cocorosim_ros.world.vehicle_model.platform_effects import KNOWN_EFFECTS

NAMES = {(each.kind, each.name): each for each in every_explanation()}
WITH_NAMES_OF_THEIR_OWN = re.compile(r"^(effects|robots|ranges|frame_corrections)\.|\.overrides\.|\.parameters\.")


def keys_of(tree: object, above: str = "") -> set[str]:
    """The dotted keys of a file, as it stands; the parts of a list share the key of the list."""
    if isinstance(tree, list):
        return set().union(*(keys_of(part, above) for part in tree if isinstance(part, dict)), set())
    if not isinstance(tree, dict) or "value" in tree:
        return set()
    here = {f"{above}{name}" for name in tree}
    return here.union(*(keys_of(part, f"{above}{name}.") for name, part in tree.items()))


@pytest.mark.parametrize(("folder", "kind"), [("scenarios", "scenario"), ("platforms", "platform")])
def test_every_key_that_a_shipped_file_has_is_explained(folder: str, kind: str) -> None:
    """No key of the files that ship is unknown, but for names that users choose."""
    further = {"based_on", *(f"sensors.{topic}" for topic in SENSORS)}
    for name, tree in trees(folder).items():
        for key in keys_of(tree) - further:
            if not WITH_NAMES_OF_THEIR_OWN.search(key):
                assert (f"key of a {kind}", key) in NAMES, f"{name}: {key}"


def test_forms_have_the_dimensions_that_the_files_have() -> None:
    """A number of a shipped platform is in a unit of the dimension that is told of its key."""
    compared = 0
    for tree in trees("platforms").values():
        for key, number in tree.items():
            if isinstance(number, dict) and "value" in number:
                assert NAMES["key of a platform", key].facts["form"].startswith(dimension_of(str(number["unit"])))
                compared += 1
    assert compared > 20


def test_every_key_tells_what_may_stand_there() -> None:
    """A key of a scenario or a platform says its form: unit and limits, choices, or what is inside."""
    keys = [each for (kind, _), each in NAMES.items() if kind in ("key of a scenario", "key of a platform")]
    assert [each.name for each in keys if not each.facts.get("form")] == []


def test_everything_in_the_tables_is_explained() -> None:
    """Metrics, topics, effects with each number, errors and controllers are there by their names."""
    wanted = {("metric", name) for name in METRICS} | {("topic", name) for name in TOPICS}
    for kind, table in (("effect", CATALOGUE_EFFECTS), ("error of a sensor", ERRORS)):
        wanted |= {(kind, name) for name in table}
        wanted |= {
            (f"number of the {kind} {name}", f"{name}.{part.name}")
            for name, what in table.items()
            for part in what.parameters
        }
    wanted |= {("controller", name) for name in config_names("controllers")}
    assert wanted <= NAMES.keys()
    assert all(each.meaning for each in NAMES.values())


def test_a_key_by_its_last_word_or_in_full() -> None:
    """The last word of a key finds it; its whole name finds it alone."""
    (patience,) = cocorosim.explain("patience")
    assert patience == cocorosim.explain("lockstep.patience")[0]
    assert patience.facts["form"] == "time [s], greater than zero"
    assert patience.facts["default"] == "10.0 s"
    assert "cocorosim_ros/graph/nodes/physics_shell.py" in patience.used_by
    gains = {"pressure_gain.gain", "wall_effect.gain", "neighbour_wake.gain", "actuators.gain", "depth_agreement.gain"}
    assert {each.name for each in cocorosim.explain("gain")} == gains
    assert cocorosim.explain("swarm[].start") == cocorosim.explain("swarm.start")


def test_the_catalogue_stands_below_effects() -> None:
    """What a platform file may have there, and nothing else, each with its place in the file."""
    key, *catalogue = cocorosim.explain("effects")
    assert (key.name, key.kind) == ("effects", "key of a platform")
    assert {each.name for each in catalogue} == set(KNOWN_EFFECTS) - set(SENSOR_LAWS)
    assert all(each.facts["in a platform file"] == f"effects.{each.name}" for each in catalogue)


def test_values_come_with_their_sources() -> None:
    """What a platform says of a number stands beside the name of the platform, with where it comes from."""
    (mass,) = cocorosim.explain("mass")
    assert "lily: 0.44 kg (Read et al. 2013, section 4)" in mass.facts["stands in"]
    (gain,) = cocorosim.explain("wall_effect.gain")
    assert (gain.facts["unit"], gain.facts["default"]) == ("1", "0")


@pytest.mark.parametrize(
    ("key", "meant"), [("patiense", "patience"), ("wall_efect", "wall_effect"), ("polarization", "polarisation")]
)
def test_a_name_that_there_is_not(key: str, meant: str) -> None:
    """A name that nothing has is answered by the nearest ones."""
    with pytest.raises(cocorosim.CocorosimError, match=f"'{key}' is no key.*did you mean {meant}"):
        cocorosim.explain(key)
