"""Where files that are not code lie once the package is installed."""

from __future__ import annotations

import os
import sys
from pathlib import Path

PACKAGE = "cocorosim_ros"  # as Python imports it and as ROS knows it
DISTRIBUTION = "cocorosim"  # as pip knows it, so that `uvx --from cocorosim cocorosim` is the command
_HERE = Path(__file__).resolve()
# From `site-packages` to the prefix: none below `pip install --target`, two on Windows, three elsewhere.
_DEEPEST = 4


def ament_prefixes() -> list[Path]:
    """The prefixes of the sourced ROS workspaces, the latest first."""
    return [Path(text) for text in os.environ.get("AMENT_PREFIX_PATH", "").split(os.pathsep) if text]


def own_prefixes() -> list[Path]:
    """The prefix into which pip has put this package (environment, user's or --target), then the interpreter's."""
    above = _HERE.parents[2 : 2 + _DEEPEST]
    found = [folder for folder in above if (folder / "share" / PACKAGE).is_dir()][:1]
    return [*found, Path(sys.prefix)]
