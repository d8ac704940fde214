"""Links of the documents, which lead through the tree, made into links that lead through the site.

A link to a Markdown file leads to its page, one to another file to a copy of it. One to a folder is only its name.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from pathlib import Path

DOCS = Path(__file__).parents[1]
ROOT = DOCS.parent
COPIES = "files"  # folder of the site with copies of files from outside docs/
_LINK = re.compile(r"(?P<picture>!?)\[(?P<words>[^\]]*)\]\((?P<target>[^)#\s]+)(?P<place>#[^)\s]*)?\)")
_FENCE = re.compile(r"(^ *```.*?^ *```$)", re.DOTALL | re.MULTILINE)
_TEXT = re.compile(r"<!-- text: (\S+) -->")


def text_of(page: Path) -> Path:
    """The file whose text a page is: its own, or that which its mark `<!-- text: FILE -->` names."""
    mark = _TEXT.search(page.read_text("utf-8"))
    return page if mark is None else (page.parent / mark[1]).resolve()


def pages() -> dict[Path, Path]:
    """The pages of the site by the files whose texts they are."""
    found = {text_of(page): page for page in sorted(DOCS.rglob("*.md")) if "paper" not in page.parts}
    return found | {ROOT / "README.md": DOCS / "index.md"}


def with_links_of_the_site(text: str, origin: Path, page: Path) -> str:
    """The text of a file as it stands on a page; code stays as it is."""
    known = pages()
    parts = _FENCE.split(text)
    return "".join(
        part if number % 2 else _LINK.sub(lambda link: _led(link, origin, page, known), part)
        for number, part in enumerate(parts)
    )


def copied_files() -> Iterator[tuple[Path, Path]]:
    """Every file that a page links to and that is no page, with its place in the site."""
    known = pages()
    for origin in known:
        for link in _LINK.finditer("".join(_FENCE.split(origin.read_text("utf-8"))[::2])):
            target = (origin.parent / link["target"]).resolve()
            if target.is_file() and target not in known and not link["picture"]:
                yield target, _place(target)


def _led(link: re.Match[str], origin: Path, page: Path, known: dict[Path, Path]) -> str:
    if "://" in link["target"]:
        return link[0]
    target = (origin.parent / link["target"]).resolve()
    place = link["place"] or ""
    if target in known:
        return f"[{link['words']}]({_relative(known[target], page)}{place})"
    if link["picture"]:
        return f"![{link['words']}]({_relative(target, page)})"
    if target.is_file():
        return f'<a href="{_relative(DOCS / _place(target), page)}{place}">{link["words"]}</a>'
    return f"`{link['words']}`"


def _place(file: Path) -> Path:
    """Where a copied file lies in the site."""
    return file.relative_to(DOCS) if file.is_relative_to(DOCS) else Path(COPIES) / file.relative_to(ROOT)


def _relative(target: Path, page: Path) -> str:
    return Path(os.path.relpath(target, page.parent)).as_posix()
