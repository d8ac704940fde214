"""Which files of the package read an attribute: found in their text, so that no list of it has to be kept."""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import cache

from cocorosim_ros.foundation.compiling.sources import PACKAGE

_READ = re.compile(r"\b(?=(\w+)\.(\w+)\b)")  # also of a.b.c the pair b.c


@cache
def _files_by_attribute() -> Mapping[tuple[str, str], tuple[str, ...]]:
    """By the last two words of what is read, such as ('lockstep', 'patience'), the files that do."""
    found: dict[tuple[str, str], list[str]] = {}
    for file in sorted(PACKAGE.rglob("*.py")):
        place = file.relative_to(PACKAGE.parent).as_posix()
        for pair in sorted(set(_READ.findall(file.read_text("utf-8")))):
            found.setdefault(pair, []).append(place)
    return {pair: tuple(files) for pair, files in found.items()}


def readers(owners: tuple[str, ...], names: tuple[str, ...]) -> tuple[str, ...]:
    """The files that read one of the names of one of these owners: `lockstep.patience`, `platform.mass`."""
    pairs = [(owner, name) for owner in owners for name in names]
    files = {file for pair in pairs for file in _files_by_attribute().get(pair, ())}
    return tuple(sorted(file for file in files if "explain" not in file))
