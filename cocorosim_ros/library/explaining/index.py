"""All explanations, made once for each state of the sources and kept beside the compiled functions."""

from __future__ import annotations

import json
import os
from contextlib import suppress
from functools import cache
from pathlib import Path

from cocorosim_ros.foundation.compiling.cache_place import cache_base
from cocorosim_ros.foundation.compiling.sources import PACKAGE, digest_of
from cocorosim_ros.library.explaining.explanation import Explanation, explanation_of
from cocorosim_ros.scenario.reading.config_files import config_folders

_FILE = "explanations.json"


@cache
def every_explanation() -> tuple[Explanation, ...]:
    """Every key that there is. The model's tables are loaded only if sources or shipped files have changed."""
    kept = cache_base() / f"explained-{_state()}" / _FILE
    with suppress(OSError, ValueError, KeyError, TypeError):
        return tuple(map(explanation_of, json.loads(kept.read_text("utf-8"))))
    from cocorosim_ros.library.explaining.file_keys import file_keys
    from cocorosim_ros.library.explaining.tables import table_entries

    made = (*file_keys(), *table_entries())
    with suppress(OSError):  # then it is made again the next time
        _write(kept, json.dumps([each.tree() for each in made]))
    return made


def _state() -> str:
    files = [*PACKAGE.rglob("*.py")]
    for folder in config_folders():
        files += [*folder.rglob("*.yaml"), *folder.glob("*.md")]
    return digest_of(files)


def _write(file: Path, text: str) -> None:
    """Write the file, whole at any time: other processes may write the same."""
    file.parent.mkdir(parents=True, exist_ok=True)
    unfinished = file.with_name(f"{file.name}.{os.getpid()}")
    unfinished.write_text(text, "utf-8")
    os.replace(unfinished, file)
