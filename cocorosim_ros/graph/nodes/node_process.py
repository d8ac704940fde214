"""One process of a node graph: forked, with its words in a log file, ended with its parent at the latest."""

from __future__ import annotations

import multiprocessing
import os
import signal
import sys
import traceback
from collections.abc import Callable
from multiprocessing.context import ForkProcess
from pathlib import Path

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.graph.nodes.complaints import WARNING
from cocorosim_ros.graph.nodes.node_shell import end_with_parent, show_as
from cocorosim_ros.graph.runs.run_error import RunError

DONE, FAILED = 0, 1
RUN_FAILED = 3  # the node has said why the whole run cannot go on


class NodeProcess:
    """A node that lives in a fork of this process."""

    def __init__(self, name: str, life: Callable[[], None], log: Path, *, closes_files: bool = False) -> None:
        """`closes_files`: it is asked to end when its supervisor dies, so that it can; others are killed then."""
        self.name = name
        self._log = log
        self._read = 0
        log.write_bytes(b"")
        context = multiprocessing.get_context("fork")
        at_orphaning = signal.SIGTERM if closes_files else signal.SIGKILL
        # The robot's own part of the name, which would not fit behind `controller_`.
        arguments = (life, log, os.getpid(), at_orphaning, name.removeprefix("controller_"))
        self.process: ForkProcess = context.Process(target=_live, args=arguments, name=name, daemon=True)
        self.process.start()

    @property
    def failed(self) -> bool:
        """Whether it has ended otherwise than it should."""
        return self.process.exitcode not in (None, DONE)

    @property
    def ends_run(self) -> bool:
        """Whether it has ended with a sentence that ends the whole run."""
        return self.process.exitcode == RUN_FAILED

    @property
    def ended(self) -> bool:
        """Whether it has ended."""
        return self.process.exitcode is not None

    def warnings(self) -> list[str]:
        """The warnings in its log since the last call."""
        with self._log.open("rb") as file:
            file.seek(self._read)
            new = file.read()
        whole = new[: new.rfind(b"\n") + 1]
        self._read += len(whole)
        lines = whole.decode(errors="replace").splitlines()
        return [line.removeprefix(WARNING) for line in lines if line.startswith(WARNING)]

    def last_words(self) -> str:
        """Why it has ended: its own last sentence, or the signal that killed it."""
        code = self.process.exitcode
        if code is not None and code < 0:
            return f"{self.name} was ended by signal {signal.Signals(-code).name}"
        words = self._log.read_text(errors="replace").strip().splitlines()
        return words[-1] if words and code != DONE else f"{self.name} ended with status {code} before the run did"

    def ask_to_end(self) -> None:
        """Send SIGTERM."""
        if self.process.is_alive():
            self.process.terminate()

    def end(self, patience: float) -> None:
        """Wait `patience` seconds for its end, and kill it then."""
        self.process.join(max(0.0, patience))
        if self.process.is_alive():
            self.process.kill()
            self.process.join()


def _live(life: Callable[[], None], log: Path, parent: int, at_orphaning: signal.Signals, shown: str) -> None:
    """Run a node in its own process: words to the log, errors as its last line, exit status told."""
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C reaches all processes of a terminal; the parent decides
    end_with_parent(parent, at_orphaning)
    show_as(shown)
    file = os.open(log, os.O_WRONLY | os.O_CREAT | os.O_APPEND, 0o644)
    os.dup2(file, 1)
    os.dup2(file, 2)
    if hasattr(os, "SCHED_BATCH"):
        os.sched_setscheduler(0, os.SCHED_BATCH, os.sched_param(0))  # fewer switches between a dozen processes
    status = DONE
    try:
        life()
    except CocorosimError as error:
        sys.stderr.write(f"{error}\n")
        status = RUN_FAILED if isinstance(error, RunError) else FAILED
    except BaseException:
        traceback.print_exc()
        status = FAILED
    sys.stderr.flush()
    os._exit(status)
