"""The compiler of the inner loops, with types."""

from __future__ import annotations

import hashlib
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any, TypeVar, cast

import numba

Function = TypeVar("Function", bound=Callable[..., Any])


def compiled(function: Function) -> Function:
    """The function as machine code, kept on disk until any source of the Concealer changes.

    By itself numba keeps machine code until the file of the function changes, and not those of what it calls.
    """
    usual = numba.config.CACHE_DIR
    numba.config.CACHE_DIR = str(_folder())
    try:
        return cast(Function, numba.njit(cache=True)(function))
    finally:
        numba.config.CACHE_DIR = usual


@cache
def _folder() -> Path:
    """Where machine code of the present sources lies."""
    package = Path(__file__).parent
    digest = hashlib.sha256()
    for source in sorted(package.rglob("*.py")):
        digest.update(f"{source.relative_to(package)}\n".encode() + source.read_bytes())
    return package / "__pycache__" / digest.hexdigest()[:16]
