"""The switch that turns vectors off: four robots at once, or one after the other, give the same bits."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

RUN = """
import sys
from cocorosim_ros.commands.main import main
sys.argv = ["cocorosim", "run", "lilys_and_jeffs", "--in-process", "--duration", "30 s", "--out", sys.argv[1]]
main()
"""


def digest(folder: Path, vectors: str) -> str:
    """Digest of a short run of two platforms that see, hear and shoal, with vectors `on` or `off`."""
    from cocorosim_ros.wire.bags.bag_reader import read_bag
    from cocorosim_ros.wire.bags.comparison import bag_digest

    environment = os.environ | {"COCOROSIM_VECTORS": vectors}
    subprocess.run([sys.executable, "-c", RUN, str(folder)], env=environment, check=True, capture_output=True)
    return bag_digest(read_bag(folder / "bag")).hexdigest()


def test_both_ways_agree_to_the_bit(tmp_path: Path) -> None:
    """Motion, cones of blue light and medians: every byte of every message is the same."""
    assert digest(tmp_path / "on", "on") == digest(tmp_path / "off", "off")


def test_another_word_is_refused() -> None:
    """The sentence names the variable, what it has and what is allowed."""
    program = "import cocorosim_ros.foundation.compiling.switches"
    environment = os.environ | {"COCOROSIM_VECTORS": "no"}
    said = subprocess.run([sys.executable, "-c", program], env=environment, capture_output=True, text=True, check=False)
    assert said.returncode != 0
    assert "COCOROSIM_VECTORS=no; give 'on' or 'off'" in said.stderr
