"""Whether this installation has what the work needs: interpreter, packages, folders, cache, processors."""

from __future__ import annotations

import importlib.metadata
import importlib.util
import os
import platform
import re
import sys
import tempfile
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from cocorosim_ros import __version__
from cocorosim_ros.foundation.compiling.cache_place import cache_base
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.foundation.installation import DISTRIBUTION
from cocorosim_ros.foundation.processors import processors
from cocorosim_ros.scenario.reading.config_files import config_names, shipped_file

State = Literal["good", "absent", "bad"]
"""absent: something optional is not there. bad: something essential lacks."""
PYTHONS = ((3, 11), (3, 13))
_REQUIREMENT = re.compile(r"([\w.-]+)(?:\[[^\]]*\])?([^;]*)(?:;.*extra == [\"'](\w+)[\"'])?")
_OF_DEVELOPERS = frozenset({"bench"})
_MEGABYTE = 1e6


@dataclass(frozen=True)
class Finding:
    """One thing that was looked at."""

    name: str
    state: State
    words: str


def examine() -> tuple[Finding, ...]:
    """Everything that can be looked at without ROS, in the order in which it is told."""
    return (
        _python(),
        Finding("cocorosim", "good", f"{__version__} in {Path(__file__).parents[1]}"),
        *packages(importlib.metadata.requires(DISTRIBUTION) or () if _is_installed(DISTRIBUTION) else ()),
        _shipped(),
        Finding("processors", "good", f"{processors()} for this process, of {os.cpu_count()}"),
        _cache(),
        *_folders(),
    )


def _python() -> Finding:
    """A Python that is newer than those tested works if numba has a wheel for it, which its own row says."""
    least, most = PYTHONS
    version = sys.version_info[:2]
    words = f"{platform.python_version()}, {sys.executable}, {platform.system()} on {platform.machine()}"
    tested = f"; {'.'.join(map(str, least))} to {'.'.join(map(str, most))} are tested"
    return Finding("python", "bad" if version < least else "good", words + ("" if least <= version <= most else tested))


def _is_installed(name: str) -> bool:
    try:
        importlib.metadata.version(name)
    except importlib.metadata.PackageNotFoundError:
        return False
    return True


def packages(requirements: tuple[str, ...] | list[str]) -> Iterator[Finding]:
    """What the metadata of this package ask for: each package with its version, or how to get it.

    requirements: as `importlib.metadata.requires` gives them. What an extra asks for may be absent.
    """
    if not requirements:
        yield Finding("packages", "absent", f"{DISTRIBUTION} was not installed by pip, so what it needs is not told")
    for requirement in requirements:
        match = _REQUIREMENT.match(requirement)
        if match is None or match[3] in _OF_DEVELOPERS:
            continue
        name, wanted, extra = match[1], match[2].strip(), match[3]
        for_what = f" (for the extra [{extra}])" if extra else ""
        if _is_installed(name):
            yield Finding(name, "good", importlib.metadata.version(name) + for_what)
        else:
            target = f"{DISTRIBUTION}[{extra}]" if extra else f"{name}{wanted}"
            yield Finding(
                name, "absent" if extra else "bad", f'not installed{for_what}: `pip install "{target}"` brings it'
            )


def _shipped() -> Finding:
    try:
        shipped_file("README.md")
    except CocorosimError as error:
        return Finding("configuration", "bad", str(error))
    counts = {kind: len(config_names(kind)) for kind in ("scenarios", "platforms", "controllers", "maps")}
    folder = shipped_file("README.md").parent
    return Finding("configuration", "good", f"{', '.join(f'{n} {kind}' for kind, n in counts.items())} in {folder}")


def _cache() -> Finding:
    """How much is compiled already; without any the first run of each kind compiles, which takes a minute or two."""
    base = cache_base()
    if not os.access(base, os.W_OK):
        return Finding("cache", "bad", f"{base} cannot be written, so every start compiles; set XDG_CACHE_HOME")
    files = [file for file in base.rglob("*.nbc") if file.is_file()]
    if not files:
        return Finding("cache", "good", f"{base}: nothing is compiled yet; the first run takes a minute or two longer")
    size = sum(file.stat().st_size for file in files) / _MEGABYTE
    return Finding("cache", "good", f"{base}: {len(files)} compiled functions, {size:.0f} MB")


def _folders() -> Iterator[Finding]:
    """Where runs and pages are written unless another place is given."""
    for name, folder, essential in (
        ("working folder", Path.cwd(), False),
        ("temporary folder", Path(tempfile.gettempdir()), True),
    ):
        state: State = "good" if os.access(folder, os.W_OK) else "bad" if essential else "absent"
        hint = "" if state == "good" else " cannot be written; give --out, or go to another folder"
        yield Finding(name, state, f"{folder}{hint}")
