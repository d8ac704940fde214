"""A plain Python controller as nodes, composed and without ROS: the same bag, and the same end when it fails."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from cocorosim_ros.wire.bags.bag_reader import read_bag

EXAMPLE = Path(__file__).parents[2] / "examples" / "own_controller.py"
WAYS = pytest.mark.parametrize("way", [(), ("--composed",), ("--in-process",)], ids=["graph", "composed", "in_process"])
FAILING = """
class Failing:
    def __call__(self, sensed):
        if sensed.time == 1.5 and sensed.robot == "lily_02":
            return {"left": sensed.nonsense}
        return {"left": 0.5}
"""


@pytest.fixture
def run(start: Callable[..., Any], scenario: Callable[..., Path], tmp_path: Path) -> Callable[..., Any]:
    """Function of (name of a folder, controller, options): the finished run and its folder."""

    def begin(name: str, controller: str, *options: object) -> Any:
        folder = tmp_path / name
        process = start("cocorosim", "run", scenario(3, 20), "--controller", controller, "--out", folder, *options)
        process.finish()
        return process, folder

    return begin


def test_every_way_of_running_gives_the_same_bag(
    run: Callable[..., Any], counts: Callable[[Path], dict[str, int]]
) -> None:
    """The example, which draws random numbers, listens and speaks: the same bytes three times; another seed differs."""
    bags = {}
    for name, options in {"graph": (), "composed": ("--composed",), "alone": ("--in-process",)}.items():
        process, folder = run(name, f"{EXAMPLE}:Follow", *options)
        assert process.finish() == 0, process.output
        bags[name] = (folder / "bag" / "bag_0.mcap").read_bytes()
    assert bags["graph"] == bags["composed"] == bags["alone"]
    _, other = run("other", f"{EXAMPLE}:Follow", "--in-process", "--seed", 2)
    made_from = [read_bag(other.with_name(name) / "bag").summary.metadata["cocorosim"] for name in ("alone", "other")]
    assert made_from[0]["digest"] != made_from[1]["digest"]
    assert f"{EXAMPLE}:Follow" in made_from[0]["scenario"]
    assert counts(other / "bag")["/lily_01/radio_tx"] == 20


@WAYS
def test_an_exception_ends_the_run(
    run: Callable[..., Any], counts: Callable[[Path], dict[str, int]], tmp_path: Path, way: tuple[str, ...]
) -> None:
    """Status 1 and the user's own line, robot and tick; what was recorded until then stays and is whole."""
    (tmp_path / "failing.py").write_text(FAILING, "utf-8")
    process, folder = run("run", f"{tmp_path / 'failing.py'}:Failing", *way)
    assert process.finish() == 1, process.output
    assert "failing.py:5: AttributeError: 'Sensed' object has no attribute 'nonsense'; this ended" in process.output
    assert "'Failing' of lily_02 at tick 3 (1.5 s)" in process.output
    assert "What was recorded until then is in" in process.output
    assert not read_bag(folder / "bag").summary.damage
    assert 3 <= counts(folder / "bag")["/lily_01/pose"] <= 5


@WAYS
def test_a_constructor_that_fails_is_unusable_input(
    run: Callable[..., Any], tmp_path: Path, way: tuple[str, ...]
) -> None:
    """Status 2 and the user's own line, before anything is written."""
    source = (
        "class Mine:\n    def __init__(self):\n        {}['gain']\n    def __call__(self, sensed):\n        return {}\n"
    )
    (tmp_path / "unmade.py").write_text(source, "utf-8")
    process, folder = run("run", f"{tmp_path / 'unmade.py'}:Mine", *way)
    assert process.finish() == 2, process.output
    assert "unmade.py:3: KeyError: 'gain'; 'Mine' of lily_01 could not be made." in process.output
    assert not folder.exists()


@WAYS
def test_a_file_that_cannot_be_imported_is_unusable_input(
    run: Callable[..., Any], tmp_path: Path, way: tuple[str, ...]
) -> None:
    """Status 2 before anything is touched."""
    (tmp_path / "broken.py").write_text("import no_such_module\n", "utf-8")
    process, folder = run("run", f"{tmp_path / 'broken.py'}:Mine", *way)
    assert process.finish() == 2, process.output
    assert "broken.py:1: ModuleNotFoundError: No module named 'no_such_module'" in process.output
    assert not folder.exists()


def test_the_node_of_a_robot_that_is_not_ours(start: Callable[..., Any], free_domain: str, tmp_path: Path) -> None:
    """controller_node makes the class with ROS parameters as arguments, and ends with status 1 and its sentence."""
    source = "class Told:\n    def __init__(self, gain=0.5):\n        self.gain = gain\n"
    source += "    def __call__(self, sensed):\n        raise ValueError(f'gain {self.gain} at {sensed.robot}')\n"
    (tmp_path / "told.py").write_text(source, "utf-8")
    parameters = (f"controller:={tmp_path / 'told.py'}:Told", "setting.gain:=0.75", "period:=0.05")
    given = [word for parameter in parameters for word in ("-p", parameter)]
    env = {"ROS_DOMAIN_ID": free_domain, "ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST"}
    node = start("controller_node", "--ros-args", "-r", "__ns:=/lily_07", *given, env=env)
    assert node.finish() == 1, node.output
    assert "told.py:5: ValueError: gain 0.75 at lily_07; this ended 'Told' of lily_07 at tick 0" in node.output
