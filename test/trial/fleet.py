"""Arm five: made recordings of a fleet over weeks, of which one robot loses thrust slowly; processes are killed.

The command line is timed from its start to its page. At a tenth of the recordings one of its workers is killed, at the
half the command itself, which is then given again; both count into the time.
"""

from __future__ import annotations

import json
import math
import os
import signal
import statistics
import subprocess
import time
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from concealer.fleet import FleetPlan, make_fleet
from trial.examiner import COMMAND, ONE_THREAD
from trial.provenance import sentence

ASKED_EVERY = 0.5  # s
THRUST = "thrust_gain"


@dataclass(frozen=True)
class Ran:
    """What diagnosing a fleet took and gave."""

    seconds: float
    load: float  # of the machine before the start
    worker_killed: int  # recordings there when a worker was killed; -1 for never
    command_killed: int
    lost: int  # recordings that were there before the command was killed and not after
    said: str


def make(plan: FleetPlan, out: Path, jobs: int) -> Path:
    """The folder of the recordings, made if they are not there."""
    fleet = out / "recordings"
    for number, _ in enumerate(make_fleet(plan, fleet, range(plan.robots * plan.weeks), jobs), start=1):
        if number % 50 == 0:
            print(f"{number} recordings are made", flush=True)
    return fleet


def command(fleet: Path, out: Path, jobs: int) -> subprocess.Popen[str]:
    """The command line, begun."""
    words = [str(COMMAND), "diagnose", "--fleet", str(fleet), "--platform", "lily", "--out", str(out)]
    return subprocess.Popen(
        [*words, "--workers", str(jobs)], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
        env=os.environ | ONE_THREAD,
    )  # fmt: skip


def there(out: Path) -> int:
    """How many recordings have an outcome."""
    return sum(1 for _ in (out / "outcomes").rglob("*.json"))


def until(process: subprocess.Popen[str], out: Path, count: int) -> int:
    """Waits until so many outcomes are there, or the process has ended; how many are."""
    while process.poll() is None and there(out) < count:
        time.sleep(ASKED_EVERY)
    return there(out)


def children(process: subprocess.Popen[str]) -> list[int]:
    """Worker processes: those below the command that have loaded the most."""
    text = Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text()
    size = {int(pid): int(Path(f"/proc/{pid}/statm").read_text().split()[1]) for pid in text.split()}
    return sorted(size, key=lambda pid: -size[pid])


