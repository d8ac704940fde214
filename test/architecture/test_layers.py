"""The folders are the data flow: the contracts in pyproject.toml hold, and they find what breaks them."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
ROS_FREE_PROGRAM = """
import importlib, sys

class NoRos:
    def find_spec(self, name, path=None, target=None):
        root = name.partition(".")[0]
        if root in ("rclpy", "builtin_interfaces", "rcl_interfaces") or root.endswith("_msgs"):
            raise ModuleNotFoundError(f"ROS is blocked: {name}")

sys.meta_path.insert(0, NoRos())
for name in sys.argv[1:]:
    importlib.import_module(name)
"""


def module_name(path: Path) -> str:
    """Dotted name of a source file."""
    return ".".join(path.relative_to(ROOT).with_suffix("").parts).removesuffix(".__init__")


def modules_without_ros() -> list[str]:
    """All modules but those of graph/nodes/, and of commands/ the one that must start on a machine without ROS."""
    sources = (ROOT / "cocorosim_ros").rglob("*.py")
    names = sorted(map(module_name, sources))
    shell = tuple(f"cocorosim_ros.{folder}" for folder in ("graph.nodes", "commands", "graph.launch"))
    core = [name for name in names if not name.startswith(shell)]
    return core + [name for name in names if name == "cocorosim_ros.commands.main"]


@pytest.fixture
def copy(tmp_path: Path) -> Path:
    """A copy of the sources in which faults may be planted."""
    shutil.copy(ROOT / "pyproject.toml", tmp_path)
    shutil.copytree(ROOT / "cocorosim_ros", tmp_path / "cocorosim_ros", ignore=shutil.ignore_patterns("__pycache__"))
    return tmp_path


def plant(copy: Path, file: str, line: str) -> None:
    """Write a new module of one line into the copy."""
    path = copy / "cocorosim_ros" / file
    path.parent.mkdir(exist_ok=True)
    (path.parent / "__init__.py").touch()
    path.write_text(f"{line}\n", encoding="utf-8")


def broken_contracts(copy: Path) -> set[str]:
    """Names of the contracts that import-linter finds broken in the copy."""
    linter = Path(sys.prefix, "bin", "lint-imports")
    result = subprocess.run([linter, "--no-cache"], cwd=copy, capture_output=True, text=True, check=False)
    assert "Contracts: " in result.stdout, result.stdout + result.stderr
    broken = set(re.findall(r"^(.+) BROKEN", result.stdout, re.MULTILINE))
    assert (result.returncode != 0) == bool(broken)
    return broken


def test_the_sources_keep_every_contract(copy: Path) -> None:
    """Nothing is broken in the sources as they are."""
    assert broken_contracts(copy) == set()


@pytest.mark.parametrize(
    ("file", "line", "contract"),
    [
        ("scenario/parts/planted.py", "import cocorosim_ros.world.tick", "Data flows one way"),
        ("novelties/planted.py", "", "Data flows one way"),
        ("world/state/planted.py", "import cocorosim_ros.world.tick", "Rooms of the world"),
        ("world/sensors/planted.py", "import cocorosim_ros.world.links", "Rooms of the world"),
        ("world/novelties/planted.py", "", "Rooms of the world"),
        ("library/planted.py", "", "Rooms of the library"),
        ("wire/bags/planted.py", "import cocorosim_ros.library.scenario", "Data flows one way"),
        ("wire/cdr/planted.py", "import cocorosim_ros.wire.bags", "Rooms of the wire"),
        ("study/metrics/planted.py", "import cocorosim_ros.study.claims", "Rooms of the studies"),
        ("diagnosis/filter/planted.py", "import cocorosim_ros.diagnosis.naming", "Rooms of the diagnosis"),
        ("diagnosis/novelties/planted.py", "", "Rooms of the diagnosis"),
        (
            "diagnosis/evidence/frames/planted.py",
            "import cocorosim_ros.diagnosis.evidence.topic_rows",
            "Rooms of the evidence",
        ),
        ("diagnosis/evidence/planted.py", "", "Rooms of the evidence"),
        ("world/motion/planted.py", "import rclpy", "Only nodes/ knows ROS"),
        ("world/tick/planted.py", "import geometry_msgs.msg", "Only nodes/ knows ROS"),
        ("commands/planted.py", "import rclpy", "Only nodes/ knows ROS"),
        (
            "world/controllers/planted.py",
            "import cocorosim_ros.world.water",
            "A controller sees only what its robot senses",
        ),
        (
            "graph/runs/run_error.py",
            "import cocorosim_ros.world.tick",
            "The controller of a real robot needs no simulator",
        ),
    ],
)
def test_a_planted_fault_is_found(copy: Path, file: str, line: str, contract: str) -> None:
    """Each way of breaking the rule breaks the contract that states it, and no other."""
    plant(copy, file, line)
    assert broken_contracts(copy) == {contract}


def test_nodes_may_know_ros(copy: Path) -> None:
    """The contracts do not forbid what the shell is for, nor a command that starts a node."""
    plant(copy, "graph/nodes/planted.py", "import rclpy")
    plant(copy, "commands/planted.py", "import cocorosim_ros.graph.nodes.planted")
    assert broken_contracts(copy) == set()


def test_the_core_imports_without_ros() -> None:
    """Everything but the nodes imports where neither rclpy nor a message package exists."""
    names = modules_without_ros()
    assert "cocorosim_ros.foundation.errors" in names
    program = [sys.executable, "-c", ROS_FREE_PROGRAM]
    result = subprocess.run([*program, *names], cwd=ROOT, capture_output=True, text=True, check=False)
    assert result.returncode == 0, result.stderr
    blocked = subprocess.run([*program, "rclpy"], cwd=ROOT, capture_output=True, text=True, check=False)
    assert "ROS is blocked: rclpy" in blocked.stderr
