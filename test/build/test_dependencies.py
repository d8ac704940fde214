"""What the package imports is what it says that it needs: to pip, to rosdep and on the page of the installation."""

from __future__ import annotations

import ast
import os
import re
import subprocess
import sys
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from importlib.metadata import packages_distributions
from pathlib import Path
from xml.etree import ElementTree

import pytest

ROOT = Path(__file__).parents[2]
PACKAGE = ROOT / "cocorosim_ros"
# Imports that only those parts need which a machine without ROS, cluster or such files has no use for.
PLACES_OF_EXTRAS = {
    "ros": ("graph/nodes",),
    "dask": ("study/experiments/on_dask.py",),
    "logs": (),
    "netcdf": (),
    "view": ("study/scene",),
    "foxglove": ("wire/live",),
}
BUILT_HERE = {"cocorosim_msgs", "tf2_msgs"}
OF_ROS_LAUNCH = ("graph/launch",)  # files for `ros2 launch`, whose packages are not on PyPI

# Refuses the modules named in the first argument, imports every command, and runs one without ROS.
WITHOUT_EXTRAS = """
import importlib, sys
refused = set(sys.argv.pop(1).split(","))

class Refuse:
    def find_spec(self, name, path=None, target=None):
        if name.partition(".")[0] in refused:
            raise ModuleNotFoundError(f"No module named '{name}'", name=name)

sys.meta_path.insert(0, Refuse())
from cocorosim_ros.commands import main
for name in main.COMMANDS:
    importlib.import_module(f"cocorosim_ros.commands.{name}")
main.main()
"""


@dataclass(frozen=True)
class Import:
    """One import of somebody else's module."""

    file: str
    root: str
    late: bool  # within a function: loaded only when that is called


def imports() -> Iterator[Import]:
    """All imports of the package that are neither its own nor the standard library's."""
    for path in sorted(PACKAGE.rglob("*.py")):
        tree = ast.parse(path.read_text("utf-8"))
        late = {
            inner
            for node in ast.walk(tree)
            if isinstance(node, ast.FunctionDef | ast.If)
            for inner in ast.walk(node)
            if isinstance(inner, ast.Import | ast.ImportFrom)
        }
        for node in ast.walk(tree):
            if isinstance(node, ast.Import):
                names = [alias.name for alias in node.names]
            elif isinstance(node, ast.ImportFrom) and node.module:
                names = [node.module]
            else:
                continue
            for name in names:
                root = name.partition(".")[0]
                if root not in sys.stdlib_module_names and root != "cocorosim_ros":
                    yield Import(str(path.relative_to(PACKAGE)), root, node in late)


@dataclass(frozen=True)
class Declared:
    """The requirements in the metadata, names as PyPI normalises them."""

    always: set[str]
    extras: dict[str, set[str]]


def normal(name: str) -> str:
    """A distribution's name without extras and versions, as PEP 503 writes it."""
    return re.sub(r"[-_.]+", "-", re.match(r"[\w.-]+", name)[0]).lower()


@pytest.fixture(scope="module")
def declared(tmp_path_factory: pytest.TempPathFactory) -> Declared:
    """What setuptools makes of setup.py, as any installer would read it."""
    folder = tmp_path_factory.mktemp("metadata")
    command = [sys.executable, "setup.py", "-q", "egg_info", "--egg-base", str(folder)]
    subprocess.run(command, cwd=ROOT, check=True, capture_output=True)
    sections: dict[str, set[str]] = {"": set()}
    section = ""
    for line in (folder / "cocorosim.egg-info/requires.txt").read_text("utf-8").split():
        if line.startswith("["):
            section = line.strip("[]")
            sections[section] = set()
        else:
            sections[section].add(normal(line))
    return Declared(sections.pop(""), sections)


@cache
def installed() -> Mapping[str, list[str]]:
    """The distributions of this environment by the modules that they bring; asking takes seconds."""
    return packages_distributions()


def distribution(module: str) -> str:
    """The name on PyPI of what brings a module; a package of ROS is also known by its name in package.xml."""
    names = sorted(map(normal, installed()[module]), key=lambda name: not name.startswith("ros-"))
    return names[0]


