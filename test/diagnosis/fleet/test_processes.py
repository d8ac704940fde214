"""Work in processes that may be killed: only the job that a process had is tried again, and given up when it kills two.

The work is `eval` of a text, which any process knows.
"""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from cocorosim_ros.diagnosis.fleet import processes
from cocorosim_ros.diagnosis.fleet.processes import in_processes
from cocorosim_ros.foundation.errors import CocorosimError

KILLED = "__import__('os').kill(__import__('os').getpid(), 9)"


def always() -> bool:
    """Go on."""
    return True


@pytest.mark.parametrize("workers", [1, 3])
def test_every_job_is_done_once(workers: int) -> None:
    """Whatever the number of processes."""
    done = list(in_processes(eval, [f"{k} * {k}" for k in range(7)], workers, always))
    assert sorted((each.result, each.attempts, each.ended) for each in done) == [(k * k, 1, "") for k in range(7)]


def test_a_job_that_kills_its_process_is_given_up_alone() -> None:
    """It is tried twice, said how it ended, and every other job is done in the first attempt."""
    jobs = ["1", KILLED, "2", "3", "__import__('os')._exit(7)", "4"]
    done = {each.job: each for each in in_processes(eval, jobs, 2, always)}
    assert len(done) == len(jobs)
    assert [done[job].result for job in ("1", "2", "3", "4")] == [1, 2, 3, 4]
    assert {done[job].attempts for job in ("1", "2", "3", "4")} == {1}
    for job, ended in ((jobs[1], "was killed by SIGKILL"), (jobs[4], "ended with status 7")):
        assert (done[job].result, done[job].attempts, done[job].ended) == (None, 2, ended)


def test_a_job_that_is_killed_once_is_done_by_the_next(tmp_path: Path) -> None:
    """As when the machine was out of memory for a moment."""
    mark = tmp_path / "mark"
    job = f"5 if __import__('os').path.exists({str(mark)!r}) else (open({str(mark)!r}, 'w').close(), {KILLED})"
    (done,) = in_processes(eval, [job], 1, always)
    assert (done.result, done.attempts, done.ended) == (5, 2, "was killed by SIGKILL")


def test_processes_that_go_on_dying_end_it(monkeypatch: pytest.MonkeyPatch) -> None:
    """With nothing finished between, a sentence names the option."""
    monkeypatch.setattr(processes, "PROCESSES", processes.PROCESSES.__class__(deaths_in_a_row=3))
    with pytest.raises(CocorosimError, match="3 worker processes died one after the other") as error:
        list(in_processes(eval, [KILLED] * 4, 1, always))
    assert "'workers'" in str(error.value)


def test_an_interruption_ends_the_processes() -> None:
    """What is running is lost, and no process is left."""
    answers = iter([True, True, False])
    began = time.monotonic()
    assert list(in_processes(eval, ["__import__('time').sleep(60)"] * 3, 2, lambda: next(answers))) == []
    assert time.monotonic() - began < 30
    assert not [child for child in children_of(os.getpid()) if "spawn_main" in child.line]


def test_processes_end_with_the_one_that_started_them(tmp_path: Path) -> None:
    """SIGKILL of the command leaves no process that works on."""
    program = (
        "from cocorosim_ros.diagnosis.fleet.processes import in_processes\n"
        "if __name__ == '__main__':\n"
        "    list(in_processes(eval, ['__import__(\"time\").sleep(300)'], 1, lambda: True))\n"
    )
    file = tmp_path / "program.py"
    file.write_text(program, "utf-8")
    command = subprocess.Popen([sys.executable, str(file)])
    workers = wait_for(lambda: [each for each in children_of(command.pid) if "spawn_main" in each.line])
    command.send_signal(signal.SIGKILL)
    command.wait()
    wait_for(lambda: [True] if not any(map(is_running, workers)) else [])


def children_of(pid: int) -> list[Any]:
    """Processes below one, with their command lines."""
    try:
        pids = Path(f"/proc/{pid}/task/{pid}/children").read_text().split()
        return [SimpleNamespace(pid=each, line=Path(f"/proc/{each}/cmdline").read_text()) for each in pids]
    except FileNotFoundError:
        return []


def is_running(process: Any) -> bool:
    """Whether it works on; where nothing waits for it, an ended one stays in the list of processes."""
    try:
        return Path(f"/proc/{process.pid}/stat").read_text().rpartition(")")[2].split()[0] not in "ZX"
    except (FileNotFoundError, ProcessLookupError):
        return False


def wait_for(found: Any) -> list[Any]:
    """What is found in the end."""
    deadline = time.monotonic() + 120
    while not (there := found()):
        assert time.monotonic() < deadline
        time.sleep(0.05)
    return list(there)
