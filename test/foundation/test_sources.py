"""Which sources a module is made of, and that compiled code is kept with these alone."""

from __future__ import annotations

import os
import subprocess
import sys
import time
from pathlib import Path

import pytest

from cocorosim_ros.foundation.compiling.cache import KEPT_DAYS, folder_of, folder_of_text
from cocorosim_ros.foundation.compiling.cache_place import cache_base
from cocorosim_ros.foundation.compiling.sources import PACKAGE, digest_of, sources_of

FILTER = PACKAGE / "diagnosis" / "filter" / "filter.py"
METRICS = PACKAGE / "study" / "metrics" / "kernel.py"


def made(folder: Path, **texts: str) -> Path:
    """A package of modules with these texts."""
    package = folder / "cocorosim_ros"
    for name, text in texts.items():
        place = package.joinpath(*name.split("__")).with_suffix(".py")
        place.parent.mkdir(parents=True, exist_ok=True)
        place.write_text(text, encoding="utf-8")
    return package


def names(package: Path, start: str) -> set[str]:
    """The sources of a module, by their places in the package."""
    return {path.relative_to(package).as_posix() for path in sources_of(package / start, package)}


def test_imports_are_followed_through_modules_and_tables(tmp_path: Path) -> None:
    """Directly, through others, by the name of a module in a folder, in brackets, indented, in a circle."""
    package = made(
        tmp_path,
        a="from cocorosim_ros.room.b import (\n    one,\n    two,\n)\n",
        room__b="def f():\n    import cocorosim_ros.c\nfrom cocorosim_ros.room import d as e\n",
        room__d="from cocorosim_ros.a import one\nfrom cocorosim_ros import __version__\n",
        c="import math\n",
        other="from cocorosim_ros.c import x\n",
    )
    assert names(package, "a.py") == {"a.py", "room/b.py", "room/d.py", "c.py"}
    assert names(package, "other.py") == {"other.py", "c.py"}


def test_a_changed_source_changes_the_digest_of_what_needs_it_alone(tmp_path: Path) -> None:
    """Of the module itself and of those that import it, not of others."""
    package = made(tmp_path, a="from cocorosim_ros.b import x\n", b="x = 1\n", c="y = 1\n")

    def digests() -> list[str]:
        return [digest_of(sources_of(package / f"{name}.py", package)) for name in "abc"]

    before = digests()
    (package / "b.py").write_text("x = 22\n", encoding="utf-8")
    assert [old == new for old, new in zip(before, digests(), strict=True)] == [False, False, True]


def test_a_metric_is_no_source_of_the_filter() -> None:
    """An edit of a metric compiles no filter again, nor the other way round; both are made of the compiler's files."""
    metrics, of_filter = PACKAGE / "study" / "metrics", PACKAGE / "diagnosis" / "filter"
    assert not any(metrics in path.parents for path in sources_of(FILTER))
    assert not any(of_filter in path.parents for path in sources_of(METRICS))
    assert PACKAGE / "foundation" / "compiling" / "kernel.py" in sources_of(FILTER) & sources_of(METRICS)
    assert folder_of(FILTER) != folder_of(METRICS)


def test_the_text_of_a_table_counts() -> None:
    """Two functions that were written out from the same functions do not share a folder."""
    assert folder_of_text("def f(): pass", [FILTER]) != folder_of_text("def g(): pass", [FILTER])


def test_folders_that_nothing_uses_are_removed(tmp_path: Path) -> None:
    """When a new one is made: those of KEPT_DAYS ago go, younger ones stay."""
    base = tmp_path / "cocorosim_ros"
    for name, days in (("old", KEPT_DAYS + 1.0), ("young", KEPT_DAYS - 1.0)):
        (base / name).mkdir(parents=True)
        then = time.time() - days * 86400.0
        os.utime(base / name, (then, then))
    program = "from cocorosim_ros.foundation.compiling.cache import folder_of_text; print(folder_of_text('x', []))"
    environment = os.environ | {"NUMBA_CACHE_DIR": str(tmp_path)}
    said = subprocess.run([sys.executable, "-c", program], env=environment, capture_output=True, text=True, check=True)
    assert {path.name for path in base.iterdir()} == {"young", Path(said.stdout.strip()).name}


def test_a_table_shows_its_lines_in_a_traceback(monkeypatch: pytest.MonkeyPatch) -> None:
    """The text of a function that was written out is found by what shows tracebacks."""
    import linecache

    from cocorosim_ros.foundation.compiling.tables import compile_lines

    made_function = compile_lines("doubled", "x", ["return 2.0 * x"], {}, lambda function: function)
    file = made_function.__code__.co_filename
    assert linecache.getline(file, 2) == "    return 2.0 * x\n"
    assert cache_base() in Path(file).parents
    assert made_function(1.5) == 3.0


CALLED = """
import sys
sys.path.insert(0, {folder!r})
from callee import twice
from {module} import Pair

print(twice(Pair(1.0, 2.0)))
"""


def test_a_class_that_moved_to_another_module_is_no_error(tmp_path: Path) -> None:
    """A caller's class among the types of a cached function, as after an upgrade that moved it."""
    (tmp_path / "callee.py").write_text(
        "from cocorosim_ros.foundation.compiling.kernel import allocating_kernel\n\n\n"
        "@allocating_kernel\ndef twice(pair):\n    return 2.0 * pair.left\n",
        encoding="utf-8",
    )
    environment = {**os.environ, "XDG_CACHE_HOME": str(tmp_path / "cache"), "NUMBA_CACHE_DIR": ""}
    for module in ("first_home", "second_home"):
        (tmp_path / f"{module}.py").write_text(
            "from typing import NamedTuple\n\n\nclass Pair(NamedTuple):\n    left: float\n    right: float\n",
            encoding="utf-8",
        )
        text = CALLED.format(folder=str(tmp_path), module=module)
        ended = subprocess.run(
            [sys.executable, "-c", text], env=environment, capture_output=True, text=True, check=False
        )
        assert (ended.returncode, ended.stdout) == (0, "2.0\n"), ended.stderr
        (tmp_path / f"{module}.py").unlink()
