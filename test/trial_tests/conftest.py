"""Makes the Concealer and the drivers of the trial importable, and hands out a tool that answers what it is told."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

FOLDER = str(Path(__file__).resolve().parents[1])
if FOLDER not in sys.path:
    sys.path.append(FOLDER)


@pytest.fixture
def tool(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[[str], Path]:
    """Function of a shell script's lines ($out: the answer's folder): puts it in the place of `cocorosim`."""
    from trial import examiner

    def install(lines: str) -> Path:
        script = tmp_path / "cocorosim"
        script.write_text(f"#!/bin/sh\nfor out; do :; done\necho ran >> {tmp_path / 'runs.txt'}\n{lines}\n")
        os.chmod(script, 0o755)
        monkeypatch.setattr(examiner, "COMMAND", script)
        return tmp_path / "runs.txt"

    return install
