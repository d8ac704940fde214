"""`python test/guard/fingerprints.py take | compare`: whether a change of the code leaves every result as it was.

`take` runs the commands of a checkout and writes the SHA-256 of all that they give: digest and statistics of every
shipped scenario, rows of the designs, diagnosis.json and model.yaml of sealed and of real recordings. `compare` says
where two such files differ. The package that is imported is the one that PYTHONPATH names first, so that one virtual
environment serves two checkouts:

    python test/concealer conceal --seed 60 --count 60 --out SEALED
    PYTHONPATH=../before python test/guard/fingerprints.py take --sealed SEALED --data FOLDER --out before.json
    PYTHONPATH=.         python test/guard/fingerprints.py take --sealed SEALED --data FOLDER --out after.json
    python test/guard/fingerprints.py compare before.json after.json
"""

from __future__ import annotations

import argparse
import hashlib
import json
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path

FOLDER = str(Path(__file__).resolve().parents[1])
if FOLDER not in sys.path:
    sys.path.append(FOLDER)

from trial.examiner import COMMAND, Task, Terms, examine_all  # noqa: E402
from trial.real import groups  # noqa: E402
from trial.sealed import short_diagnosis  # noqa: E402

ROOT = Path(__file__).resolve().parents[2]
DESIGNS = ("boids", "turbulence")
CODE_VERSION = "version"  # column of a row that is meant to change with the code
Fingerprints = dict[str, str]


def fingerprint(content: bytes) -> str:
    """First 16 hex digits of the SHA-256."""
    return hashlib.sha256(content).hexdigest()[:16]


def cocorosim(*words: str) -> None:
    """Runs the command; raises CalledProcessError with its words on standard error if it fails."""
    subprocess.run([str(COMMAND), *words], check=True, stdout=subprocess.DEVNULL)


def scenario_fingerprints(scratch: Path, share: float) -> Iterator[tuple[str, str]]:
    """Digest of the bag and statistics of every shipped scenario; share: of its duration, at least ten ticks."""
    from cocorosim_ros import __file__ as package

    for path in sorted((Path(package).parents[1] / "config" / "scenarios").glob("*.yaml")):
        folder = scratch / path.stem
        duration = ["--duration", f"{max(10, round(100 * share))} s"] if share < 1.0 else []
        cocorosim("run", str(path), "--in-process", "--out", str(folder), *duration)
        yield f"scenario/{path.stem}/metrics", fingerprint((folder / "metrics.json").read_bytes())
        said = subprocess.run([str(COMMAND), "digest", str(folder / "bag")], capture_output=True, text=True, check=True)
        yield f"scenario/{path.stem}/digest", said.stdout.split()[0]


def design_fingerprints(scratch: Path, replicates: int) -> Iterator[tuple[str, str]]:
    """Every column of the rows of both designs, but for the version of the code and the time that was taken."""
    import pyarrow.parquet as pq

    for design in DESIGNS:
        folder = scratch / design
        cocorosim("experiment", design, "--replicates", str(replicates), "--workers", "2", "--out", str(folder))
        table = pq.read_table(folder / "results.parquet")
        for column in table.column_names:
            if column not in (CODE_VERSION, "wall_seconds", "seconds"):
                values = json.dumps([repr(value) for value in table[column].to_pylist()])
                yield f"design/{design}/{column}", fingerprint(values.encode())


def diagnosis_tasks(sealed: Path, data: Path | None, scratch: Path, count: int) -> list[Task]:
    """Diagnoses of so many sealed recordings and, where `data` holds them, of the real sets."""
    bags = sorted((sealed / "recordings").iterdir())[:count]
    tasks = [Task(f"sealed/{bag.name}", (bag,), scratch / "sealed" / bag.name) for bag in bags]
    for pair in groups(data, scratch / "converted") if data else []:
        for group in pair:
            tasks.append(Task(f"real/{group.name}", group.bags, scratch / "real" / group.name, group.platform))
    return tasks


