"""The site builds without a warning, its notebooks run, its links lead somewhere, and the reference is whole."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import dataclass, field
from html.parser import HTMLParser
from pathlib import Path

import pytest

import cocorosim_ros
from cocorosim_ros.commands.main import COMMANDS
from cocorosim_ros.scenario.reading.config_files import config_names
from cocorosim_ros.study.metrics import METRICS
from cocorosim_ros.wire.topics.topics import GLOBAL_TOPICS, ROBOT_TOPICS
from cocorosim_ros.world.effects import CATALOGUE_EFFECTS
from cocorosim_ros.world.sensors.errors import ERRORS

from .documents import ROOT

pytestmark = pytest.mark.timeout(1800)  # s; the first diagnosis of a notebook compiles
SPHINX = [sys.executable, "-m", "sphinx", "-q", "-W", "--keep-going", "-j", "2", "-b", "html"]


@dataclass
class Page(HTMLParser):
    """What an HTML page links to, loads, and can be linked to at."""

    path: Path
    places: set[str] = field(default_factory=set)
    links: list[str] = field(default_factory=list)
    loaded: list[str] = field(default_factory=list)

    def __post_init__(self) -> None:
        super().__init__()
        self.feed(self.path.read_text("utf-8"))

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        """Take down what an element says."""
        said = {name: value for name, value in attrs if value}
        self.places |= {said["id"]} if "id" in said else set()
        if tag == "a":
            self.links += [said["href"]] if "href" in said else []
        else:
            self.loaded += [said[name] for name in ("src", "href") if name in said]


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The site, built as `make docs` does."""
    folder = tmp_path_factory.mktemp("site")
    environment = os.environ | {"PYTHONPATH": str(ROOT)}
    command = [*SPHINX, "-d", str(folder / "doctrees"), str(ROOT / "docs"), str(folder / "html")]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False, cwd=folder)
    assert done.returncode == 0, done.stderr  # a kernel of a notebook says things there that are no warnings of Sphinx
    return folder / "html"


@pytest.fixture(scope="module")
def pages(site: Path) -> dict[Path, Page]:
    """Every page that Sphinx has made; reports of diagnoses and studies are files that it copies."""
    made = {path for path in site.rglob("*.html") if not (ROOT / "docs" / path.relative_to(site)).exists()}
    return {path: Page(path) for path in made}


def targets(page: Page) -> Iterator[tuple[str, Path, str]]:
    """Each link within the site: as it stands, its file, the place in it."""
    for link in (*page.links, *page.loaded):
        if "://" not in link and not link.startswith(("data:", "mailto:")):
            file, _, place = link.partition("#")
            yield link, (page.path.parent / file.split("?")[0]).resolve() if file else page.path, place


def test_every_link_leads_somewhere(pages: dict[Path, Page]) -> None:
    """Each file is there, and each heading that is linked to."""
    lost = [
        (page.path.name, link)
        for page in pages.values()
        for link, file, place in targets(page)
        if not file.exists() or (place and file in pages and place not in pages[file].places)
    ]
    assert not lost


def test_nothing_is_loaded_from_elsewhere(pages: dict[Path, Page]) -> None:
    """The site works from a disk without a network."""
    assert not [(page.path.name, link) for page in pages.values() for link in page.loaded if "://" in link]


def test_reports_are_served_as_pages(site: Path) -> None:
    """The diagnoses and the studies' page lie where the pages link to them."""
    reports = [*(ROOT / "docs" / "diagnosis").glob("*.html"), ROOT / "docs" / "studies.html"]
    assert len(reports) > 1
    for report in reports:
        assert (site / report.relative_to(ROOT / "docs")).read_bytes() == report.read_bytes()


@pytest.mark.parametrize(
    ("page", "names"),
    [
        ("commands", list(COMMANDS)),
        ("scenarios", config_names("scenarios")),
        ("topics", [*ROBOT_TOPICS, *GLOBAL_TOPICS]),
        ("messages", [path.stem for path in (ROOT / "msg_defs/msg").glob("*.msg")]),
        ("metrics", list(METRICS)),
        ("effects", [name for name, each in {**CATALOGUE_EFFECTS, **ERRORS}.items() if each.numbers]),
        ("python", cocorosim_ros.__all__),
    ],
)
def test_the_reference_is_whole(site: Path, page: str, names: list[str]) -> None:
    """Whatever stands in a table of the code stands on its page."""
    text = (site / "reference" / f"{page}.html").read_text("utf-8")
    assert not [name for name in names if f">{name}<" not in text and f" {name} " not in text]


def test_no_mark_is_left(site: Path) -> None:
    """Each mark of a table or a text has been replaced."""
    texts = {path: path.read_text("utf-8") for path in site.rglob("*.html")}
    assert not [path for path, text in texts.items() for mark in ("table: ", "text: ") if f"<!-- {mark}" in text]
