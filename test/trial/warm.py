"""A process that has loaded the tool and forks for every command: the command line of `cocorosim` without its start.

Reads requests, one JSON object a line: {"words": [...], "limit": s, "said": FILE for standard error}; answers with
{"status": exit status, or null out of time, "seconds": ...}. A first request with "warm_up" runs in this process
itself, so that what it loads and compiles is there for all that follow.
"""

from __future__ import annotations

import contextlib
import json
import os
import signal
import sys
import time
import traceback
from typing import Any


def run_tool(words: list[str]) -> int:
    """Exit status of `cocorosim WORDS` in this process."""
    from cocorosim_ros.commands.main import main

    sys.argv = ["cocorosim", *words]
    try:
        main()
    except SystemExit as end:
        return end.code if isinstance(end.code, int) else int(end.code is not None)
    except BaseException:
        traceback.print_exc()
        return 1
    return 0


def in_child(request: dict[str, Any]) -> None:
    """Runs the command with its own streams, and ends this process."""
    os.setsid()
    with open(os.devnull, "w") as nothing, open(request["said"], "w") as said:
        os.dup2(nothing.fileno(), 1)
        os.dup2(said.fileno(), 2)
        status = run_tool(request["words"])
        sys.stderr.flush()
    os._exit(status)


def answer(request: dict[str, Any]) -> dict[str, Any]:
    """Forks, waits at most until the limit, ends the child's processes then."""
    begun = time.monotonic()
    child = os.fork()
    if child == 0:
        in_child(request)
    status: int | None = None
    while time.monotonic() - begun < request["limit"]:
        done, code = os.waitpid(child, os.WNOHANG)
        if done:
            status = os.waitstatus_to_exitcode(code)
            break
        time.sleep(0.02)
    else:
        with contextlib.suppress(ProcessLookupError):
            os.killpg(child, signal.SIGKILL)
        os.waitpid(child, 0)
    return {"status": status, "seconds": time.monotonic() - begun}


def serve() -> None:
    """Answers until standard input ends."""
    out = os.fdopen(os.dup(1), "w")
    nothing = os.open(os.devnull, os.O_WRONLY)
    os.dup2(nothing, 1)
    for line in sys.stdin:
        request = json.loads(line)
        if "warm_up" in request:
            os.dup2(nothing, 2)
            reply: dict[str, Any] = {"status": run_tool(request["warm_up"]), "seconds": 0.0}
        else:
            reply = answer(request)
        out.write(json.dumps(reply) + "\n")
        out.flush()


if __name__ == "__main__":
    serve()
