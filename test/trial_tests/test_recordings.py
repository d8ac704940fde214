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
