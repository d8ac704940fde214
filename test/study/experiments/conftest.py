"""A design small enough for tests: two groups of four short runs in the paper's numerics."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path
from types import SimpleNamespace

import pytest

DESIGN = """
name: little
description: for tests
scenario: eleven_lilys
numerics: [{numerics}]
seed: {seed}
replicates: {replicates}
change: {{duration: {duration}}}
baseline: BLT
groups:
  BLT: {{description: as it is}}
  deaf: {{description: hears nothing, change: {{swarm: {{overrides: {{alignment_weight: 0}}}}}}}}
"""


@pytest.fixture
def design_file(tmp_path: Path) -> Callable[..., str]:
    """Function of what is to be otherwise: path of a design file."""

    def write(**words: object) -> str:
        usual = {"numerics": "paper", "seed": 5, "replicates": 4, "duration": "20 s"}
        path = tmp_path / "little.yaml"
        path.write_text(DESIGN.format(**{**usual, **words}), "utf-8")
        return str(path)

    return write


@pytest.fixture
def experiment(cocorosim: Callable[..., SimpleNamespace]) -> Callable[..., SimpleNamespace]:
    """Function of arguments: exit status, output and errors of `cocorosim experiment` in this process."""
    return partial(cocorosim, "experiment")
