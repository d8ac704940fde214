"""The site's extension of Sphinx: texts and tables come to where a page has a mark for them, when the site is built.

<!-- text: ../../ARCHITECTURE.md -->    the page is the text of that file
<!-- table: commands -->                here stands what MADE has by that name, made from the code's own tables
"""

from __future__ import annotations

import re
import shutil
from pathlib import Path
from typing import Any

from site_builder import command_pages, effects, messages, python_names, tables
from site_builder.links import copied_files, text_of, with_links_of_the_site

MADE = {
    "commands": tables.command_table,
    "command helps": command_pages.command_helps,
    "scenarios": tables.scenario_table,
    "robot topics": tables.robot_topic_table,
    "swarm topics": tables.swarm_topic_table,
    "quality of service": tables.quality_table,
    "messages": messages.messages,
    "metrics": tables.paper_metric_table,
    "metric variants": tables.variant_table,
    "catalogue": effects.catalogue,
    "python": python_names.public_names,
}
MARK = re.compile(r"<!-- table: (.+?) -->")


def page_text(page: Path) -> str:
    """The text of a page with everything that its marks ask for. Raises KeyError for a table that there is not."""
    origin = text_of(page)
    text = with_links_of_the_site(origin.read_text("utf-8"), origin, page)
    text = text.replace("```mermaid", "```text")  # drawn where such files are looked at; the site has no such library
    return MARK.sub(lambda mark: MADE[mark[1]](), text)


def made_pages(env: Any) -> list[str]:
    """The pages of an environment of Sphinx that are not their file's text alone: such a file does not tell its age."""
    pages = {name: Path(env.doc2path(name)) for name in sorted(env.found_docs)}
    return [name for name, page in pages.items() if page.suffix == ".md" and _is_made(page)]


def _is_made(page: Path) -> bool:
    return text_of(page) != page or MARK.search(page.read_text("utf-8")) is not None


def _read(app: Any, name: str, source: list[str]) -> None:
    page = Path(app.env.doc2path(name))
    if page.suffix == ".md":
        source[0] = page_text(page)


def _copy(app: Any, error: Exception | None) -> None:
    """Put the files beside the pages that link to them."""
    for file, place in () if error else copied_files():
        target = Path(app.outdir, place)
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(file, target)


def setup(app: Any) -> dict[str, bool]:
    """Entry point for Sphinx."""
    app.connect("env-get-outdated", lambda app, env, added, changed, removed: made_pages(env))
    app.connect("source-read", _read)
    app.connect("build-finished", _copy)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
