"""config/README.md lists every unit that files may have."""

from __future__ import annotations

import re

from cocorosim_ros.foundation.units.units import units_in_files

from .documents import ROOT

SECTION = (ROOT / "config" / "README.md").read_text("utf-8").split("## Units\n")[1].split("\n## ")[0]


def test_the_table_of_units_is_the_codes() -> None:
    """A row for each dimension that has several units, SI first; the others stand together in the last row."""
    rows = re.findall(r"^\| ([a-z ,A-Z]+) \| (`.*`) \|$", SECTION, re.MULTILINE)
    listed = [(of, re.findall(r"`(.+?)`", units)) for of, units in rows]
    units = {dimension: list(names) for dimension, names in units_in_files().items()}
    several = [(dimension, names) for dimension, names in units.items() if len(names) > 1]
    alone = [names[0] for names in units.values() if len(names) == 1]
    assert listed == [*several, ("anything else, in SI alone", alone)]
