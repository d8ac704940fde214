"""A run of the command, for the library to be compared with."""

from __future__ import annotations

import sys
from collections.abc import Callable
from html.parser import HTMLParser
from pathlib import Path

import pytest

SHIPPED = Path(__file__).parents[2] / "bags" / "five_lilys"
VOID = {"br", "hr", "img", "input", "link", "meta"}


@pytest.fixture(scope="session")
def shipped() -> Path:
    """The recording that comes along: the folder of a run of five Lilys."""
    return SHIPPED


@pytest.fixture(scope="module")
def commanded(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder that `cocorosim run lilys_and_jeffs --in-process` leaves: 20 s of robots of two kinds, seed 7."""
    from cocorosim_ros.commands.main import main

    folder = tmp_path_factory.mktemp("commanded") / "run"
    words = ["run", "lilys_and_jeffs", "--in-process", "--duration", "20 s", "--seed", "7", "--out", str(folder)]
    with pytest.MonkeyPatch.context() as patch, pytest.raises(SystemExit) as ended:
        patch.setattr(sys, "argv", ["cocorosim", *words])
        main()
    assert not ended.value.code
    return folder


class Page(HTMLParser):
    """The elements and the text of a piece of HTML; what is opened must be closed in order."""

    def __init__(self, html: str) -> None:
        super().__init__(convert_charrefs=True)
        self.opened: list[str] = []
        self.elements: list[str] = []
        self.cells: list[str] = []
        self.attributes: list[str] = []
        self.feed(html)
        self.close()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        """Note an element that begins."""
        self.elements.append(tag)
        self.attributes += [name for name, _ in attrs]
        self.opened += [] if tag in VOID else [tag]

    def handle_endtag(self, tag: str) -> None:
        """An element ends: the one that began last."""
        assert self.opened.pop() == tag

    def handle_data(self, data: str) -> None:
        """Note the text."""
        self.cells.append(data)


@pytest.fixture(scope="session")
def parse() -> Callable[[str], Page]:
    """Function of HTML: its elements and texts, once it has been found to be whole and to need nothing else."""

    def read(html: str) -> Page:
        page = Page(html)
        assert page.opened == []
        assert not {"script", "link", "img", "iframe", "style"} & set(page.elements)
        assert not {"src", "href", "onload", "onclick"} & set(page.attributes)
        assert len(html) < 20_000
        return page

    return read
