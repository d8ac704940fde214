"""Which code makes a row: the version of the package and a digest of the sources that decide rows, and of no others.

The digest of compiled functions (`kernel.source_digest`) would not do: it knows the filter of the diagnosis, which no
run meets, and does not know how a scenario is read and how places at the start are drawn.
"""

from __future__ import annotations

from pathlib import Path

from cocorosim_ros import __version__
from cocorosim_ros.foundation.compiling.kernel import digest_of_sources

DECISIVE = (
    "foundation/compiling",
    "scenario",
    "world",
    "study/metrics",
    "study/experiments/batch.py",
    "study/experiments/rows.py",
)
"""Files and folders of the package that a row depends on, beside the scenario, which the digest of the design tells."""


def decisive_digest(package: Path) -> str:
    """The digest of the sources of DECISIVE in this folder."""
    return digest_of_sources(package, DECISIVE)


# Taken when the code is loaded: a source that is edited while a long study runs changes nothing of what runs.
_LOADED = f"{__version__}+{decisive_digest(Path(__file__).parents[2])}"


def version() -> str:
    """The version of the package, a plus sign and the digest of the sources that this process runs by."""
    return _LOADED
