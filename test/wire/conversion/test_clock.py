"""Times that are written as date and time of day: each form is read to the nanosecond, or refused by its name."""

from __future__ import annotations

from collections.abc import Callable
from datetime import datetime, timedelta
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.wire.conversion.conversion import convert
from cocorosim_ros.wire.conversion.map_file import load_map

Convert = Callable[..., SimpleNamespace]
COMPASS = "streams: {compass: {heading: {fixed: 0 rad}}}"
FORM = "%Y-%m-%d %H:%M:%S"
NS = 1_000_000_000


def stamps(convert_csv: Convert, time: str, cell: str, layout: str = "") -> list[int]:
    """The stamps [ns] of a file with one cell, and `time` as a map has it."""
    way = f"{{clock: 1, {time}}}"
    rest = f"robot: boat, time: {way}, layout: {{header: false{layout}}}, {COMPASS}"
    topics = convert_csv(f'  - {{files: "*.csv", {rest}}}\n', {"a.csv": f"{cell}\n"}).topics
    return [message.at for message in topics["/boat/compass"]]


def from_npz(folder: Path, time: str, cells: npt.NDArray[Any]) -> tuple[list[int], tuple[str, ...]]:
    """The stamps [ns] of an npz file whose array `t` has those cells, and the findings."""
    np.savez(folder / "a.npz", t=cells)
    text = f"name: m\nformat: npz\ntables:\n  - {{files: a.npz, robot: boat, time: {time}, {COMPASS}}}\n"
    (folder / "map.yaml").write_text(text, "utf-8")
    made = convert(load_map(folder / "map.yaml"), folder / "a.npz", folder / "bag")[0].conversion
    return made.streams[0].stamp_ns.tolist(), made.findings


@pytest.mark.parametrize(
    ("form", "cell", "seconds"),
    [
        ("%Y-%m-%dT%H:%M:%SZ", "1970-01-01T00:00:02.5Z", 2.5),
        ("%Y-%m-%dT%H:%M:%S+00:00", "1970-01-01t00:00:02.25+00:00", 2.25),
        ("%Y-%m-%d %I:%M:%S %p", "1970-01-01 05:00:02.5 PM", 61202.5),
        ("%S.%M.%H %d.%m.%Y", "02.5.01.00 01.01.1970", 62.5),
        ("%S.%M.%H %d.%m.%Y", "02.01.00 01.01.1970", 62.0),
        ("%d.%m.%Y %H.%M.%S", "01.01.1970 00.01.05.5", 65.5),
        ("%a %d %b %Y %H:%M:%S", "Thu 1 Jan 1970  00:00:2.", 2.0),
        ("%Y%m%d%H%M%S", "19700101000102.5", 62.5),
        ("%Y-%j %H%%%S %M", "1970-001 00%02.5 1", 62.5),
        ("%d %B %y", "2 january 70", 86400.0),
        ("%Y-%m-%d %H:%M", "1970-01-01 01:01", 3660.0),
    ],
)
def test_the_fraction_stands_behind_the_seconds(convert_csv: Convert, form: str, cell: str, seconds: float) -> None:
    """Wherever these are in the form, and whatever comes after them."""
    assert stamps(convert_csv, f"form: '{form}'", cell) == [round(seconds * NS)]


@pytest.mark.parametrize(
    ("form", "cell"),
    [
        (FORM, "1970-01-01 00:00:02.0000000001"),
        (FORM, "1970-01-01 00:00:02.-5"),
        (FORM, "1970-01-01 00:00:02.5.5"),
        (FORM, "1970-01-01 00:00:02,5"),
        ("%Y-%m-%d %I:%M:%S %p", "1970-01-01 05:00:02 PM.5"),
        ("%Y-%m-%d %H:%M", "1970-01-01 05:00.5"),
    ],
)
def test_another_fraction_is_none(convert_csv: Convert, form: str, cell: str) -> None:
    """More than nine digits, a sign, two points, a comma, and one that is not behind the seconds."""
    with pytest.raises(CocorosimError, match=r"a.csv line 1, column '1' has .* no time like .* or the map's 'form'"):
        stamps(convert_csv, f"form: '{form}'", f'"{cell}"')


