"""The benchmark of writers runs and says what it promises; how fast they are, is not tested."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

BENCHMARK = Path(__file__).parent / "bench_writers.py"


def test_it_prints_conditions_and_ratios() -> None:
    """One short round: every writer is in both tables, and each library has its verdict."""
    command = [sys.executable, BENCHMARK, "--rounds", "1", "--duration", "5 s"]
    done = subprocess.run(command, capture_output=True, text=True, timeout=900, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    assert re.search(r"^load +[\d.]+ in the last minute", done.stdout, re.MULTILINE)
    for writer in ("ours", "mcap", "rosbags"):
        assert len(re.findall(rf"│ {writer} +│ +[\d.]+ │ +[\d.]+ │", done.stdout)) == 2, writer
    for library in ("mcap", "rosbags"):
        assert re.search(rf"with {library} a run loses -?\d+% of its speed; 10% would be the most", done.stdout)
