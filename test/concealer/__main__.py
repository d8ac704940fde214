"""`python test/concealer conceal | score | tamper | verify ...`, from anywhere."""

from __future__ import annotations

import sys
from pathlib import Path


def run() -> int:
    """Exit status of the command line."""
    folder = str(Path(__file__).resolve().parents[1])
    if folder not in sys.path:
        sys.path.append(folder)
    from concealer.commands import main

    return main(sys.argv[1:])


if __name__ == "__main__":
    sys.exit(run())
