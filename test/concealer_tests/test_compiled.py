"""Machine code of the Concealer that is kept on disk is that of the present sources."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

PLACE = "from concealer.physics import derivative; print(derivative._cache.cache_path)"


def place_of_code(folder: Path) -> Path:
    """Where machine code of `physics.derivative` is kept, of the Concealer below a folder."""
    environment = os.environ | {"PYTHONPATH": str(folder)}
    return Path(subprocess.check_output([sys.executable, "-c", PLACE], env=environment, text=True).strip())


def test_a_change_in_any_source_leaves_old_code_behind(tmp_path: Path) -> None:
    """`derivative` calls functions of fluid.py: once that file is another one, no code from before is taken."""
    package = shutil.copytree(Path(__file__).parents[1] / "concealer", tmp_path / "concealer")
    before = place_of_code(tmp_path)
    assert package in before.parents
    assert place_of_code(tmp_path) == before
    (package / "fluid.py").write_text((package / "fluid.py").read_text() + "\nOTHER = 1\n")
    assert place_of_code(tmp_path) != before
