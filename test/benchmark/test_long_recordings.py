"""A recording that is four times as long takes hardly more memory."""

from __future__ import annotations

import importlib.util
from pathlib import Path
from types import ModuleType

import pytest

ROBOTS, SHORT, LONG = 11, 6_000, 24_000
MOST = 10.0  # MB
SAME_PAGE = 20_000  # poses; the page of the short recording is then as long as that of the long one


@pytest.fixture(scope="module")
def script() -> ModuleType:
    """The script as a module."""
    described = importlib.util.spec_from_file_location("long_recordings", Path(__file__).parent / "long_recordings.py")
    assert described is not None and described.loader is not None
    module = importlib.util.module_from_spec(described)
    described.loader.exec_module(module)
    return module


@pytest.fixture(scope="module")
def recordings(script: ModuleType, tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path]:
    """A short one and a long one."""
    folder = tmp_path_factory.mktemp("long")
    return script.write(folder / "short", ROBOTS, SHORT), script.write(folder / "long", ROBOTS, LONG)


@pytest.mark.skipif(not Path("/proc/self/status").exists(), reason="the system does not tell a process its peak")
@pytest.mark.parametrize("command", ["metrics", "view"])
def test_memory_hardly_grows(script: ModuleType, recordings: tuple[Path, Path], tmp_path: Path, command: str) -> None:
    """18,000 ticks more of eleven robots: 5 MB; while all poses lay in memory, it was 30."""
    options = ["--no-open", "--out", str(tmp_path / "page.html"), "--force"] if command == "view" else []
    first, short, long = (
        script.peak([command, str(recording), *options], SAME_PAGE) for recording in (recordings[0], *recordings)
    )
    assert min(first, short) > 50.0  # the first one may compile, which takes memory of its own
    assert long - short < MOST
