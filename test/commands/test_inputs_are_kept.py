"""No command writes over what it reads, with --force neither."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace

import pytest

Command = Callable[..., SimpleNamespace]


@pytest.fixture
def files(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> dict[Path, bytes]:
    """Contents by path of a recording, a run, a log with its map and a diagnosis, as far as they are looked at."""
    monkeypatch.chdir(tmp_path)
    names = ("bag/x.mcap", "bag/metadata.yaml", "run/bag/x.mcap", "log.csv", "map.yaml", "logs/a.csv", "q1/model.yaml")
    for name in names:
        Path(name).parent.mkdir(parents=True, exist_ok=True)
        Path(name).write_bytes(b"t,x,y\n0,1,2\n1,2,3\n")
    Path("q1/model.yaml").write_text("name: mine\ndescription: a Lily\nbased_on: lily\n")
    Path("map.yaml").write_text(
        "name: m\nformat: csv\ntables:\n  - files: '*.csv'\n    time: {column: t, unit: s}\n    robot: boat\n"
        "    streams: {compass: {heading: {column: x, unit: rad}}}\n"
    )
    return {Path(name): Path(name).read_bytes() for name in names}


@pytest.mark.parametrize(
    ("line", "told"),
    [
        ("convert --guess log.csv --out log.csv", "log.csv is read by this command (log.csv)"),
        ("convert --guess logs --out logs/a.csv", "logs/a.csv is a part of logs"),
        ("convert --guess bag --out bag/metadata.yaml", "bag/metadata.yaml is a part of bag"),
        ("convert map.yaml log.csv --out out --json log.csv", "log.csv is read"),
        ("convert map.yaml log.csv --out out --json map.yaml", "map.yaml is read"),
        ("convert map.yaml logs --out logs", "logs is read"),
        ("diagnose bag --platform lily --out out --json bag/x.mcap", "bag/x.mcap is a part of bag"),
        ("diagnose run --platform lily --out out --json run/bag/x.mcap", "is a part of run/bag"),
        ("diagnose bag --platform q1/model.yaml --out out --markdown q1/model.yaml", "q1/model.yaml is read"),
        ("diagnose bag --platform q1/model.yaml --out out --json q1/model.yaml", "q1/model.yaml is read"),
        ("diagnose bag --platform lily --known q1/model.yaml --out out --junit q1/model.yaml", "q1/model.yaml is read"),
        ("diagnose bag --platform q1/model.yaml --out q1", "q1 holds q1/model.yaml"),
        ("diagnose bag --platform lily --out bag", "bag holds 'metadata.yaml', which is no part of a diagnosis"),
        ("diagnose --fleet . --platform q1/model.yaml --out q1", "q1 holds q1/model.yaml"),
        ("view bag --out bag/x.mcap", "bag/x.mcap is a part of bag"),
        ("view run --out run/bag/x.mcap", "is a part of run/bag"),
        ("view bag/x.mcap --out bag/x.mcap", "bag/x.mcap is read"),
        ("check bag --json bag/x.mcap", "is a part of bag"),
        ("metrics bag --picture bag/x.mcap", "is a part of bag"),
        ("digest bag --json bag/x.mcap", "is a part of bag"),
        ("calibrate bag --platform q1/model.yaml --out q1/model.yaml", "q1/model.yaml is read"),
        ("new platform mine --for bag --out bag/x.mcap", "is a part of bag"),
    ],
)
def test_an_input_is_refused(cocorosim: Command, files: dict[Path, bytes], line: str, told: str) -> None:
    """The sentence says which, and what is read stays as it was."""
    done = cocorosim(*line.split(), "--force")
    assert (done.status, files) == (2, {path: path.read_bytes() for path in files}), done.err
    assert told in done.err
    assert "even with --force;" in done.err


def test_a_map_and_a_recording_beside_tables(cocorosim: Command, files: dict[Path, bytes]) -> None:
    """Work in the folder of the log goes on as it did, also a second time."""
    for _ in range(2):
        assert cocorosim("convert", "map.yaml", "logs", "--out", "logs/bag", "--force").status == 0
    Path("logs/old.yaml").write_text("")
    done = cocorosim("convert", "--guess", "logs", "--out", "logs/old.yaml", "--force")
    assert "is read" not in done.err
