"""What CONTRIBUTING.md tells to add is added to a copy of this tree, and runs there."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest

from .recipes import with_lines

SCENARIO = """
name: recipes
description: one Lily circles in water that turns
seed: 1
tick: 0.5 s
duration: 20 s
tank: {size: [6 m, 6 m, 2 m]}
integrator: {name: rk4, step: 0.25 s, contact: inelastic}
swarm:
  - {platform: lily, prefix: lily, controller: circle, start: {poses: [[1 m, 0 m, -1 m, 90 deg]]}}
  - {platform: lily, prefix: still, controller: idle, start: {poses: [[2 m, 0 m, -1 m, 90 deg]]}}
water:
  currents: [{kind: turning, rate: 0.01 1/s}]
"""
RUN = """
import sys
from cocorosim_ros.commands.main import main
sys.argv = ["cocorosim", "run", sys.argv[1], "--in-process", "--out", sys.argv[2]]
main()
"""
MESSAGE = """
from cocorosim_ros.wire.cdr.type_store import schema_text, type_store
store = type_store()
Temperature = store.types["cocorosim_msgs/msg/Temperature"]
Header, Time = store.types["std_msgs/msg/Header"], store.types["builtin_interfaces/msg/Time"]
data = store.serialize_cdr(Temperature(Header(Time(1, 2), "lily"), 288.5, 0.0), Temperature.__msgtype__)
read = store.deserialize_cdr(bytes(data), Temperature.__msgtype__)
print(read.temperature, "# K" in schema_text(Temperature.__msgtype__))
"""


LOG = """
import sys
from pathlib import Path
from cocorosim_ros import convert
folder = Path(sys.argv[1])
(folder / "log.jsonl").write_text('{"t": 1, "u": 0.5}\\n{"t": 2, "u": 0.75}\\n')
(folder / "map.yaml").write_text("name: m\\nformat: jsonl\\ntables: [{files: log.jsonl, time: {column: t, unit: s}, "
    "robot: boat, streams: {velocity: {x: {column: u, unit: m/s}}}}]")
print(convert(folder / "map.yaml", folder / "log.jsonl", folder / "bag").recordings[0].messages)
"""


@pytest.fixture(scope="module")
def run(python: Callable[..., str], tree: Path) -> Path:
    """The folder of a run of the copy that needs all of them."""
    scenario = tree / "recipes.yaml"
    scenario.write_text(SCENARIO, encoding="utf-8")
    python("-c", RUN, scenario, tree / "out")
    return tree / "out"


def test_the_new_controller_and_current_move_the_robots(run: Path) -> None:
    """Water that turns carries the idle robot with it: rate times distance from the middle, to a tenth; no other does.

    0.01 / s at 2 m is 2 cm/s. A Lily at rest takes the water's speed within drag's time, 1 / (d v / m) = 12 s; after
    20 s from rest it has 2 cm/s / (1 + 12 / 20) and has come 2 cm/s (20 s - 12 s ln(1 + 20 / 12)) = 16 cm along.
    """
    from cocorosim_ros.wire.bags.tracks import read_poses

    tracks = read_poses(run / "bag")
    still, circling = tracks["still_01"].position, tracks["lily_01"].position
    assert still[-1, 1] - still[0, 1] == pytest.approx(0.16, rel=0.15)
    assert abs(still[-1, 0] - still[0, 0]) < 0.02
    assert abs(circling[-1, 1] - circling[0, 1]) > 0.3


def test_the_new_metric_is_measured(run: Path) -> None:
    """Both robots begin 1 m deep and keep that depth."""
    measured = json.loads((run / "metrics.json").read_text("utf-8"))["metrics"]["mean_depth"]
    assert measured["unit"] == "m"
    assert measured["value"] == pytest.approx(1.0, abs=0.1)


def test_the_new_message_is_known(python: Callable[..., str], tree: Path, tmp_path: Path) -> None:
    """It is written and read back, with its comments as schema."""
    share = tmp_path / "share" / "cocorosim_msgs"
    share.mkdir(parents=True)
    (share / "msg").symlink_to(tree / "msg_defs" / "msg")
    assert python("-c", MESSAGE, AMENT_PREFIX_PATH=str(tmp_path)).split() == ["288.5", "True"]


def test_lines_come_to_the_end_of_their_table() -> None:
    """Imports at the top, entries before the bracket that closes the table, others stay."""
    source = "from cocorosim_ros.a import A\n\nT: dict[str, int] = {\n    'a': A,\n}\nU = {\n}\n"
    assert with_lines(source, "T", "from cocorosim_ros.b import B\n\n'b': B,\n") == (
        "from cocorosim_ros.b import B\nfrom cocorosim_ros.a import A\n\nT: dict[str, int] = {\n"
        "    'a': A,\n    'b': B,\n}\nU = {\n}\n"
    )


def test_the_new_format_is_read(python: Callable[..., str], tmp_path: Path) -> None:
    """A map may ask for it, and its rows become messages."""
    assert python("-c", LOG, tmp_path) == "2\n"
