"""Under which conditions a benchmark ran, as lines to print above its figures."""

from __future__ import annotations

import os
import platform
import re
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

LIBRARIES = ("numpy", "numba", "ros-jazzy-rclpy")


def conditions() -> list[str]:
    """Processor, cores, load and versions."""
    return [
        f"processor   {processor()}, {cores()} cores usable, {platform.system()} {platform.release()}",
        f"load        {os.getloadavg()[0]:.1f} in the last minute before the start",
        f"versions    Python {platform.python_version()}, {', '.join(f'{name} {of(name)}' for name in LIBRARIES)}",
    ]


def cores() -> int:
    """How many cores this process may use."""
    return len(os.sched_getaffinity(0))


def processor() -> str:
    """The name of the processor."""
    found = re.search(r"^model name\s*:\s*(.+)$", Path("/proc/cpuinfo").read_text(), re.MULTILINE)
    return found[1] if found else platform.machine()


def of(library: str) -> str:
    """The installed version of a library."""
    try:
        return version(library)
    except PackageNotFoundError:
        return "not from PyPI"
