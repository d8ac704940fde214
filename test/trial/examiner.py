"""Runs `cocorosim diagnose` on many recordings, each in a process of its own: resumable, with a time limit."""

from __future__ import annotations

import json
import math
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterable, Iterator
from concurrent.futures import ThreadPoolExecutor, as_completed
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from queue import SimpleQueue
from typing import Any

COMMAND = Path(sys.executable).with_name("cocorosim")
ONE_THREAD = {f"{name}_NUM_THREADS": "1" for name in ("OMP", "OPENBLAS", "MKL", "NUMBA")}


@dataclass(frozen=True)
class Task:
    """One diagnosis to be made: recordings, platform, and the folder DIR of its answer."""

    name: str
    bags: tuple[Path, ...]
    out: Path
    platform: str = "lily"
    against: tuple[Path, ...] = ()  # recordings of the same vehicle when it was well

    @property
    def outcome(self) -> Path:
        """Where it is noted how the command ended."""
        return self.out.with_name(self.out.name + ".outcome.json")

    @property
    def words(self) -> list[str]:
        """The command line."""
        bags = map(str, self.bags)
        compared = ["--against", *map(str, self.against)] if self.against else []
        return [str(COMMAND), "diagnose", *bags, *compared, "--platform", self.platform, "--out", str(self.out)]


@dataclass(frozen=True)
class Outcome:
    """How a diagnosis ended; what was said on standard error, its end."""

    name: str
    status: int | None  # None: out of time
    seconds: float
    said: str


def _ended(task: Task, limit: float) -> tuple[int | None, str]:
    """Exit status and standard error of the command; all of its processes are stopped at the limit [s]."""
    process = subprocess.Popen(
        ["nice", "-n", "10", *task.words], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
        env=os.environ | ONE_THREAD, start_new_session=True,
    )  # fmt: skip
    try:
        _, said = process.communicate(timeout=limit)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        process.communicate()
        return None, f"no answer within {limit:g} s"
    return process.returncode, said


@dataclass(frozen=True)
class Terms:
    """How diagnoses are run."""

    jobs: int = 2  # at a time
    limit: float = 120.0  # s, for one
    minutes: float = math.inf  # in all; what has not begun by then is left untried
    keep_reports: bool = False
    warm_up: Task | None = None  # a diagnosis to load the tool with, once: warm.py then forks for every other


class WarmTool:
    """A process of warm.py."""

    def __init__(self, warm_up: Task) -> None:
        self._scratch = Path(tempfile.mkdtemp(prefix="warm_tool_"))
        self._process = subprocess.Popen(
            ["nice", "-n", "10", sys.executable, str(Path(__file__).with_name("warm.py"))],
            stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, env=os.environ | ONE_THREAD,
        )  # fmt: skip
        self._ask({"warm_up": replace(warm_up, out=self._scratch / "warm_up").words[1:]})

    def _ask(self, request: dict[str, Any]) -> dict[str, Any]:
        assert self._process.stdin and self._process.stdout
        self._process.stdin.write(json.dumps(request) + "\n")
        self._process.stdin.flush()
        return dict(json.loads(self._process.stdout.readline()))

    def ended(self, task: Task, limit: float) -> tuple[int | None, str]:
        """Exit status and standard error of the command."""
        said = self._scratch / "said.txt"
        reply = self._ask({"words": task.words[1:], "limit": limit, "said": str(said)})
        if reply["status"] is None:
            return None, f"no answer within {limit:g} s"
        return reply["status"], said.read_text(encoding="utf-8", errors="replace")

    def close(self) -> None:
        """Ends the process."""
        self._process.communicate()
        shutil.rmtree(self._scratch, ignore_errors=True)


def examine(task: Task, terms: Terms, tools: SimpleQueue[WarmTool]) -> Outcome:
    """Makes one diagnosis, or returns how it ended before."""
    if task.outcome.exists():
        return Outcome(**json.loads(task.outcome.read_text(encoding="utf-8")))
    shutil.rmtree(task.out, ignore_errors=True)
    task.out.parent.mkdir(parents=True, exist_ok=True)
    begun = time.monotonic()
    if terms.warm_up is None:
        status, said = _ended(task, terms.limit)
    else:
        tool = tools.get()
        status, said = tool.ended(task, terms.limit)
        tools.put(tool)
    outcome = Outcome(task.name, status, round(time.monotonic() - begun, 2), said.strip()[-800:])
    if status != 0:
        shutil.rmtree(task.out, ignore_errors=True)
    elif not terms.keep_reports:
        for page in task.out.glob("*.html"):
            page.unlink()
    task.outcome.write_text(json.dumps(asdict(outcome)) + "\n", encoding="utf-8")
    return outcome


def examine_all(tasks: Iterable[Task], terms: Terms) -> Iterator[Outcome]:
    """Outcomes as they come; what has an outcome already is not done again."""
    end = time.monotonic() + 60.0 * terms.minutes

    def work(task: Task) -> Outcome | None:
        if time.monotonic() > end and not task.outcome.exists():
            return None
        return examine(task, terms, tools)

    tools: SimpleQueue[WarmTool] = SimpleQueue()
    warm = [WarmTool(terms.warm_up) for _ in range(terms.jobs)] if terms.warm_up else []
    for tool in warm:
        tools.put(tool)
    with ThreadPoolExecutor(terms.jobs) as pool:
        waiting = [pool.submit(work, task) for task in tasks]
        try:
            for done in as_completed(waiting):
                if (outcome := done.result()) is not None:
                    yield outcome
        except BaseException:
            pool.shutdown(wait=False, cancel_futures=True)
            raise
        finally:
            for tool in warm:
                tool.close()
