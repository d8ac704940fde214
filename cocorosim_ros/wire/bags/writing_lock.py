"""Whether a file is being written right now: who writes a recording holds a lock on it, which ends with the process.

Where the system has no such locks, no file is held.
"""

from __future__ import annotations

import sys
from contextlib import suppress
from io import FileIO
from pathlib import Path

if sys.platform != "win32":
    import fcntl


def hold(file: FileIO) -> None:
    """Hold a file that is being written until it is closed."""
    if sys.platform != "win32":
        with suppress(OSError):  # some file systems have no locks
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)


def is_held(path: Path) -> bool:
    """Whether somebody writes the file at a path."""
    if sys.platform != "win32":
        with suppress(OSError), path.open("rb") as file:
            try:
                fcntl.flock(file, fcntl.LOCK_SH | fcntl.LOCK_NB)
            except BlockingIOError:
                return True
    return False
