"""A file that a command does not read: what it is, and the command that leads on, each in one sentence."""

from __future__ import annotations

import zipfile
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

Run = Callable[..., SimpleNamespace]
TABLE = "t,u,x\n0,0.5,1\n0.1,0.6,2\n0.2,0.7,3\n"
BY_GUESS = (
    "write a map with 'format: {0}', by hand or by `cocorosim convert --guess {1} --out MAP.yaml`, and use `cocorosim "
    "convert MAP.yaml {1} --out BAG`."
)


@pytest.fixture(autouse=True)
def _here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Files are named as they are typed: in this folder."""
    monkeypatch.chdir(tmp_path)


def told(done: SimpleNamespace) -> str:
    """The one sentence of a refusal, on one line."""
    assert done.status == 2
    return " ".join(done.err.split())


def table(name: str = "run.csv") -> str:
    """The name of a new CSV file."""
    Path(name).parent.mkdir(exist_ok=True)
    Path(name).write_text(TABLE)
    return name


@pytest.mark.parametrize("command", ["diagnose", "metrics"])
def test_a_table_where_a_recording_is_asked_for(cocorosim: Run, command: str) -> None:
    """Guess a map, look at it, convert."""
    name = table("a/run.csv")
    options = ("--platform", "lily", "--out", "found") if command == "diagnose" else ()
    sentence = told(cocorosim(command, name, *options))
    assert f"{name} is not an MCAP file: it is a text table (CSV); {BY_GUESS.format('csv', name)}" in sentence


def test_the_way_out_leads_on(cocorosim: Run) -> None:
    """The commands of that sentence, as they stand there, make a recording."""
    Path("run.csv").write_text(
        "time,x,y,depth,left,right\n" + "".join(f"{k},{k},{2 * k},3,0.5,0.25\n" for k in range(9))
    )
    assert cocorosim("convert", "--guess", "run.csv", "--out", "MAP.yaml").status == 0
    assert cocorosim("convert", "MAP.yaml", "run.csv", "--out", "BAG").status == 0
    assert cocorosim("check", "BAG").status in (0, 1)


@pytest.mark.parametrize("magic", [b"PAR1", b"PAR1\x15\x04"])
def test_parquet(cocorosim: Run, magic: bytes) -> None:
    """By the four bytes that every such file begins with."""
    Path("x.parquet").write_bytes(magic + b"\x00\x01" * 300)
    sentence = told(cocorosim("diagnose", "x.parquet", "--platform", "lily", "--out", "found"))
    assert f"it is a Parquet file; {BY_GUESS.format('parquet', 'x.parquet')}" in sentence


def test_npz(cocorosim: Run) -> None:
    """A zip archive of arrays is told from others."""
    np.savez("x.npz", t=np.arange(3.0))
    sentence = told(cocorosim("diagnose", "x.npz", "--platform", "lily", "--out", "found"))
    assert f"it is an npz file of NumPy; {BY_GUESS.format('npz', 'x.npz')}" in sentence
    with zipfile.ZipFile("x.zip", "w") as archive:
        archive.writestr("run.csv", TABLE)
    assert "x.zip is not an MCAP file: it is a zip archive; unpack it" in told(cocorosim("metrics", "x.zip"))


@pytest.mark.parametrize("name", ["x.mat", "x.h5"])
@pytest.mark.parametrize("at", [0, 512])
def test_hdf5(cocorosim: Run, name: str, at: int) -> None:
    """The library that opens any of them."""
    Path(name).write_bytes(b"\1" * at + b"\x89HDF\r\n\x1a\n" + bytes(600))
    sentence = told(cocorosim("metrics", name))
    assert (
        "it is an HDF5 file; open it with h5py (`pip install h5py`) and write its columns as CSV or Parquet."
        in sentence
    )


def test_logs_of_autopilots(cocorosim: Run) -> None:
    """A map ships for some."""
    Path("x.BIN").write_bytes(b"\xa3\x95\x80" + bytes(600))
    assert "`cocorosim convert ardusub_dataflash x.BIN --out BAG`" in told(cocorosim("metrics", "x.BIN"))
    Path("x.tlog").write_bytes(bytes(8) + b"\xfd" + bytes(600))
    assert "`cocorosim convert ardusub_tlog x.tlog --out BAG`" in told(cocorosim("metrics", "x.tlog"))


def test_check_has_no_map(cocorosim: Run) -> None:
    """What is said does not speak of one that was given."""
    sentence = told(cocorosim("check", table()))
    assert f"run.csv is not a bag: it is a text table (CSV); {BY_GUESS.format('csv', 'run.csv')}" in sentence
    Path("notes.md").write_text("# Notes\n\nThe water was cold.\nWe went home.\n")
    assert "notes.md is not a bag, and its kind is not known; give the right file" in told(
        cocorosim("check", "notes.md")
    )


def test_a_map_for_another_kind_of_log(cocorosim: Run) -> None:
    """Of a file and of a folder: the map is for bags, and what would be the right one."""
    sentence = told(cocorosim("convert", "odometry_bag", table(), "--out", "made"))
    assert (
        f"run.csv is not a bag, as the map says: it is a text table (CSV); {BY_GUESS.format('csv', 'run.csv')}"
        in sentence
    )
    table("logs/a.csv")
    sentence = told(cocorosim("convert", "odometry_bag", "logs", "--out", "made"))
    beginning = "logs is not a bag, as the map says: it holds a.csv, which is a text table (CSV); "
    assert beginning + BY_GUESS.format("csv", "logs") in sentence
    assert not Path("made").exists()


def test_a_folder_where_a_recording_is_asked_for(cocorosim: Run) -> None:
    """The same of a command without a map; of a folder of something else what is asked for."""
    table("logs/a.csv")
    sentence = told(cocorosim("metrics", "logs"))
    assert (
        f"logs holds no .mcap file; it holds a.csv, which is a text table (CSV); {BY_GUESS.format('csv', 'logs')}"
        in sentence
    )
    Path("notes").mkdir()
    Path("notes/a.md").write_text("# Notes\n")
    assert "notes holds no .mcap file; give a rosbag2 folder or an .mcap file." in told(cocorosim("metrics", "notes"))


def test_what_is_not_known(cocorosim: Run) -> None:
    """No raw bytes."""
    Path("x.dat").write_bytes(b"\x01\x02\x03" * 300)
    sentence = told(cocorosim("metrics", "x.dat"))
    assert "x.dat is not an MCAP file, and its kind is not known; give a rosbag2 folder or an .mcap file" in sentence
    assert "b'" not in sentence


def test_a_table_by_another_name(cocorosim: Run) -> None:
    """A map is guessed by what the file is, so that the way out is no circle."""
    import pandas as pd

    pd.DataFrame({"time": np.arange(9.0), "x": np.arange(9.0), "y": np.arange(9.0)}).to_parquet("run.csv")
    assert cocorosim("convert", "--guess", "run.csv", "--out", "MAP.yaml").status == 0
    assert "format: parquet" in Path("MAP.yaml").read_text()
