"""What a user's own Python file does wrong, as one sentence that says in which line."""

from __future__ import annotations

import traceback
from pathlib import Path

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.parts.python_controller import PythonController


class ControllerError(CocorosimError):
    """A plain Python controller failed while its run went on, which ends the run."""


def raised_in(controller: PythonController, error: BaseException) -> str:
    """Where in the user's file an exception came about, as file:line, and its text, in one line."""
    try:
        words = " ".join(str(error).split())
    except Exception:  # the text of the user's own exception may fail as well
        words = "its text cannot be shown"
    kind = type(error).__name__
    return f"{controller.shown}{_line(controller.file, error)}: {kind}{f': {words}' if words else ''}"


def _line(file: str, error: BaseException) -> str:
    """':LINE' of the innermost place in the file that led to the exception, '' if there is none."""
    if isinstance(error, SyntaxError) and error.filename == file and error.lineno is not None:
        return f":{error.lineno}"
    frames = traceback.extract_tb(error.__traceback__)
    lines = [frame.lineno for frame in frames if Path(frame.filename) == Path(file)]
    return f":{lines[-1]}" if lines else ""
