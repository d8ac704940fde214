"""The outcome of one recording of a fleet, as the file that a resumed fleet reads."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from typing import Any

from cocorosim_ros.diagnosis.fleet.recordings import FileState
from cocorosim_ros.foundation.json_file import json_text


@dataclass(frozen=True)
class Outcome:
    """One recording, diagnosed or not.

    problem: sentence on why there is no diagnosis; "" if there is one. again: whether the same command tries once more.
    attempts: processes that have had it; more than one if one of them died. ended: how that one ended, in words.
    seconds: time on the clock; processor_seconds: of all its threads. version: of the code that made it. found: what
    `work.found_in` gives, as plain values; empty where there is a problem. trace: of an error of the program itself.
    """

    recording: str
    files: tuple[FileState, ...]
    problem: str = ""
    again: bool = False
    attempts: int = 1
    ended: str = ""
    seconds: float = 0.0
    processor_seconds: float = 0.0
    version: str = ""
    found: Mapping[str, Any] = field(default_factory=dict)
    trace: str = ""

    def text(self) -> str:
        """The text of its file."""
        return json_text({**asdict(self), "found": dict(self.found)})


def outcome_from(text: str) -> Outcome:
    """Read an outcome from the text of its file. Raises ValueError if the text is none."""
    tree = json.loads(text)
    try:
        files = tuple(FileState(**each) for each in tree.pop("files"))
        outcome = Outcome(files=files, **tree)
    except (AttributeError, KeyError, TypeError) as error:
        raise ValueError(f"it is no outcome: {error}") from error
    if not outcome.problem and "diagnosis" not in outcome.found:
        raise ValueError("it has neither a problem nor a diagnosis")
    return outcome
