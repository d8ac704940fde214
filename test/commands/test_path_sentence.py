"""Paths that the system refuses are said in a sentence, whichever command meets them."""

from __future__ import annotations

import errno
import os
import subprocess
import sys
from pathlib import Path

import pytest

from cocorosim_ros.commands.path_sentence import path_sentence

LONG = "n" * 300
"""Longer than the 255 bytes that file systems allow."""
PROGRAM = "import sys; from cocorosim_ros.commands.main import main; sys.argv[0] = 'cocorosim'; main()"


@pytest.mark.parametrize(
    "line",
    [
        f"convert odometry_bag {LONG} --out out",
        f"convert odometry_bag . --out {LONG}",
        f"convert --guess {LONG}.csv --out out.yaml",
        f"convert {LONG}.yaml . --out out",
        f"check {LONG}",
        f"view {LONG} --no-open",
        f"diagnose {LONG} --platform lily --out out",
        f"diagnose . --platform lily --out {LONG}",
        f"diagnose . --platform {LONG}.yaml --out out",
    ],
    ids=lambda line: line.replace(LONG, "LONG"),
)
def test_a_name_that_is_too_long(tmp_path: Path, line: str) -> None:
    """One sentence with the name and the system's reason, status 2."""
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(map(os.path.abspath, filter(None, sys.path)))}
    call = [sys.executable, "-c", PROGRAM, *line.split()]
    with pytest.raises(subprocess.CalledProcessError) as caught:
        subprocess.run(call, cwd=tmp_path, env=environment, capture_output=True, text=True, timeout=60, check=True)
    done = caught.value
    assert done.returncode == 2, done.stderr
    assert done.stderr.count("\n") == 1
    assert "nnnnnnnn" in done.stderr and "File name too long" in done.stderr


def test_an_error_without_a_path() -> None:
    """It is no mistake of a path, and keeps its traceback."""
    assert path_sentence(OSError(errno.ECONNREFUSED, "Connection refused")) is None
    told = path_sentence(OSError(errno.ENOSPC, "No space left on device", "/mnt/bag"))
    assert told is not None and told.startswith("/mnt/bag cannot be used: No space left on device; check")
