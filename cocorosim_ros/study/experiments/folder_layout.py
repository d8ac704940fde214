"""What the folder of an experiment is made of, and whether a folder is one.

design.json        which design and which code the rows belong to
parts/*.parquet    rows of finished chunks; each appears at once or not at all
results.parquet    all rows, in the order of the design
"""

from __future__ import annotations

from pathlib import Path

from cocorosim_ros.foundation.errors import CocorosimError

DESIGN, PARTS, RESULTS = "design.json", "parts", "results.parquet"


def check_folder(folder: Path) -> None:
    """Nothing, if the folder holds an experiment. Raises CocorosimError otherwise."""
    if not (folder / DESIGN).is_file():
        raise CocorosimError(f"{folder} holds no experiment; give a folder that 'cocorosim experiment --out' has made.")
