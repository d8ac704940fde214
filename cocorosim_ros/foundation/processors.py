"""How many processors there are to work with."""

from __future__ import annotations

import os


def processors() -> int:
    """Return how many this process may use; only Linux tells these from all that the machine has."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
