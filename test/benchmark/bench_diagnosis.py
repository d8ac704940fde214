"""How long a diagnosis takes, stage by stage: ten minutes of one robot, and of three, with the whole catalogue.

Prints processor seconds and seconds on the clock of each stage once all is compiled, on one core; then, where the
machine has several, how long it takes on all of them: robots of a recording then go side by side. Without a BAG the
recordings are made by the concealer, with linear drag that the model lacks.

Usage: python test/benchmark/bench_diagnosis.py [BAG...]
"""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Mapping, Sequence
from pathlib import Path

from conditions import conditions

from cocorosim_ros.diagnosis.diagnose import diagnose
from cocorosim_ros.diagnosis.evidence.gather import gather_evidence
from cocorosim_ros.scenario.parts.platform import load_platform

CONCEALER = Path(__file__).parents[1] / "concealer"
ROBOTS = (1, 3)
SEED = 20261121


class Stages:
    """Processor seconds and seconds on the clock by stage, in the order in which they came."""

    def __init__(self) -> None:
        self.spent: dict[str, tuple[float, float]] = {}
        self._now, self._since = "reading", (time.process_time(), time.perf_counter())

    def begin(self, words: str, share: float = 1.0) -> None:
        """End the stage before, begin the next."""
        processor, clock = self.spent.get(self._now, (0.0, 0.0))
        now = (time.process_time(), time.perf_counter())
        self.spent[self._now] = (processor + now[0] - self._since[0], clock + now[1] - self._since[1])
        self._now, self._since = words, now


def concealed(robots: int, folder: Path) -> Path:
    """A recording of ten rich minutes."""
    out = folder / f"robots_{robots}"
    subprocess.run(
        [
            sys.executable, CONCEALER, "conceal", "--seed", str(SEED), "--count", "1", "--effects", "linear_drag",
            "--size", "0.5", "--noise", "0.01", "--robots", str(robots), "--manoeuvre", "rich", "--out", out,
        ],
        check=True, stdout=subprocess.DEVNULL,
    )  # fmt: skip
    return out / "recordings" / "r0000"


def stages_of(bag: Path) -> tuple[dict[str, tuple[float, float]], str]:
    """What each stage took, and the verdict."""
    stages = Stages()
    evidence = gather_evidence([bag], load_platform("lily"))
    found = diagnose(evidence, stages.begin)
    stages.begin("")
    return stages.spent, found.verdict


def main(bags: Sequence[Path]) -> None:
    """Diagnose each bag, the first one twice: at first it is compiled."""
    print("\n".join(conditions()))
    every = os.sched_getaffinity(0)
    os.sched_setaffinity(0, {min(every)})
    print("on one core, everything compiled; processor seconds (seconds on the clock)")
    stages_of(bags[0])
    for bag in bags:
        spent, verdict = stages_of(bag)
        print(f"{bag}: {verdict}")
        for name, (processor, clock) in spent.items():
            print(f"  {name:44s} {processor:6.2f} ({clock:.2f})")
        print(f"  {'all':44s} {in_all(spent)}")
    os.sched_setaffinity(0, every)
    for bag in bags if len(every) > 1 else ():
        print(f"{bag} on {len(every)} cores: {in_all(stages_of(bag)[0])}")


def in_all(spent: Mapping[str, tuple[float, float]]) -> str:
    """Processor seconds (seconds on the clock) of all stages."""
    processor, clock = (sum(part[index] for part in spent.values()) for index in range(2))
    return f"{processor:6.2f} ({clock:.2f})"


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as made:
        main([Path(name) for name in sys.argv[1:]] or [concealed(robots, Path(made)) for robots in ROBOTS])
