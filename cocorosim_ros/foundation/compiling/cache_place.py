"""Where the cache lies; without the compiler, for what keeps other things there and for who asks about it."""

from __future__ import annotations

import os
import tempfile
from functools import cache
from pathlib import Path


@cache
def cache_base() -> Path:
    """The folder of all: below NUMBA_CACHE_DIR, XDG_CACHE_HOME or the user's own cache, else among temporary files."""
    named = os.environ.get("NUMBA_CACHE_DIR") or os.environ.get("XDG_CACHE_HOME") or str(Path.home() / ".cache")
    bases = (Path(named) / "cocorosim_ros", Path(tempfile.gettempdir()) / f"cocorosim_ros-{_user()}")
    return next((base for base in bases if _is_writable(base)), bases[-1])


def _user() -> str:
    """Tell users of one folder of temporary files apart; Windows has numbers of none, and gives each a folder."""
    return str(os.getuid()) if hasattr(os, "getuid") else "user"


def _is_writable(base: Path) -> bool:
    try:
        base.mkdir(parents=True, exist_ok=True)
    except OSError:
        return False
    return os.access(base, os.W_OK)
