"""After its warm-up a node loads and compiles nothing more: ready means that it can answer."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

WARMED_UP = Path(__file__).with_name("warmed_up.py")
LIMIT = 400.0  # s; only an empty cache takes so long


@pytest.mark.parametrize("scenario", ["eleven_lilys", "light_gathering"])
def test_nothing_is_left_to_compile(scenario: str) -> None:
    """In a process of its own, whose machine code is that of the warm-up alone; robots that talk, and by light."""
    command = [sys.executable, str(WARMED_UP), scenario]
    done = subprocess.run(command, capture_output=True, text=True, timeout=LIMIT, check=False)
    assert done.returncode == 0, done.stderr
    assert done.stdout == ""
