"""A whole diagnosis, page included, prints what it found and no warning of a library."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

PROGRAM = """
import sys
from cocorosim_ros.commands.main import main
sys.argv[0] = "cocorosim"
main()
"""


def said_by(*words: str) -> subprocess.CompletedProcess[str]:
    """What the command says in a process of its own, in which every warning is shown each time."""
    line = [sys.executable, "-W", "always", "-c", PROGRAM, *words]
    return subprocess.run(line, env=os.environ | {"COLUMNS": "200"}, capture_output=True, text=True, check=False)


def test_no_library_warns(tmp_path: Path) -> None:
    """Neither NumPy nor Matplotlib nor Numba, of a weak thruster: a case with an effect, pictures and an overlay."""
    run, out = str(tmp_path / "run"), tmp_path / "out"
    driven = said_by("run", "weak_thruster", "--in-process", "--duration", "90 s", "--out", run)
    assert driven.returncode == 0, driven.stderr
    done = said_by("diagnose", run, "--platform", "lily", "--out", str(out))
    assert done.returncode == 0, done.stderr
    assert (out / "report.html").read_text("utf-8").count("<svg") > 1
    assert "Warning" not in driven.stderr + done.stderr + driven.stdout + done.stdout
