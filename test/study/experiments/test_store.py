"""The folder of an experiment: resumed after any end, never mixed with another's."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pyarrow.parquet as pq
import pytest

from cocorosim_ros.foundation.errors import CocorosimError

Write = Callable[..., str]


def run(path: str, folder: Path, *options: str) -> subprocess.CompletedProcess[str]:
    """`cocorosim experiment` in a process of its own."""
    program = "from cocorosim_ros.commands.main import main; main()"
    words = [sys.executable, "-c", program, "experiment", path, "--out", str(folder), *options]
    return subprocess.run(words, capture_output=True, text=True, check=False, timeout=250)


def rows(folder: Path) -> list[dict[str, Any]]:
    """The finished rows without their wall time."""
    table = pq.read_table(folder / "results.parquet").drop_columns(["wall_seconds"])
    return table.to_pylist()


def calculate(path: str, folder: Path, size: int | None = None, most: int | None = None) -> Any:
    """Calculate up to `most` chunks of `size` runs of a design into a folder; the store."""
    from cocorosim_ros.study.experiments.design import load_design
    from cocorosim_ros.study.experiments.rows import chunks, run_chunk
    from cocorosim_ros.study.experiments.store import Store

    design = load_design(path)
    store = Store(folder, design)
    for chunk in list(chunks(design, store.done(), size))[:most]:
        store.add(run_chunk(chunk))
    return store


def test_rows_are_kept_and_not_repeated(design_file: Write, tmp_path: Path) -> None:
    """Three chunks, then the rest in chunks of another size, give the table that one go gives."""
    path = design_file()
    assert len(calculate(path, tmp_path / "a", 1, 3).done()) == 3
    store = calculate(path, tmp_path / "a", 2)
    assert sorted(part.num_rows for part in map(pq.read_metadata, (tmp_path / "a/parts").iterdir())) == [
        1,
        1,
        1,
        1,
        2,
        2,
    ]
    store.complete()
    calculate(path, tmp_path / "b").complete()
    assert rows(tmp_path / "a") == rows(tmp_path / "b")
    assert [row["replicate"] for row in rows(tmp_path / "a")] == [0, 1, 2, 3] * 2
    assert not list((tmp_path / "a/parts").iterdir())


def test_more_replicates_go_on_from_the_finished_table(design_file: Write, tmp_path: Path) -> None:
    """Two replicates more are four rows more; the old ones stay."""
    calculate(design_file(replicates=2), tmp_path / "a").complete()
    before = rows(tmp_path / "a")
    store = calculate(design_file(replicates=4), tmp_path / "a")
    assert len(list((tmp_path / "a/parts").iterdir())) == 2
    store.complete()
    after = rows(tmp_path / "a")
    assert len(after) == 8 and all(row in after for row in before)


def test_a_half_written_part_is_no_part(design_file: Write, tmp_path: Path) -> None:
    """What a kill in the middle of writing leaves behind counts nothing and disappears."""
    calculate(design_file(), tmp_path / "a", 1, 2)
    (tmp_path / "a/parts/x.parquet.new").write_bytes(b"PAR1 half")
    assert len(calculate(design_file(), tmp_path / "a", 1, 0).done()) == 2
    assert not (tmp_path / "a/parts/x.parquet.new").exists()


def test_killed_between_table_and_parts(design_file: Write, tmp_path: Path) -> None:
    """Rows that stand in the table and still in parts count once."""
    store = calculate(design_file(), tmp_path / "a")
    parts = {path: path.read_bytes() for path in (tmp_path / "a/parts").iterdir()}
    store.complete()
    for path, content in parts.items():
        path.write_bytes(content)
    before = rows(tmp_path / "a")
    calculate(design_file(), tmp_path / "a").complete()
    assert rows(tmp_path / "a") == before


def test_folders_of_others_are_not_touched(design_file: Write, tmp_path: Path) -> None:
    """Another design's table, other code's, somebody's file and a damaged part: one sentence each, nothing lost."""
    from cocorosim_ros.study.experiments.design import load_design
    from cocorosim_ros.study.experiments.store import Store

    calculate(design_file(), tmp_path / "a").complete()
    before = rows(tmp_path / "a")
    other = load_design(design_file(seed=6))
    with pytest.raises(CocorosimError, match="holds results of another design, 'little'"):
        Store(tmp_path / "a", other)
    assert rows(tmp_path / "a") == before
    note = tmp_path / "a/design.json"
    note.write_text(note.read_text("utf-8").replace("+", "-"), "utf-8")
    with pytest.raises(CocorosimError, match="holds results of version"):
        Store(tmp_path / "a", load_design(design_file()))
    (tmp_path / "b").mkdir()
    (tmp_path / "b/thesis.tex").touch()
    for force in (False, True):
        with pytest.raises(CocorosimError, match=r"holds 'thesis\.tex', which is no part of an experiment"):
            Store(tmp_path / "b", other, force=force)
    (tmp_path / "c").touch()
    with pytest.raises(CocorosimError, match="is a file"):
        Store(tmp_path / "c", other)
    Store(tmp_path / "a", other, force=True)
    assert not (tmp_path / "a/results.parquet").exists()


