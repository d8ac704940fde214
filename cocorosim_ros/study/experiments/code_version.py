"""Which code makes a row: the version of the package and a digest of the sources that decide rows, and of no others.

They are the sources of the module that makes rows (compiling.sources): what it imports from this package, directly or
through others. The filter of the diagnosis, which no run meets, is not among them.
"""

from __future__ import annotations

from pathlib import Path

from cocorosim_ros import __version__
from cocorosim_ros.foundation.compiling.cache import TOOLS
from cocorosim_ros.foundation.compiling.sources import PACKAGE, digest_of, sources_of


def decisive_digest(package: Path) -> str:
    """The digest of the sources of a row in this copy of the package, and of the tools that compile them."""
    return digest_of(sources_of(package / "study" / "experiments" / "rows.py", package), *TOOLS)


# Taken when the code is loaded: a source that is edited while a long study runs changes nothing of what runs.
_LOADED = f"{__version__}+{decisive_digest(PACKAGE)}"


def version() -> str:
    """The version of the package, a plus sign and the digest of the sources that this process runs by."""
    return _LOADED
