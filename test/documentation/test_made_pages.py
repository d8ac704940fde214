"""Pages that are made from the code are made anew whenever the site is built, though their files be as before."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

from site_builder import made_pages


@dataclass
class Environment:
    """Pages of a folder, by the methods of Sphinx's environment."""

    folder: Path
    found_docs: set[str] = field(default_factory=set)

    def doc2path(self, name: str) -> str:
        """The file of a page."""
        return str(next(self.folder.glob(f"{name}.*")))


def test_pages_with_marks_are_made_anew(tmp_path: Path) -> None:
    """A page with a table or another file's text is, one of plain text and a notebook are not."""
    (tmp_path / "table.md").write_text("# A table\n\n<!-- table: metrics -->\n")
    (tmp_path / "text.md").write_text("<!-- text: plain.md -->\n")
    (tmp_path / "plain.md").write_text("# Words\n")
    (tmp_path / "notebook.ipynb").write_text('{"cells": ["<!-- table: metrics -->"]}')
    env = Environment(tmp_path, {"table", "text", "plain", "notebook"})
    assert made_pages(env) == ["table", "text"]
