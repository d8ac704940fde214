"""The package as pip installs it, and the numbers that stand in several files."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path
from xml.etree import ElementTree

import pytest

import cocorosim_ros
from cocorosim_ros.wire.topics.topics import TOPICS

ROOT = Path(__file__).parents[2]
ENTRY_POINTS = {"cocorosim", "controller_node", "metrics_node", "physics_node"}


@pytest.fixture(scope="module")
def prefix(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A prefix into which pip has installed a copy of the tree, without a network."""
    source = tmp_path_factory.mktemp("source")
    for name in ("cocorosim_ros", "config", "msg_defs", "resource"):
        shutil.copytree(ROOT / name, source / name, ignore=shutil.ignore_patterns("__pycache__"))
    for name in ("setup.py", "setup.cfg", "package.xml", "pyproject.toml", "LICENSE", "README.md"):
        shutil.copy(ROOT / name, source / name)
    target = tmp_path_factory.mktemp("prefix")
    command = [sys.executable, "-m", "pip", "install", "--no-index", "--no-deps", "--no-build-isolation"]
    # Without --ignore-installed pip would remove the package from this very environment.
    command += ["--use-pep517", "--ignore-installed", "--prefix", target, source]
    installed = subprocess.run(command, capture_output=True, text=True, check=False)
    assert installed.returncode == 0, installed.stdout + installed.stderr
    return target


def test_pip_puts_the_commands_into_bin(prefix: Path) -> None:
    """setup.cfg sends scripts to lib/cocorosim_ros for colcon, and yet pip's land in bin."""
    assert {path.name for path in (prefix / "bin").iterdir()} == ENTRY_POINTS
    assert not (prefix / "lib/cocorosim_ros").exists()


def files_below(folder: Path) -> set[Path]:
    """All files, but for what Python compiles of them."""
    files = {path.relative_to(folder) for path in folder.rglob("*") if path.is_file()}
    return {path for path in files if "__pycache__" not in path.parts}


def test_pip_installs_what_is_not_code(prefix: Path) -> None:
    """The configuration and the marker of the ament index come along, and so does the promise of types."""
    share = prefix / "share/cocorosim_ros"
    assert files_below(share / "config") == files_below(ROOT / "config")
    assert {path.name for path in (share / "msg").iterdir()} == {path.name for path in ROOT.glob("msg_defs/msg/*.msg")}
    assert list(prefix.glob("lib/python3.*/site-packages/cocorosim-*.dist-info/METADATA"))
    (wheel,) = prefix.glob("lib/python3.*/site-packages/cocorosim-*.dist-info/WHEEL")
    assert "Tag: py3-none-any" in wheel.read_text("utf-8").splitlines()
    launch = {path.name for path in (share / "launch").glob("*.py")}
    assert launch == {path.name for path in ROOT.glob("cocorosim_ros/graph/launch/*.launch.py")} != set()
    assert (prefix / "share/ament_index/resource_index/packages/cocorosim_ros").is_file()
    assert list(prefix.glob("lib/python3.*/site-packages/cocorosim_ros/py.typed"))


def test_its_files_are_found_wherever_it_lies(prefix: Path, tmp_path: Path) -> None:
    """In a prefix that is not the interpreter's, as of `pip install --user`, and without the checkout."""
    (package,) = prefix.glob("lib/python3.*/site-packages")
    program = """
from cocorosim_ros.scenario.reading.config_files import config_folders
from cocorosim_ros.wire.cdr.type_store import definition_folders
print(config_folders()[0])
print(next(folder for folder in definition_folders() if folder.is_dir() and "cocorosim_ros" in str(folder)))
"""
    environment = {name: value for name, value in os.environ.items() if name != "AMENT_PREFIX_PATH"}
    printed = subprocess.run(
        [sys.executable, "-c", program],
        cwd=tmp_path,
        env=environment | {"PYTHONPATH": str(package)},
        capture_output=True,
        text=True,
        check=True,
    ).stdout
    assert printed.split() == [str(prefix / "share/cocorosim_ros/config"), str(prefix / "share/cocorosim_ros/msg")]


def test_the_environment_has_the_commands() -> None:
    """The commands of this very environment lie in its bin."""
    assert ENTRY_POINTS <= {path.name for path in Path(sys.prefix, "bin").iterdir()}


@pytest.mark.parametrize("manifest", ["package.xml", "msg_defs/package.xml"])
def test_one_version(manifest: str) -> None:
    """Both manifests carry the version of the package."""
    assert ElementTree.parse(ROOT / manifest).findtext("version") == cocorosim_ros.__version__


def test_the_manifest_names_every_message_package() -> None:
    """colcon and rosdep find whatever the topics' types come from."""
    package = ElementTree.parse(ROOT / "package.xml")
    named = {element.text for element in package.iter("exec_depend")}
    assert {row.type_name.split("/")[0] for row in TOPICS.values()} <= named


@pytest.mark.parametrize("name", ["requirements", "requirements-numpy1"])
def test_the_lock_holds_every_requirement_by_hash(name: str) -> None:
    """What the .in file asks for is in the lock, by hash, and no address or path stands there."""
    asked = re.findall(r"^([a-z][\w.-]*)", (ROOT / f"{name}.in").read_text(encoding="utf-8"), re.MULTILINE)
    lock = (ROOT / f"{name}.lock").read_text(encoding="utf-8")
    entries = re.split(r"^(?=[a-z])", lock, flags=re.MULTILINE)[1:]
    pinned = {entry.split("==")[0] for entry in entries}
    assert asked
    assert {word.replace(".", "-").lower() for word in asked} <= pinned
    assert all("--hash=sha256:" in entry for entry in entries)
    assert not re.search(r"://|--(index|find|extra)|^/|file:", lock, re.MULTILINE)
