"""The benchmark runs and says what it promises; how fast it is, is not tested."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

BENCHMARK = Path(__file__).parent / "bench_graph.py"


def test_it_prints_conditions_speeds_and_parts() -> None:
    """One short run of each case: every line of the tables has its numbers, and the parts are not all zero."""
    command = [sys.executable, BENCHMARK, "--repeat", "1", "--share", "0.05"]
    done = subprocess.run(command, capture_output=True, text=True, timeout=1500, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    assert re.search(r"^load +[\d.]+ in the last minute", done.stdout, re.MULTILINE)
    for title in (
        "11 Lilys, 0.5 s",
        "11 Lilys, 0.1 s",
        "30 Lilys",
        "50 Lilys",
        "200 Lilys",
        "--composed",
        "--in-process",
    ):
        assert re.search(rf"│ .*{title}.* [\d.]+ │", done.stdout), title
    for part in ("publish", "decode", "decide", "write the bag", "measure the shoal"):
        assert re.search(rf"│ {part} .*0?\.[0-9]*[1-9]", done.stdout), part
    assert "What bounds it: a tick costs" in done.stdout
    assert re.search(r"must 40 x real time: .*goal 100 x: .*median [\d.]+ x", done.stdout)
