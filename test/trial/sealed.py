"""Arm one: recordings with something concealed. Generates, seals, diagnoses, opens, scores."""

from __future__ import annotations

import hashlib
import json
import os
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

from trial.examiner import Outcome, Task, Terms, examine_all
from trial.parts import Part
from trial.provenance import ROOT

CONCEALER = ROOT / "test" / "concealer"
LEDGER = "ledger.json"
LILYS = Part("main", 1)


def concealer(*words: str) -> None:
    """Runs the Concealer, which is a program of its own. Raises CalledProcessError if it fails."""
    subprocess.run(["nice", "-n", "10", sys.executable, str(CONCEALER), *words], check=True, stdout=subprocess.DEVNULL)


def conceal(out: Path, part: Part, seed: int, jobs: int) -> Path:
    """The folder of a part, made and sealed unless it is there; another seed for each part."""
    folder = out / "trial" / part.name
    if not (folder / LEDGER).exists():
        draft = folder.with_name(f"{part.name}.{os.getpid()}.unfinished")
        own = str((seed + int.from_bytes(hashlib.sha256(part.name.encode()).digest()[:4], "big")) % 2**63)
        concealer(
            "conceal", "--seed", own, "--count", str(part.count), "--out", str(draft), "--jobs", str(jobs), *part.words
        )
        draft.rename(folder)
    return folder


def short_diagnosis(out: Path, part: Part = LILYS) -> Task:
    """The diagnosis of half a minute of a part's vehicle that is no part of the trial: to load the tool with."""
    folder = out / "warm_up"
    if not (folder / LEDGER).exists():
        words = (*part.words, "--kind", "nothing", "--robots", "1", "--duration", "30")
        concealer("conceal", "--seed", "0", "--count", "1", "--out", str(folder), *words)
    return Task("warm_up", (folder / "recordings" / "r0000",), folder / "diagnosis", part.platform)


def tasks(out: Path, folder: Path, platform: str = "lily") -> list[Task]:
    """One diagnosis for each recording of a part, of robots of a platform."""
    names = sorted(json.loads((folder / LEDGER).read_text(encoding="utf-8"))["recordings"])
    answers = out / "diagnoses" / folder.name
    return [Task(f"{folder.name}/{name}", (folder / "recordings" / name,), answers / name, platform) for name in names]


def digests(folders: list[Path]) -> dict[str, str]:
    """SHA-256 of each part's ledger: what is published before the tool runs."""
    return {folder.name: hashlib.sha256((folder / LEDGER).read_bytes()).hexdigest() for folder in folders}


def shuffled_evenly(parts: list[list[Task]]) -> list[Task]:
    """Tasks of all parts in an order in which every part is equally far at any time.

    Recordings are drawn independently, so whatever is done of them when time is up is a fair sample.
    """
    placed = [((k + 0.5) / len(part), task) for part in parts for k, task in enumerate(part)]
    return [task for _, task in sorted(placed, key=lambda entry: entry[0])]


def diagnose(todo: list[Task], terms: Terms) -> list[Outcome]:
    """All outcomes; says how far it is."""
    begun, done = time.monotonic(), []
    for outcome in examine_all(todo, terms):
        done.append(outcome)
        word = {0: "done", None: "OUT OF TIME"}.get(outcome.status, f"status {outcome.status}")
        why = f"  {outcome.said.splitlines()[-1]}" if outcome.status != 0 and outcome.said else ""
        spent = time.monotonic() - begun
        print(
            f"{len(done)}/{len(todo)}  {spent:.0f} s  {outcome.name}: {word}, {outcome.seconds:.1f} s{why}", flush=True
        )
    return done


def score(out: Path, outcomes: list[Outcome], window: float) -> dict[str, Any]:
    """All figures of what was tried, by the Scorer, which is a program of its own too."""
    target, tried = out / f"scores-{time.time_ns()}", out / "tried.txt"
    tried.write_text("".join(f"{outcome.name}\n" for outcome in outcomes), encoding="utf-8")
    words = ["--out", str(target), "--window", str(window), "--tried", str(tried)]
    concealer("score", str(out / "trial"), str(out / "diagnoses"), *words)
    return {
        "figures": json.loads((target / "scores.json").read_text(encoding="utf-8")),
        "text": (target / "scores.md").read_text(encoding="utf-8"),
    }
