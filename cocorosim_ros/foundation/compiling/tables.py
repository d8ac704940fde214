"""Tables of functions as one compiled function, written out line by line.

numba can neither cache closures over compiled functions nor loop over a tuple of different ones; a function written out
from the table has neither problem, and an entry that is switched off costs one predictable branch. The text lies as a
file in the cache, so that tracebacks and complaints of the compiler show its lines.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from types import ModuleType
from typing import Any

from cocorosim_ros.foundation.compiling.cache import folder_of_text
from cocorosim_ros.foundation.compiling.kernel import kernel


def compile_lines(
    name: str,
    arguments: str,
    lines: Sequence[str],
    functions: Mapping[str, Any],
    compiler: Callable[..., Any] = kernel,
) -> Callable[..., Any]:
    """Return the compiled function `name(arguments)` whose body is `lines`, which may use `functions` by their names.

    These are functions, compiled or not, classes of records, modules such as `math`, and numbers.

    Turns a table into one function, so that a new effect or controller is a file and a line in a table.
    """
    body = "\n".join(f"    {line}" for line in lines) or "    pass"
    text = f"def {name}({arguments}):\n{body}\n"
    files = {name: _file_of(used) for name, used in functions.items()}
    numbers = {name: repr(functions[name]) for name, file in files.items() if file is None}
    file = folder_of_text(f"{text}{numbers}", filter(None, files.values())) / f"{name}.py"
    _write_once(file, text)
    namespace: dict[str, Any] = {**functions, "__name__": __name__}
    exec(compile(text, str(file), "exec"), namespace)
    made: Callable[..., Any] = compiler(namespace[name])
    return made


def _file_of(used: Any) -> Path | None:
    """The file in which a function, an intrinsic or a class was written; None for numbers and foreign modules."""
    plain = getattr(used, "py_func", None) or getattr(used, "_defn", used)
    if isinstance(plain, type):
        plain = sys.modules[plain.__module__]
    if isinstance(plain, ModuleType):
        return Path(plain.__file__) if plain.__name__.startswith("cocorosim_ros.") and plain.__file__ else None
    return Path(plain.__code__.co_filename) if hasattr(plain, "__code__") else None


def _write_once(file: Path, text: str) -> None:
    """Write the file unless it is there, whole at any time: other processes may write the same."""
    if not file.is_file():
        unfinished = file.with_name(f"{file.name}.{os.getpid()}.unfinished")
        unfinished.write_text(text, encoding="utf-8")
        os.replace(unfinished, file)
