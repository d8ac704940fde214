"""The cache of compiled functions: a folder for each set of sources, so that it can never be stale.

numba keys its cache on the file of a function alone; a change in a function that it calls, in another file, would go
unnoticed. The folder of a function therefore carries the digest of all sources that its module is made of
(compiling.sources), of numba's and NumPy's versions and of the switches of the compiler. A change in a metric leaves
the folders of the filter as they are. Folders that nothing has used for KEPT_DAYS are removed when a new one is made.
"""

from __future__ import annotations

import os
import shutil
import time
from collections.abc import Callable, Iterable
from functools import cache
from pathlib import Path
from typing import Any

import numba
import numpy

from cocorosim_ros.foundation.compiling.cache_place import cache_base
from cocorosim_ros.foundation.compiling.sources import digest_of, sources_of
from cocorosim_ros.foundation.compiling.switches import VECTORS

KEPT_DAYS = 30.0
_DAY = 86400.0  # s
TOOLS = (numba.__version__, numpy.__version__, f"vectors={VECTORS}")
Compiler = Callable[[Callable[..., Any]], Callable[..., Any]]


@cache
def folder_of(file: Path) -> Path:
    """The folder for the functions of this file: its own where it lies in the cache itself (compiling.tables)."""
    if cache_base() in file.parents:
        return file.parent
    return _folder(digest_of(sources_of(file), *TOOLS))


def folder_of_text(text: str, files: Iterable[Path]) -> Path:
    """The folder for a function with this text, which calls functions that were written in these files."""
    needed = {source for file in files for source in sources_of(file)}
    return _folder(digest_of(needed, *TOOLS, text))


def cached_with_its_sources(compiler: Compiler, function: Callable[..., Any]) -> Callable[..., Any]:
    """The function compiled by `compiler`, its machine code kept in the folder of its file."""
    numba.config.CACHE_DIR = str(folder_of(Path(function.__code__.co_filename)))
    compiled = compiler(function)
    if hasattr(compiled, "_cache"):  # not where numba is switched off
        _forgive_types_that_are_gone(compiled._cache._cache_file)
    return compiled


def _forgive_types_that_are_gone(file: Any) -> None:
    """Let numba start an index anew that names a class which is no longer where it was.

    A function is kept for each set of types that it was called with. A class among these may be defined by a caller,
    whose source is none of the function's own; if another version of this package has moved the class, numba would
    raise ModuleNotFoundError or AttributeError where it reads the index.
    """
    load = file._load_index

    def load_or_start_anew() -> Any:
        try:
            return load()
        except (ImportError, AttributeError):
            return {}

    file._load_index = load_or_start_anew


def _folder(digest: str) -> Path:
    """The folder of that name, made or marked as used."""
    folder = cache_base() / digest
    if not folder.is_dir():
        folder.mkdir(parents=True, exist_ok=True)
        _remove_unused(folder.parent)
    elif time.time() - folder.stat().st_mtime > _DAY and os.access(folder, os.W_OK):
        os.utime(folder)
    return folder


def _remove_unused(base: Path) -> None:
    """Remove the folders below `base` that no process has used for KEPT_DAYS."""
    oldest = time.time() - KEPT_DAYS * _DAY
    for folder in base.iterdir():
        try:
            unused = folder.is_dir() and folder.stat().st_mtime < oldest
        except FileNotFoundError:  # another process was faster
            continue
        if unused:
            shutil.rmtree(folder, ignore_errors=True)