def run(fleet: Path, out: Path, jobs: int, total: int) -> Ran:
    """Diagnoses the fleet with both killings; a fleet that is there already is not timed anew."""
    note = out.with_name("ran.json")
    if note.exists():
        return Ran(**json.loads(note.read_text(encoding="utf-8")))
    load, begun = os.getloadavg()[0], time.monotonic()
    process = command(fleet, out, jobs)
    at_worker = until(process, out, max(1, total // 10))
    os.kill(children(process)[0], signal.SIGKILL)
    at_command = until(process, out, total // 2)
    process.kill()
    process.communicate()
    kept = there(out)
    process = command(fleet, out, jobs)
    said, _ = process.communicate()
    if process.returncode != 0:
        raise ValueError(f"the command ended with status {process.returncode}: {said.strip()[-800:]}")
    ran = Ran(time.monotonic() - begun, load, at_worker, at_command, max(0, at_command - kept), said.strip())
    note.write_text(json.dumps(asdict(ran), indent=1) + "\n", encoding="utf-8")
    return ran


def measure(plan: FleetPlan, out: Path, rows: list[dict[str, Any]], drifts: list[dict[str, Any]]) -> dict[str, Any]:
    """What came out beside what was planned."""
    outcomes = [json.loads(file.read_text(encoding="utf-8")) for file in sorted((out / "outcomes").rglob("*.json"))]
    loser = f"lily_{plan.loser + 1:03d}"
    thrust = {each["robot"]: each["per_week"] for each in drifts if each["parameter"] == THRUST}
    truth = {name: -plan.loss if name == loser else 0.0 for name in thrust}
    held = sum(low <= truth[name] <= high for name, (low, high) in ((n, e["ci95"]) for n, e in thrust.items()))
    named = {(each["robot"], each["parameter"]) for each in drifts if each["drifts"]}
    seconds = [each["seconds"] for each in outcomes]
    processor = [each["processor_seconds"] for each in outcomes]
    verdicts = [row["verdict"] for row in rows]
    return {
        "recordings": len(outcomes),
        "problems": sum(bool(each["problem"]) for each in outcomes),
        "attempts_beyond_one": sum(each["attempts"] > 1 for each in outcomes),
        "seconds_median": statistics.median(seconds),
        "seconds_most": max(seconds),
        "processor_median": statistics.median(processor),
        "processor_all": sum(processor),
        "verdicts": {name: verdicts.count(name) for name in sorted({str(each) for each in verdicts})},
        "tests": len(drifts),
        "loser": {"robot": loser, "planned": -plan.loss, **thrust.get(loser, {})},
        "loser_named": (loser, THRUST) in named,
        "others_named": sorted(f"{robot} {parameter}" for robot, parameter in named if robot != loser),
        "loser_other_numbers": sorted(parameter for robot, parameter in named - {(loser, THRUST)} if robot == loser),
        "intervals_of_thrust": len(thrust),
        "intervals_that_hold": held,
    }


def prove(plan: FleetPlan, out: Path, pages: Path, jobs: int, source: dict[str, Any]) -> int:
    """Makes, diagnoses, measures, writes fleet.md and fleet.json."""
    import pyarrow.parquet as pq

    fleet, found = make(plan, out, jobs), out / "found"
    total = plan.robots * plan.weeks
    ran = run(fleet, found, jobs, total)
    tree = out / "fleet.json"
    tree.unlink(missing_ok=True)
    words = ["diagnose", "--fleet", str(fleet), "--platform", "lily", "--out", str(found), "--json", str(tree)]
    subprocess.run([str(COMMAND), *words], check=True, stdout=subprocess.DEVNULL)
    whole = json.loads(tree.read_text(encoding="utf-8"))
    figures = measure(plan, found, pq.read_table(found / "fleet.parquet").to_pylist(), whole["drifts"])
    facts = {"source": source, "plan": asdict(plan), "jobs": jobs, "ran": asdict(ran), "figures": figures}
    pages.mkdir(parents=True, exist_ok=True)
    (pages / "fleet.json").write_text(json.dumps(facts, indent=1) + "\n", encoding="utf-8")
    text = page(facts, whole["sentence"])
    (pages / "fleet.md").write_text(text, encoding="utf-8")
    print(text)
    return 0


def page(facts: dict[str, Any], headline: str) -> str:
    """fleet.md."""
    plan, ran, found = facts["plan"], facts["ran"], facts["figures"]
    minutes = ran["seconds"] / 60.0
    loser = found["loser"]
    low, high = (100.0 * end for end in loser.get("ci95", (math.nan, math.nan)))
    value = 100.0 * loser.get("value", math.nan)
    others = ", ".join(found["others_named"]) or "none"
    goal = 60.0 * found["recordings"] / 500.0
    rows = [
        ("recordings", f"{found['recordings']} of {plan['duration'] / 60.0:g} minutes, {plan['robots']} robots, "
                       f"{plan['weeks']} weeks"),
        ("without a diagnosis", str(found["problems"])),
        ("time on the clock", f"{minutes:.1f} minutes with {facts['jobs']} processes; must be {goal:.0f}"),
        ("one recording", f"{found['seconds_median']:.1f} s on the clock (median; {found['seconds_most']:.1f} s at "
                          f"most), {found['processor_median']:.1f} s of one processor (median)"),
        ("500 such recordings", f"{found['processor_all'] / found['recordings'] * 500.0 / 120.0:.0f} minutes of two "
                                "processors that do nothing else; must be 60"),
        ("a worker killed", f"at {ran['worker_killed']} recordings; {found['attempts_beyond_one']} diagnosed again"),
        ("the command killed", f"at {ran['command_killed']} recordings; {ran['lost']} of these lost"),
        ("the page says", headline.replace("\u00a0", " ")),
        ("planned", f"{loser['robot']} loses {100.0 * plan['loss']:g} % of its thrust a week"),
        ("found", f"{value:+.2f} % a week (95 %: {low:+.2f} to {high:+.2f})"),
        ("other robots named", f"{others}, of {found['tests']} tests"),
        ("95 % intervals of the thrust's drift", f"{found['intervals_that_hold']} of {found['intervals_of_thrust']} "
                                                 "hold the planned one"),
        ("verdicts", ", ".join(f"{count} {name}" for name, count in found["verdicts"].items())),
    ]  # fmt: skip
    table = "\n".join(f"| {name} | {words} |" for name, words in rows)
    spread, scatter, noise = (f"{100.0 * plan[name]:g} %" for name in ("spread", "scatter", "noise"))
    source = facts["source"]
    return f"""# A fleet

Recordings made by the Concealer's own physics (`test/concealer/fleet.py`): every robot has numbers of its own, up to
{spread} off the platform's, which differ by {scatter} from day to day; the water pushes at random with {noise} of the
thrust. One robot loses thrust slowly. No effect is hidden: a `mismatch` is a false alarm.

| | |
|---|---|
{table}

{sentence(source)}
Conditions: {source["machine"]}, Python {source["python"]}; load of the machine before the start {ran["load"]:.1f}.
"""
