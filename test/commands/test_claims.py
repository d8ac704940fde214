"""`cocorosim claims` and `cocorosim report`: what they refuse, and a small study from end to end."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace

import pytest

Run = Callable[..., SimpleNamespace]


def test_nothing_to_hold_them_against(cocorosim: Run, tmp_path: Path) -> None:
    """Neither results nor --run, or both."""
    for arguments in ((), (tmp_path, "--run", tmp_path)):
        ended = cocorosim("claims", *arguments)
        assert ended.status == 2 and "either RESULTS" in ended.err


def test_pages_are_not_overwritten(cocorosim: Run, tmp_path: Path) -> None:
    """A page that is there stays as it is without --force."""
    page = tmp_path / "page.md"
    page.write_text("mine", "utf-8")
    assert "exists already" in cocorosim("claims", tmp_path, "--out", page).err
    assert page.read_text("utf-8") == "mine"


def test_results_of_another_design(cocorosim: Run, tmp_path: Path) -> None:
    """Results of a design that no claim is about."""
    options = ("--replicates", 1, "--numerics", "paper", "--workers", 1)
    assert cocorosim("experiment", "smoke", "--out", tmp_path / "smoke", *options).status == 0
    ended = cocorosim("claims", tmp_path / "smoke")
    assert ended.status == 2 and "'smoke'" in ended.err
    report = cocorosim("report", tmp_path / "smoke", "--table", tmp_path / "smoke.csv")
    assert report.status == 0 and (tmp_path / "smoke.csv").read_text("utf-8").startswith("design,numerics,group")
    assert "exists already" in cocorosim("report", tmp_path / "smoke").err


def test_one_command_makes_the_page(cocorosim: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """With --run the designs run first; here the small one stands for them, asked of nobody."""
    from cocorosim_ros.analysis import all_claims

    monkeypatch.setattr(all_claims, "STUDIES", ("smoke",))
    monkeypatch.setattr(all_claims, "all_answers", lambda experiments: [])
    ended = cocorosim("claims", "--run", tmp_path / "runs", "--replicates", 1, "--out", tmp_path / "claims.md")
    assert ended.status == 0, ended.err
    assert "| `smoke` | 1 |" in (tmp_path / "claims.md").read_text("utf-8")
