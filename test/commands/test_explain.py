"""`cocorosim explain`: what people and programs read of a key."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

Run = Callable[..., SimpleNamespace]


def test_one_key(cocorosim: Run) -> None:
    """Meaning, form, default, where it stands and what uses it, each on a line of its own, never broken."""
    done = cocorosim("explain", "lockstep.patience")
    assert done.status == 0, done.err
    lines = done.out.splitlines()
    assert lines[0] == "lockstep.patience, key of a scenario"
    assert "  form: time [s], greater than zero" in lines
    assert "  default: 10.0 s" in lines
    assert any(line.startswith("  used by: ") and "physics_shell.py" in line for line in lines)
    assert "\x1b" not in done.out


def test_the_same_for_programs(cocorosim: Run, tmp_path: Path) -> None:
    """JSON on standard output is nothing but JSON; into a file it is the same, and never replaces one unasked."""
    told = cocorosim("explain", "polarisation", "--json", "-")
    (found,) = json.loads(told.out)["explanations"]
    assert (found["name"], found["kind"], found["facts"]["unit"]) == ("polarisation", "metric", "1")
    file = tmp_path / "explained.json"
    assert cocorosim("explain", "polarisation", "--json", file).status == 0
    assert file.read_text() == told.out
    again = cocorosim("explain", "polarisation", "--json", file)
    assert again.status == 2
    assert "--force" in again.err


def test_all_that_there_is(cocorosim: Run) -> None:
    """Without a key everything is listed."""
    listed: Any = json.loads(cocorosim("explain", "--json", "-").out)["explanations"]
    kinds = {each["kind"] for each in listed}
    assert {"key of a scenario", "key of a platform", "key of a map", "effect", "metric", "topic"} <= kinds


def test_the_catalogue_alone(cocorosim: Run) -> None:
    """Below the key itself a row for each entry, with its name and what it is, and for nothing else."""
    done = cocorosim("explain", "effects")
    assert done.status == 0, done.err
    lines = done.out.splitlines()
    assert lines[0] == "effects, key of a platform"
    rows = [[cell.strip() for cell in line.strip("\u2502").split("\u2502")] for line in lines if line[0] == "\u2502"]
    assert ["wall_effect", "effect", "drag that grows near walls"] in rows
    assert ["pressure_offset", "error of a sensor", "pressure reading that is shifted"] in rows
    assert {kind for _, kind, _ in rows} == {"effect", "error of a sensor"}
    listed = json.loads(cocorosim("explain", "effects", "--json", "-").out)["explanations"]
    assert [each["name"] for each in listed] == ["effects", *(name for name, _, _ in rows)]


def test_a_name_that_there_is_not(cocorosim: Run) -> None:
    """One sentence with the nearest name, status 2."""
    done = cocorosim("explain", "patiense")
    assert done.status == 2
    assert "did you mean patience" in done.err
