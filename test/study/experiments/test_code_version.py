"""The version that a row carries: of the sources that decide it, whole, and of no others."""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

import pytest

PACKAGE = Path(__file__).parents[3] / "cocorosim_ros"


@pytest.mark.parametrize(
    ("edited", "counts"),
    [
        ("world/seeding/seeding.py", True),
        ("study/experiments/batch.py", True),
        ("world/motion/dynamics.py", True),
        ("study/metrics/summary.py", True),
        ("diagnosis/filter/__init__.py", False),
        ("wire/cdr/kernels/__init__.py", False),
        ("study/experiments/store.py", False),
        ("commands/experiment.py", False),
    ],
)
def test_what_an_edit_changes(edited: str, counts: bool, tmp_path: Path) -> None:
    """The seeds, the batch and the physics decide a row; the filter of the diagnosis and the store do not."""
    from cocorosim_ros.study.experiments.code_version import decisive_digest

    copy = shutil.copytree(PACKAGE, tmp_path / "package", ignore=shutil.ignore_patterns("__pycache__"))
    before = decisive_digest(copy)
    with open(copy / edited, "a", encoding="utf-8") as source:
        source.write("# another\n")
    assert (decisive_digest(copy) != before) == counts


def test_everything_that_a_run_loads_counts() -> None:
    """Each module of the package that making rows loads is among its sources; folders' own words are not."""
    from cocorosim_ros.foundation.compiling.sources import sources_of

    program = (
        "import sys, cocorosim_ros.study.experiments.rows as _; "
        "print(*(m.__file__ for name, m in sys.modules.items() if name.startswith('cocorosim_ros.')), sep='\\n')"
    )
    loaded = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True).stdout
    paths = {Path(line) for line in loaded.splitlines()}
    others = paths - sources_of(PACKAGE / "study" / "experiments" / "rows.py")
    assert len(paths) > 100
    assert {path.name for path in others} <= {"__init__.py"}


def test_rows_and_folders_carry_it() -> None:
    """The version of the package, a plus sign and the digest, the same for the whole life of a process."""
    from cocorosim_ros import __version__
    from cocorosim_ros.study.experiments.code_version import decisive_digest, version

    assert version() == f"{__version__}+{decisive_digest(PACKAGE)}"
