"""Of processes that begin together one compiles at a time; it is said when something is compiled; once is enough."""

from __future__ import annotations

import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest
from numba import njit

from cocorosim_ros.foundation.compiling import once
from cocorosim_ros.foundation.compiling.once import compile_once, somebody_compiles

LIMIT = 60.0  # s; only a hang takes so long
OTHER = """
import sys
from pathlib import Path
from cocorosim_ros.foundation.compiling.once import compile_once

def work():
    Path(sys.argv[1]).touch()
    sys.stdin.read()

compile_once("fish", "case", work, print)
"""


@pytest.fixture(autouse=True)
def empty_cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A cache of this test alone, in other processes too."""
    base = tmp_path / "cache/cocorosim_ros"
    base.mkdir(parents=True)
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(base.parent))
    monkeypatch.setattr(once, "cache_base", lambda: base)
    monkeypatch.setattr("cocorosim_ros.foundation.compiling.cache.cache_base", lambda: base)
    return base


def compiling() -> None:
    """Compile a new function, as numba does when the cache does not hold it."""
    njit(lambda x: x + 1.0)(1.0)


def test_what_is_compiled_is_said(empty_cache: Path) -> None:
    """Begin and end are told of; where nothing has to be compiled there is no word, and no lock either."""
    said: list[str] = []
    compile_once("fish", "case", compiling, said.append)
    assert [sentence.split(" ")[:2] for sentence in said] == [["compiling", "fish"], ["compiled", "fish"]]
    said.clear()
    compile_once("fish", "other case", lambda: None, said.append)
    assert said == []
    for lock in empty_cache.glob("*.lock"):
        lock.unlink()
    compile_once("fish", "case", lambda: None, said.append)
    assert said == []
    assert list(empty_cache.glob("*.lock")) == []


def test_what_failed_is_not_marked() -> None:
    """Work that raises an error is locked again the next time."""
    done: list[str] = []

    def fail() -> None:
        assert somebody_compiles()
        done.append("tried")
        raise ValueError("no")

    for _ in range(2):
        with pytest.raises(ValueError, match="no"):
            compile_once("fish", "case", fail, done.append)
    assert done == ["tried", "tried"]
    assert not somebody_compiles()


def test_one_compiles_and_the_others_wait(tmp_path: Path, wait_for: Callable[[Callable[[], bool]], None]) -> None:
    """A second process says that it waits, and does its work when the first one is done; others are not held up."""
    begun, program, said = tmp_path / "begun", tmp_path / "other.py", []
    program.write_text(OTHER)
    with subprocess.Popen([sys.executable, str(program), str(begun)], stdin=subprocess.PIPE) as other:
        try:
            wait_for(begun.exists)
            assert somebody_compiles()
            compile_once("crab", "case", lambda: said.append("crab is done"), said.append)

            def hear(sentence: str) -> None:
                said.append(sentence)
                assert other.stdin is not None
                other.stdin.close()

            compile_once("fish", "case", lambda: said.append("fish is done"), hear)
        finally:
            other.kill()
    assert said[0] == "crab is done"
    assert said[1].startswith("another process compiles fish; waiting for it")
    assert said[2:] == ["fish is done"]


@pytest.fixture
def wait_for() -> Callable[[Callable[[], bool]], None]:
    """Function of a condition: returns when it holds."""

    def wait(condition: Callable[[], bool]) -> None:
        deadline = time.monotonic() + LIMIT
        while not condition():
            assert time.monotonic() < deadline
            time.sleep(0.02)

    return wait
