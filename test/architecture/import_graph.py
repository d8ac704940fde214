"""`python test/architecture/import_graph.py [CHECKOUT] [--inside PART] [--count]`: who imports whom, as Mermaid text.

Nodes are the parts of the package (folders, and modules beside them) or, with `--inside PART`, those of one folder. An
arrow points from what imports to what is imported; arrows that follow from two others are left out. `--count` prints
how many nodes, arrows and circles there are instead. The imports are read by grimp, nothing of the package is run.

    git worktree add ../before 18554be
    .venv/bin/python test/architecture/import_graph.py ../before --count
    .venv/bin/python test/architecture/import_graph.py . --inside diagnosis
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

PACKAGE = "cocorosim_ros"
Arrows = set[tuple[str, str]]


def part_of(module: str, inside: str) -> str | None:
    """The part that a module belongs to: the name after `inside`; None outside of it and for its own words."""
    prefix = f"{inside}."
    return module.removeprefix(prefix).partition(".")[0] if module.startswith(prefix) else None


def arrows_inside(checkout: Path, inside: str) -> tuple[set[str], Arrows]:
    """Parts of a folder of the package in that checkout, and which of them imports which."""
    sys.path.insert(0, str(checkout.resolve()))
    import grimp

    graph = grimp.build_graph(PACKAGE, cache_dir=None)
    parts, arrows = set(), set()
    for module in graph.modules:
        own = part_of(module, inside)
        if own is None:
            continue
        parts.add(own)
        for other in graph.find_modules_directly_imported_by(module):
            needed = part_of(other, inside)
            if needed is not None and needed != own:
                arrows.add((own, needed))
    return parts, arrows


def reached(start: str, arrows: Arrows) -> set[str]:
    """What is imported by `start`, directly or through others."""
    found: set[str] = set()
    waiting = [start]
    while waiting:
        here = waiting.pop()
        new = {end for begin, end in arrows if begin == here} - found
        found |= new
        waiting += new
    return found


def circles(parts: set[str], arrows: Arrows) -> set[str]:
    """The parts that import themselves through others."""
    return {part for part in parts if part in reached(part, arrows)}


def without_shortcuts(arrows: Arrows) -> Arrows:
    """The arrows without those whose end is reached by others as well; all of them where there are circles."""
    return {
        (begin, end)
        for begin, end in arrows
        if end not in reached(begin, arrows - {(begin, end)}) or begin in reached(end, arrows)
    }


def mermaid(parts: set[str], arrows: Arrows) -> str:
    """The graph as a Mermaid flowchart."""
    lines = ["flowchart TD", *(f"    {part}" for part in sorted(parts))]
    return "\n".join([*lines, *(f"    {begin} --> {end}" for begin, end in sorted(without_shortcuts(arrows)))])


def main() -> None:
    """Reads the command line and prints."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n", maxsplit=1)[0])
    parser.add_argument("checkout", type=Path, nargs="?", default=Path())
    parser.add_argument("--inside", default="", metavar="PART", help="such as diagnosis, or world")
    parser.add_argument("--count", action="store_true", help="numbers instead of the drawing")
    options = parser.parse_args()
    parts, arrows = arrows_inside(options.checkout, f"{PACKAGE}.{options.inside}".rstrip("."))
    if options.count:
        in_circles = ", ".join(sorted(circles(parts, arrows)))
        print(f"{len(parts)} parts, {len(arrows)} arrows, in circles: {in_circles or 'none'}")
    else:
        print(mermaid(parts, arrows))


if __name__ == "__main__":
    main()
