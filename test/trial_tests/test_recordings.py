"""How real recordings are made of the logs of others."""

from __future__ import annotations

from pathlib import Path

import pytest


def test_parts_of_a_crossing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Every log is cut at the same seconds of a clock whose fractions have lost their zeros; each part has its head."""
    from trial import recordings

    monkeypatch.setattr(recordings, "converted", lambda vehicle, logs, out: sorted(logs.iterdir()))
    trial = tmp_path / "data" / "milliampere_ferry" / "t"
    trial.mkdir(parents=True)
    rows = [f"2025/04/11 11:59:{second}.{fraction},1\n" for second in (57, 58, 59) for fraction in (99, 5)]
    (trial / "log.csv").write_text("".join(["time,x\n", *rows, "2025/04/11 12:00:00.1,1\n"]))
    parts = recordings.crossings(tmp_path / "data", tmp_path / "out", "t", "2025/04/11 11:59:58", 1, 2)
    assert [part.name for part in parts] == ["t_0", "t_1"]
    assert [(part / "log.csv").read_text() for part in parts] == [
        "".join(["time,x\n", *rows[2:4]]), "".join(["time,x\n", *rows[4:]])
    ]  # fmt: skip


def test_an_interrupted_cut_is_begun_again(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Parts are there when all of them are; a log without a line is cut to ones without a line."""
    from trial import recordings

    monkeypatch.setattr(recordings, "converted", lambda vehicle, logs, out: sorted(logs.iterdir()))
    trial = tmp_path / "data" / "milliampere_ferry" / "t"
    trial.mkdir(parents=True)
    (trial / "a.csv").write_text("time,x\n2025/04/11 12:00:00.1,1\n")
    (trial / "b.csv").write_bytes(b"\xff")
    call = (tmp_path / "data", tmp_path / "out", "t", "2025/04/11 12:00:00", 1, 2)
    with pytest.raises(UnicodeDecodeError):
        recordings.crossings(*call)
    (trial / "b.csv").write_text("")
    parts = recordings.crossings(*call)
    assert [[path.name for path in sorted(part.iterdir())] for part in parts] == [["a.csv", "b.csv"]] * 2
    assert [(part / "a.csv").read_text().count("\n") for part in parts] == [2, 1]
    assert [(part / "b.csv").read_text() for part in parts] == ["", ""]
    assert sorted(path.name for path in (tmp_path / "out").iterdir()) == ["milliampere_t_logs"]
