"""What the documents name exists, and nothing in the project speaks of the machine it was written on."""

from __future__ import annotations

import re
import struct
from pathlib import Path
from xml.etree import ElementTree

import pytest

import cocorosim_ros
from cocorosim_ros.scenario.parts.platform import load_platform

from .documents import ROOT, documents, fenced, links, own_files, paths_in_code
from .recipes import section

every_document = pytest.mark.parametrize("path", documents(), ids=lambda path: str(path.relative_to(ROOT)))
A_REGISTRY = re.compile(
    r"://(?!127\.0\.0\.1)[^\s/]*(pypi|mirror|proxy|artifact|nexus|:\d{2,5}\b|\d+\.\d+\.\d+\.\d+)", re.IGNORECASE
)


def test_the_documents_that_must_be_there() -> None:
    """A reader finds these at the root and beside the folders that they explain."""
    names = {str(path.relative_to(ROOT)) for path in documents()}
    assert {"README.md", "ARCHITECTURE.md", "CONTRIBUTING.md", "CHANGELOG.md", "config/README.md"} <= names


@every_document
def test_links_lead_somewhere(path: Path) -> None:
    """Every link to a file has a target."""
    missing = [target for target in links(path.read_text("utf-8")) if not (path.parent / target).exists()]
    assert not missing


@every_document
def test_paths_exist(path: Path) -> None:
    """Every path of this tree that is named exists, but for the one that a recipe tells to make."""
    text = path.read_text("utf-8")
    made = {
        "cocorosim_ros/world/controllers/circle.py",
        "cocorosim_ros/world/sensors/thermometer.py",
        "cocorosim_ros/world/sensors/errors/pressure_scale.py",
        "config/controllers/circle.yaml",
    }
    assert not [name for name in paths_in_code(text) if name not in made and not (ROOT / name).exists()]


def test_the_readme_is_one_screen() -> None:
    """The first page is read at a glance; everything else has a page of the site."""
    assert len((ROOT / "README.md").read_text("utf-8").splitlines()) <= 120


def test_the_picture_is_one() -> None:
    """The picture of the main run has the size that the program draws, and stays small."""
    data = (ROOT / "docs/pictures/shoal.png").read_bytes()
    assert struct.unpack(">II", data[16:24]) == (2000, 1250)
    assert len(data) < 400_000


def test_every_folder_is_explained() -> None:
    """ARCHITECTURE.md has a row for every folder of the package."""
    rows = re.findall(r"^\| (`.+?) \|", (ROOT / "ARCHITECTURE.md").read_text("utf-8"), re.MULTILINE)
    explained = {name for row in rows for name in re.findall(r"`(\w+)`", row)}
    package = ROOT / "cocorosim_ros"
    folders = {path.name for path in package.iterdir() if (path / "__init__.py").exists()}
    modules = {path.stem for path in package.glob("*.py")} - {"__init__"}
    assert explained == folders | modules


def test_the_changelog_knows_this_version() -> None:
    """Its newest entry is the version of the package."""
    versions = re.findall(r"^## (\S+)$", (ROOT / "CHANGELOG.md").read_text("utf-8"), re.MULTILINE)
    assert versions[0] == cocorosim_ros.__version__


def test_the_recipes_platform_loads(tmp_path: Path) -> None:
    """The platform that CONTRIBUTING.md shows is a valid one."""
    (yaml,) = fenced(section("Add a platform"), "yaml")
    file = tmp_path / "heavy_lily.yaml"
    file.write_text(yaml)
    assert load_platform(str(file)).mass == 0.45


def test_nothing_speaks_of_this_machine() -> None:
    """No text holds a path of the machine that it was written on, or the address of a package registry."""
    machine = re.compile(rf"{re.escape(str(Path.home()))}/|{re.escape(str(ROOT))}\b|(?<![\w.])/(root|home|work)/")
    for path in own_files():
        if path.name == Path(__file__).name:
            continue
        text = path.read_text("utf-8")
        assert not machine.search(text), path
        assert not A_REGISTRY.search(text), path


def test_the_manifest_names_the_licence() -> None:
    """package.xml, LICENSE and README agree."""
    assert ElementTree.parse(ROOT / "package.xml").findtext("license") == "Apache-2.0"
    assert "Apache License" in (ROOT / "LICENSE").read_text("utf-8")
    assert "Apache-2.0" in (ROOT / "README.md").read_text("utf-8")