def diagnosis_fingerprints(tasks: list[Task], scratch: Path, limit: float) -> Iterator[tuple[str, str]]:
    """Exit status of each diagnosis, and the bytes of its machine-readable files."""
    terms = Terms(jobs=2, limit=limit, warm_up=short_diagnosis(scratch))
    by_name = {task.name: task for task in tasks}
    for outcome in examine_all(tasks, terms):
        yield f"diagnosis/{outcome.name}/status", str(outcome.status)
        for file in sorted(by_name[outcome.name].out.glob("*.[jy][sa]*")):
            yield f"diagnosis/{outcome.name}/{file.name}", fingerprint(file.read_bytes())


def take(options: argparse.Namespace) -> int:
    """Writes the fingerprints of the checkout that is imported."""
    found: Fingerprints = {}
    with tempfile.TemporaryDirectory(prefix="fingerprints_") as folder:
        scratch = Path(folder)
        parts: dict[str, Callable[[], Iterator[tuple[str, str]]]] = {
            "scenarios": lambda: scenario_fingerprints(scratch / "scenarios", options.share),
            "designs": lambda: design_fingerprints(scratch / "designs", options.replicates),
            "diagnoses": lambda: diagnosis_fingerprints(
                diagnosis_tasks(options.sealed, options.data, scratch, options.count), scratch, options.limit
            ),
        }
        for part in options.parts.split(","):
            for key, value in parts[part]():
                print(f"{value}  {key}", flush=True)
                found[key] = value
    options.out.write_text(json.dumps(found, indent=1, sort_keys=True) + "\n", encoding="utf-8")
    return 0


def differences(before: Fingerprints, after: Fingerprints) -> list[str]:
    """One line for every result that both have and that is not the same, and for every one that went missing."""
    changed = [f"changed  {key}" for key in sorted(before.keys() & after.keys()) if before[key] != after[key]]
    return changed + [f"missing  {key}" for key in sorted(before.keys() - after.keys())]


def compare(options: argparse.Namespace) -> int:
    """Says where two files of fingerprints differ; 1 if they do. `--some`: only what the second one has."""
    before, after = (json.loads(path.read_text(encoding="utf-8")) for path in (options.before, options.after))
    if options.some:
        before = {key: value for key, value in before.items() if key in after}
    lines = differences(before, after)
    print("\n".join(lines) if lines else f"{len(before)} results are the same to the byte")
    return int(bool(lines))


def parser() -> argparse.ArgumentParser:
    """The parser of the command line."""
    whole = argparse.ArgumentParser(prog="fingerprints.py", description=__doc__.split("\n\n")[0])
    commands = whole.add_subparsers(required=True)
    taking = commands.add_parser("take", help="run everything and write the fingerprints")
    taking.add_argument("--out", type=Path, required=True, help="file of fingerprints to write")
    taking.add_argument("--sealed", type=Path, required=True, help="folder that the Concealer made")
    taking.add_argument("--data", type=Path, help="folder with hovercraft_epfl and haizhe_auv")
    taking.add_argument("--count", type=int, default=60, help="sealed recordings")
    taking.add_argument("--replicates", type=int, default=10, help="runs of each group of the designs")
    taking.add_argument("--share", type=float, default=1.0, help="below 1: seconds of each scenario, of a hundred")
    taking.add_argument("--limit", type=float, default=600.0, help="time for one diagnosis [s]")
    taking.add_argument("--parts", default="scenarios,designs,diagnoses")
    taking.set_defaults(run=take)
    comparing = commands.add_parser("compare", help="say where two files of fingerprints differ")
    comparing.add_argument("before", type=Path)
    comparing.add_argument("after", type=Path)
    comparing.add_argument("--some", action="store_true", help="only results that the second file has")
    comparing.set_defaults(run=compare)
    return whole


if __name__ == "__main__":
    arguments = parser().parse_args()
    sys.exit(arguments.run(arguments))
