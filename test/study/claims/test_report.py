"""The page: self-contained, and its numbers are those of the table."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import pytest

from cocorosim_ros.foundation.errors import CocorosimError

DESIGN = """
name: little
description: a <small> design
scenario: eleven_lilys
numerics: [paper]
seed: 5
replicates: 30
change: {duration: 20 s}
baseline: BLT
metrics: [polarisation, lost]
groups:
  BLT: {description: as it is}
  deaf: {description: hears nothing, change: {swarm: {overrides: {alignment_weight: 0}}}}
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Results of numbers that are made up: polarisation of `deaf` is lower throughout, lost is 0 everywhere."""
    from cocorosim_ros.study.experiments.code_version import version
    from cocorosim_ros.study.experiments.design import load_design
    from cocorosim_ros.study.experiments.rows import SCHEMA
    from cocorosim_ros.study.experiments.store import Store

    path = tmp_path / "little.yaml"
    path.write_text(DESIGN, "utf-8")
    store = Store(tmp_path / "results", load_design(path))
    for place, group in enumerate(("BLT", "deaf")):
        columns: dict[str, Any] = {}
        for field in SCHEMA:
            columns[field.name] = ["x"] * 30 if field.type == pa.string() else np.zeros(30)
        columns |= {"numerics": ["paper"] * 30, "group": [group] * 30, "replicate": np.arange(30)}
        columns["version"] = [version()] * 30
        columns["polarisation"] = 0.9 - 0.5 * place + np.arange(30) / 1000
        store.add(pa.table({name: pa.array(values, SCHEMA.field(name).type) for name, values in columns.items()}))
    return tmp_path / "results"


def test_spreads_and_effects(folder: Path) -> None:
    """Median and quartiles of 0, 1, ... 29 thousandths are 14.5, 7.25 and 21.75; the lower group has A = 0."""
    from cocorosim_ros.study.results.results import load_results

    results = load_results(folder)
    spread = results.spread("paper", "BLT", "polarisation")
    assert [spread.median, spread.lower, spread.upper] == pytest.approx([0.9145, 0.90725, 0.92175])
    found = results.effect("paper", "deaf", "polarisation")
    assert (found.value, found.size, found.direction) == (0.0, "large", "lower")
    assert results.effect("paper", "deaf", "lost").value == 0.5


def test_the_page_needs_nothing_else(folder: Path) -> None:
    """No address is fetched, the figure is inside, words of the design are escaped, numbers are there."""
    from cocorosim_ros.study.results.report import render_report
    from cocorosim_ros.study.results.results import load_results

    page = render_report([load_results(folder), load_results(folder)])
    assert not re.search(r"(src|href)=\"(?!data:|#)", page)
    assert page.count("data:image/svg+xml;base64,") == 2 and len(re.findall("<h1 .*>little</h1>", page)) == 2
    assert "a &lt;small&gt; design" in page and "<small>" not in page
    assert re.search(r"0\.9145 \(0\.907\d \u2026 0\.921\d\)", page) and "\u25bc 0.000 large" in page


def test_how_far_chance_goes(folder: Path) -> None:
    """Sets of 1, 5 and 10 of the baseline's 30 runs; lost is 0 in all of them, so that no two sets differ."""
    from cocorosim_ros.study.results.report import render_report
    from cocorosim_ros.study.results.results import load_results

    page = render_report([load_results(folder)])
    rows = re.findall(r'<tr><th>(\d+)</th><td class="number">(.*?)</td><td class="number">(.*?)</td>', page)
    assert [(runs, lost) for runs, _, lost in rows] == [("1", "0.500"), ("5", "0.500"), ("10", "0.500")]
    scores = [float(polarisation) for _, polarisation, _ in rows]
    assert scores[0] == 1.0 > scores[1] > scores[2] > 0.56
    assert "hours by the clock" in page and "processor" not in page


def test_rows_in_the_table_and_in_parts_count_once(folder: Path) -> None:
    """As they are after a kill between the writing of the table and the removal of the parts."""
    from cocorosim_ros.study.results.results import load_results

    table = load_results(folder).table
    pq.write_table(table, folder / "results.parquet")
    assert len(list((folder / "parts").iterdir())) == 2
    results = load_results(folder)
    assert results.table.num_rows == 60 and results.values("paper", "deaf", "lost").size == 30


def test_a_table_without_a_metric(folder: Path) -> None:
    """The file and the column are named, whichever of several files it is."""
    from cocorosim_ros.study.results.results import load_results

    part = folder / "parts/paper-deaf-0000000-30.parquet"
    pq.write_table(pq.read_table(part).drop_columns(["lost_time_mean"]), part)
    with pytest.raises(CocorosimError, match=r"deaf-0000000-30\.parquet lacks the column 'lost_time_mean'"):
        load_results(folder)


def test_a_column_that_holds_no_numbers(folder: Path) -> None:
    """Words where a metric should be: the file is named."""
    from cocorosim_ros.study.results.results import load_results

    part = folder / "parts/paper-deaf-0000000-30.parquet"
    table = pq.read_table(part)
    place = table.schema.get_field_index("lost")
    pq.write_table(table.set_column(place, "lost", pa.array(["some"] * 30)), part)
    with pytest.raises(CocorosimError, match=r"deaf-0000000-30\.parquet is no readable table of results"):
        load_results(folder)


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ("{", "", "design.json does not say which design the rows beside it belong to (Extra data"),
        ('"baseline"', '"base"', "(it lacks 'baseline')"),
        ('"tank"', '"pool"', "(it lacks 'tank')"),
        ('"numerics"', '"kind"', "(its 'cells' are none)"),
        ('"scenario"', '"story"', "(its 'cells' are none)"),
        ('"polarisation"', '"polarization"', "design.json asks for the metric 'polarization', which this version"),
    ],
)
def test_a_damaged_note(folder: Path, old: str, new: str, told: str) -> None:
    """The file is named, and the rows beside it stay."""
    from cocorosim_ros.study.results.results import load_results

    note = folder / "design.json"
    note.write_text(note.read_text("utf-8").replace(old, new, 1), "utf-8")
    with pytest.raises(CocorosimError) as error:
        load_results(folder)
    assert told in str(error.value) and "\n" not in str(error.value)
    assert len(list((folder / "parts").iterdir())) == 2


@pytest.mark.parametrize("made", [False, True])
def test_a_folder_without_results(tmp_path: Path, made: bool) -> None:
    """No experiment, or one without a finished run: a sentence."""
    from cocorosim_ros.study.experiments.design import load_design
    from cocorosim_ros.study.experiments.store import Store
    from cocorosim_ros.study.results.results import load_results

    if made:
        Store(tmp_path / "a", load_design("smoke"))
    with pytest.raises(CocorosimError, match="holds no finished runs yet" if made else "holds no experiment"):
        load_results(tmp_path / "a")
