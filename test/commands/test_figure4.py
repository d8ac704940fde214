"""`cocorosim figure4` on a factorial of two choices and short runs: stages, page, tree, and going on."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace

import pyarrow.parquet as pq
import pytest

Run = Callable[..., SimpleNamespace]

FACTORIAL = """
name: little
description: four variants for twenty seconds
figure: boids
scenario: eleven_lilys
numerics: paper
seed: 5
screening: {runs: 2}
refining: {runs: 2, rounds: 2}
choosing: {settings: 2, runs: 3}
confirming: {runs: 7}
change: {duration: 20 s, radio: {latency: none}, swarm: {overrides: {cohesion_length: 0.1 m}}}
baseline: Van
groups:
  Van: {description: exact, change: {swarm: {controller: boids_vanilla_released}}}
  BLT: {description: radio, change: {swarm: {controller: boids_blt_released}}}
  BLC: {description: light, change: {swarm: {controller: boids_blc_released}}}
  NA: {description: nothing, change: {swarm: {controller: boids_na_released}}}
factors:
  threshold:
    description: separation begins at 0.3 m, else at 0.15 m
    change: {swarm: {overrides: {separation_threshold: 0.3 m}}}
  deaf:
    description: what is heard counts nothing, else as the paper has it
    groups: [BLT, BLC]
    change: {swarm: {overrides: {alignment_weight: 0}}}
"""


@pytest.fixture(scope="module")
def factorial(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The file above."""
    path = tmp_path_factory.mktemp("figure4") / "little.yaml"
    path.write_text(FACTORIAL, "utf-8")
    return path


def typed(factorial: Path, *more: object) -> tuple[object, ...]:
    """The words of the command."""
    return "figure4", "--run", factorial.parent / "runs", "--factorial", factorial, "--workers", 1, "--json", "-", *more


def test_one_command_makes_the_page_and_goes_on(cocorosim: Run, factorial: Path) -> None:
    """Four settings are screened and refined, one of two confirmed; a second call runs nothing and agrees."""
    page = factorial.parent / "page.md"
    ended = cocorosim(*typed(factorial, "--out", page))
    assert ended.status == 0, ended.err
    tree = json.loads(ended.out)["factorials"][0]
    assert [stage["stage"] for stage in tree["stages"]][:2] == ["screening", "refining_1"]
    assert tree["stages"][-1]["stage"] == "confirming"
    assert {one["setting"] for one in tree["stages"][0]["settings"]} == {"00", "01", "10", "11"}
    text = page.read_text("utf-8")
    best = tree["stages"][-1]["settings"][0]["setting"]
    assert f"The best is `{best}`" in text
    assert all(f"| S{number} | " in text for number in range(1, 19))
    assert all(f"**{name}**: " in text for name in ("threshold", "deaf"))
    confirmed = pq.read_table(factorial.parent / "runs" / "little" / "confirming" / "results.parquet")
    assert confirmed.num_rows == 4 * 7

    again = cocorosim(*typed(factorial))
    assert json.loads(again.out) == json.loads(ended.out)
    assert "exists already" in cocorosim(*typed(factorial, "--out", page)).err


def test_mistakes_are_sentences(cocorosim: Run, tmp_path: Path) -> None:
    """A factorial that does not exist, and no workers."""
    ended = cocorosim("figure4", "--run", tmp_path, "--factorial", "figure5")
    assert (ended.status, "'figure5' is the name of no factorial" in ended.err) == (2, True)
    ended = cocorosim("figure4", "--run", tmp_path, "--workers", 0)
    assert (ended.status, "--workers has 0" in ended.err) == (2, True)