@pytest.mark.parametrize("content", [b"", b"{", b"[]", b"{}", b"\xff"])
def test_a_damaged_note_is_a_sentence(design_file: Write, tmp_path: Path, content: bytes) -> None:
    """A design.json that tells nothing is named and nothing is lost; --force starts again."""
    from cocorosim_ros.study.experiments.design import load_design
    from cocorosim_ros.study.experiments.store import Store

    calculate(design_file(), tmp_path / "a", 1, 1)
    note = tmp_path / "a/design.json"
    note.write_bytes(content)
    with pytest.raises(CocorosimError, match=r"design\.json does not say which design the rows beside it belong to"):
        Store(tmp_path / "a", load_design(design_file()))
    assert note.read_bytes() == content and len(list((tmp_path / "a/parts").iterdir())) == 1
    Store(tmp_path / "a", load_design(design_file()), force=True)
    assert not list((tmp_path / "a/parts").iterdir())


def test_a_damaged_table_is_a_sentence(design_file: Write, tmp_path: Path) -> None:
    """A part that is no Parquet file is named."""
    store = calculate(design_file(), tmp_path / "a", 1, 1)
    (part,) = (tmp_path / "a/parts").iterdir()
    part.write_bytes(b"not parquet")
    with pytest.raises(CocorosimError, match="is no readable table of results"):
        store.done()


def test_one_worker_two_workers_and_a_killed_one(design_file: Write, tmp_path: Path) -> None:
    """Killed with SIGKILL in the middle and resumed with two workers, the table is that of one worker in one go."""
    path = design_file(replicates=40, duration="100 s")
    assert run(path, tmp_path / "one", "--workers", "1").returncode == 0
    program = "from cocorosim_ros.commands.main import main; main()"
    words = [sys.executable, "-c", program, "experiment", path, "--out", str(tmp_path / "two"), "--workers", "2"]
    process = subprocess.Popen(words, stdout=subprocess.DEVNULL, start_new_session=True)
    deadline = time.monotonic() + 120
    while not list((tmp_path / "two").glob("parts/*.parquet")) and process.poll() is None:
        assert time.monotonic() < deadline
        time.sleep(0.01)
    os.killpg(process.pid, signal.SIGKILL)
    process.wait()
    finished = run(path, tmp_path / "two", "--workers", "2")
    assert finished.returncode == 0, finished.stderr
    assert rows(tmp_path / "one") == rows(tmp_path / "two")


def test_errors_on_the_command_line(design_file: Write, tmp_path: Path) -> None:
    """Status 2 and one sentence on standard error; nothing is made."""
    for options, told in (
        (["--workers", "0"], "--workers has 0"),
        (["--row", "8", "--replicates", "4"], "has no row 8; choose from 0 to 7"),
        (["--group", "Van"], "has no group 'Van'"),
        (["--numerics", "exact"], "has no kind of numerics 'exact'"),
        (["--replicates", "0"], "--replicates has 0"),
    ):
        result = run(design_file(), tmp_path / "a", *options)
        assert result.returncode == 2 and told in result.stderr and result.stderr.count("\n") == 1
    assert not (tmp_path / "a").exists()