def test_everything_that_is_imported_is_declared(declared: Declared) -> None:
    """What a file imports at its head is always needed; what an extra brings comes late, or in the extra's place."""
    undeclared = []
    for found in imports():
        if found.root in BUILT_HERE or found.file.startswith(OF_ROS_LAUNCH):
            continue
        name = distribution(found.root)
        if name in declared.always:
            continue
        brought = [extra for extra, names in declared.extras.items() if name in names or _is_of_ros(name, extra)]
        if not any(found.late or found.file.startswith(PLACES_OF_EXTRAS[extra]) for extra in brought):
            undeclared.append(found)
    assert undeclared == []


def _is_of_ros(name: str, extra: str) -> bool:
    """rclpy and the common interfaces bring all the other packages of ROS."""
    return extra == "ros" and name.startswith("ros-")


def test_nothing_is_declared_that_nothing_imports(declared: Declared) -> None:
    """Who installs the package gets what it uses and no more."""
    imported = {distribution(found.root) for found in imports() if not found.file.startswith(OF_ROS_LAUNCH)}
    assert declared.always <= imported


def test_requirements_are_those_of_the_lock(declared: Declared) -> None:
    """Each requirement stands in requirements.in with its reason, or comes with one that does."""
    text = (ROOT / "requirements.lock").read_text("utf-8")
    locked = {normal(name) for name in re.findall(r"^([a-z][\w.-]*)==", text, re.MULTILINE)}
    wanted = declared.always.union(*(names for extra, names in declared.extras.items() if extra != "bench"))
    assert wanted <= locked


def test_a_ros_machine_gets_all_of_them_by_rosdep_or_by_the_line_in_the_documents(declared: Declared) -> None:
    """`rosdep install` reads package.xml; what has no key there stands in the documents' line for Jazzy."""
    keys = {element.text for element in ElementTree.parse(ROOT / "package.xml").iter("exec_depend")}
    page = (ROOT / "docs/how_to/install.md").read_text("utf-8")
    chapter = page.split("## On a ROS 2 Jazzy installation")[1].split("\n## ")[0]
    line = re.search(r"^    pip install (.+)$", chapter, re.MULTILINE)[1]
    by_pip = {normal(word.strip("'")) for word in line.split()}
    by_rosdep = {name for name in declared.always if {f"python3-{name}", f"python3-{name.replace('-', '.')}"} & keys}
    assert declared.always - by_rosdep - by_pip == set()


@pytest.fixture(scope="module")
def refused(declared: Declared) -> str:
    """The modules that no base requirement brings, for WITHOUT_EXTRAS."""
    roots = {found.root for found in imports()} - BUILT_HERE
    return ",".join(sorted(BUILT_HERE | {root for root in roots if _only_by_extra(root, declared)}))


def _only_by_extra(root: str, declared: Declared) -> bool:
    return root in ("launch", "launch_ros") or distribution(root) not in declared.always


def cocorosim(refused: str, *arguments: str, cwd: Path) -> subprocess.CompletedProcess[str]:
    """`cocorosim` in an interpreter that has none of the extras."""
    command = [sys.executable, "-c", WITHOUT_EXTRAS, refused, *arguments]
    environment = os.environ | {"PYTHONPATH": str(ROOT)}
    return subprocess.run(command, cwd=cwd, env=environment, capture_output=True, text=True, check=False)


def test_every_command_is_there_without_ros_and_one_runs(refused: str, tmp_path: Path) -> None:
    """Neither rclpy nor generated message classes are needed for a run without ROS and its statistics."""
    assert {"rclpy", "cocorosim_msgs", "dask", "xarray"} <= set(refused.split(","))
    run = cocorosim(refused, "run", "one_lily", "--in-process", "--duration", "2 s", "--out", "one", cwd=tmp_path)
    assert run.returncode == 0, run.stderr
    assert (tmp_path / "one/bag/metadata.yaml").is_file()


@pytest.mark.parametrize("command", [("run", "one_lily"), ("replay", "five_lilys")])
def test_what_needs_ros_says_so(refused: str, tmp_path: Path, command: tuple[str, str]) -> None:
    """A command that starts nodes ends with a sentence and status 2, before anything is written."""
    bag = str(ROOT / "bags/five_lilys")
    done = cocorosim(refused, command[0], command[1].replace("five_lilys", bag), cwd=tmp_path)
    assert done.returncode == 2
    assert re.search(r"needs the Python package rclpy, which is not installed .*cocorosim\[ros\]", done.stderr)
    assert "Traceback" not in done.stderr
    assert list(tmp_path.iterdir()) == []