@pytest.mark.parametrize(
    ("form", "cell"),
    [
        ("%d.%m.%Y, %H:%M:%S", "01.01.1970, 00:00:01,5"),
        ("%d,%m,%Y %H:%M:%S", "01,01,1970 00:00:01,5"),
        ("%d.%m.%Y %H.%M.%S", "01.01.1970 00.00.01,5"),
        (FORM, "1970-01-01 00:00:01.5"),
    ],
)
def test_decimal_comma(convert_csv: Convert, form: str, cell: str) -> None:
    """Only the mark before the fraction is meant, and no other comma or point of the form."""
    assert stamps(convert_csv, f"form: '{form}'", cell, ", separator: ';', decimal: ','") == [3 * NS // 2]


@pytest.mark.parametrize(("ahead", "seconds"), [("-5 h", 18002), ("0 h", 2), ("-1 ns", 2 + 1e-9), ("1 s", 1)])
def test_clocks_ahead_and_behind(convert_csv: Convert, ahead: str, seconds: float) -> None:
    """A clock behind UTC is ahead by less than nothing."""
    assert stamps(convert_csv, f"form: '{FORM}', ahead: {ahead}", "1970-01-01 00:00:02") == [round(seconds * NS)]


@pytest.mark.parametrize(
    ("form", "sentence"),
    [
        (FORM + ".%f", "has '%f'; leave it out"),
        (FORM + "%z", "has '%z'; .* say with 'ahead' how far the clock is ahead of UTC"),
        (FORM + " %Z", "has '%Z'; .* say with 'ahead'"),
        ("%c", "has '%c', which is written otherwise on other machines"),
        ("%x %H", "has '%x'"),
        ("%Y-%m-%d %X", "has '%X'"),
        ("%Q", "has '%Q', no field .*; allowed: .*%Y"),
        ("%D", "has '%D', no field"),
        ("%Y-%m-%d %", "has '%', no field"),
        ("hello", "has 'hello', from which year, month, day"),
        ("%H:%M:%S", "has '%H:%M:%S', from which year, month, day .* as in '%Y-%m-%d %H:%M:%S'"),
        ("%Y %Y", "from which year, month, day"),
        ("%Y-%m-%d %H %H", "write each field once"),
        ("%Y-%m-%d %I:%M:%S", "with %I also %p"),
        ("%Y-%m-%d %M:%S", "time of day cannot be read again"),
    ],
)
def test_a_wrong_form(convert_csv: Convert, form: str, sentence: str) -> None:
    """The map is refused before a log is read, and the sentence is about its form."""
    with pytest.raises(CocorosimError, match=rf"map.yaml line 4: 'tables\[0\].time.form' .*{sentence}") as caught:
        stamps(convert_csv, f"form: '{form}'", "1970-01-01 00:00:02")
    assert "missing" not in str(caught.value)


@pytest.mark.parametrize(("cell", "ahead"), [("1970-01-01 00:00:02", "2 h"), ("2300-01-01 00:00:02", "1 s")])
def test_out_of_range(convert_csv: Convert, cell: str, ahead: str) -> None:
    """A clock has no unit, and the form or `ahead` may be what is wrong."""
    with pytest.raises(CocorosimError, match=r"line 1 has the time .* correct 'form' \('%Y.*'\) or 'ahead'") as caught:
        stamps(convert_csv, f"form: '{FORM}', ahead: {ahead}", cell)
    assert "unit" not in str(caught.value)


def test_all_seconds_of_a_form() -> None:
    """What stands without a fraction is read as `strptime` reads it."""
    from cocorosim_ros.scenario.reading.entry import Entry
    from cocorosim_ros.wire.conversion.clock import Clock

    generator = np.random.default_rng(5)
    for form in ("%d/%b/%y %I%M%S%p", "%G-W%V-%u %H:%M:%S", "%A, %j of %Y at %H h %M m %S s", "%Y %U %w %H %M %S"):
        for second in generator.integers(0, 2_000_000_000, 50):
            moment = datetime(1970, 1, 1) + timedelta(seconds=int(second))
            assert Clock(Entry(1, "", 0, ""), form, False).nanoseconds(moment.strftime(form)) == second * NS, form


CLOCK = f"{{clock: t, form: '{FORM}'}}"
FIRST, SECOND = "1970-01-01 00:00:02.5", "1970-01-01 00:00:03"


@pytest.mark.parametrize(
    "cells",
    [
        np.array([FIRST, "", "NaT", "None", "nan", SECOND]),
        np.array([FIRST.encode(), b"", b"nan", SECOND.encode()]),
    ],
)
def test_words_and_bytes_in_arrays(tmp_path: Path, cells: npt.NDArray[Any]) -> None:
    """Both are text; empty cells have no time, and are counted."""
    found, findings = from_npz(tmp_path, CLOCK, cells)
    assert found == [5 * NS // 2, 3 * NS]
    assert findings[0] == f"a.npz: {len(cells) - 2} rows without a time were left out."


@pytest.mark.parametrize(
    ("time", "cells", "sentence"),
    [
        (CLOCK, np.array([FIRST, "1970/01/01 00:00:03"]),
         "a.npz row 2, column 't' has '1970/01/01 00:00:03', which is no time like '%Y-%m-%d %H:%M:%S'; correct it"),
        (CLOCK, np.array([2.5, 3.0]), "a.npz row 1, column 't' has '2.5', which is no time like"),
        ("{column: t, unit: s}", np.array(["1", "noon"]), "a.npz row 2, column 't' has 'noon', which is no number"),
        (CLOCK, np.array(["1970-01-01", "1970-01-02"], dtype="datetime64[ns]"),
         "time.clock' has 't', a column of moments in time, .* write 'time: {column: t, unit: ns}'"),
        ("{column: t, unit: s}", np.array(["1970-01-01"], dtype="datetime64[ns]"), "write 'unit: ns'"),
    ],
)  # fmt: skip
def test_wrong_words_in_arrays(tmp_path: Path, time: str, cells: npt.NDArray[Any], sentence: str) -> None:
    """A row whose time is written otherwise is not left out in silence."""
    with pytest.raises(CocorosimError, match=sentence):
        from_npz(tmp_path, time, cells)


def test_words_in_parquet(tmp_path: Path) -> None:
    """A cell without a value has no time; one in another form is an error."""
    arrow, parquet = pytest.importorskip("pyarrow"), pytest.importorskip("pyarrow.parquet")
    text = f"name: m\nformat: parquet\ntables:\n  - {{files: a.parquet, robot: boat, time: {CLOCK}, {COMPASS}}}\n"
    (tmp_path / "map.yaml").write_text(text, "utf-8")
    mapped = load_map(tmp_path / "map.yaml")
    parquet.write_table(arrow.table({"t": [FIRST, None, SECOND]}), tmp_path / "a.parquet")
    made = convert(mapped, tmp_path / "a.parquet", tmp_path / "bag")[0].conversion
    assert made.streams[0].stamp_ns.tolist() == [5 * NS // 2, 3 * NS]
    parquet.write_table(arrow.table({"t": [FIRST, "noon"]}), tmp_path / "a.parquet")
    with pytest.raises(CocorosimError, match=r"a.parquet row 2, column 't' has 'noon', which is no time like"):
        convert(mapped, tmp_path / "a.parquet", tmp_path / "other")
