"""Every file in config/ loads, says where its numbers come from, and is found by name."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

import cocorosim_ros
from cocorosim_ros.scenario.parts.controller_file import load_controller
from cocorosim_ros.scenario.parts.platform import load_platform
from cocorosim_ros.scenario.reading import config_files
from cocorosim_ros.scenario.reading.config_files import config_names, find_config
from cocorosim_ros.scenario.reading.entry import Entry
from cocorosim_ros.scenario.reading.yaml_file import load_yaml
from cocorosim_ros.world.checks.loading import load_scenario
from cocorosim_ros.world.seeding.seeding import start_poses

CONFIG = Path(cocorosim_ros.__file__).parents[1] / "config"
FILES = sorted(CONFIG.glob("*/*.yaml"))
SHIPPED = {
    "scenarios": {"eleven_lilys", "thirty_lilys", "fifty_lilys", "one_lily", "paper_lilys"},
    "platforms": {"lily", "lily_paper", "hovercraft_epfl", "haizhe_auv"},
    "maps": {"hovercraft_epfl", "haizhe_auv", "killifish", "odometry_bag"},
    "controllers": {"boids_blt", "constant", "heading_hold", "idle"},
}


def quantities(entry: Entry) -> Iterator[Entry]:
    """All mappings with a 'value' below the entry."""
    if isinstance(entry.value, dict):
        if "value" in entry.value:
            yield entry
        for part in entry.value.values():
            yield from quantities(part)
    elif isinstance(entry.value, list):
        for part in entry.value:
            yield from quantities(part)


def test_the_files_that_must_be_there() -> None:
    """Each kind has at least the shipped names."""
    for kind, names in SHIPPED.items():
        assert names <= set(config_names(kind))


@pytest.mark.parametrize(
    "path", [path for path in FILES if path.parent.name == "scenarios"], ids=lambda path: path.stem
)
def test_scenario_loads_and_has_room(path: Path) -> None:
    """A scenario is called like its file, and its robots start in the water."""
    scenario = load_scenario(path.stem)
    assert scenario.name == path.stem
    poses = start_poses(scenario)
    assert all(scenario.tank.contains((x, y, z)) for x, y, z, _ in poses)


@pytest.mark.parametrize(
    "path", [path for path in FILES if path.parent.name == "platforms"], ids=lambda path: path.stem
)
def test_platform_loads(path: Path) -> None:
    """A platform is called like its file, and each number has source and confidence."""
    assert load_platform(path.stem).name == path.stem
    for entry in quantities(load_yaml(path)):
        assert {"value", "unit", "source", "confidence"} <= set(entry.value), entry.key


@pytest.mark.parametrize(
    "path", [path for path in FILES if path.parent.name == "controllers"], ids=lambda path: path.stem
)
def test_controller_loads(path: Path) -> None:
    """A controller is called like its file, and each parameter has source and confidence."""
    assert load_controller(path.stem).name == path.stem
    for entry in quantities(load_yaml(path)):
        assert {"value", "source", "confidence"} <= set(entry.value), entry.key


def test_sizes_of_the_swarms() -> None:
    """The numbers of robots are those of the names."""
    sizes = {"one_lily": 1, "eleven_lilys": 11, "paper_lilys": 11, "thirty_lilys": 30, "fifty_lilys": 50}
    assert {name: len(load_scenario(name).robots) for name in sizes} == sizes


def test_paper_scenario_uses_the_paper_numerics() -> None:
    """The paper's inertia, step, integrator and walls go together."""
    paper = load_scenario("paper_lilys")
    assert (paper.integrator.name, paper.integrator.step_ns) == ("semi_implicit_euler", paper.tick_ns)
    assert paper.integrator.contact == "stop_position"
    assert {robot.platform.name for robot in paper.robots} == {"lily_paper"}


def test_a_folder_is_no_name(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """It is called a folder, where a list of all names would not help."""
    monkeypatch.chdir(tmp_path)
    Path("logs").mkdir()
    with pytest.raises(cocorosim_ros.CocorosimError, match="'logs' is a folder, no map; name the YAML file in it"):
        find_config("maps", "logs")


def test_installed_files_are_found(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Without a checkout, names are looked up below AMENT_PREFIX_PATH, missing prefixes or not."""
    folder = tmp_path / "share" / "cocorosim_ros" / "config" / "platforms"
    folder.mkdir(parents=True)
    (folder / "other.yaml").write_text("name: other\n")
    monkeypatch.setattr(config_files, "_CHECKOUT", tmp_path / "nowhere")
    monkeypatch.setattr(sys, "prefix", str(tmp_path / "nothing"))
    monkeypatch.setenv("AMENT_PREFIX_PATH", f"{tmp_path / 'none'}:{tmp_path}")
    assert find_config("platforms", "other") == folder / "other.yaml"
    assert config_names("platforms") == ["other"]
