"""`cocorosim doctor`: what is here, what lacks, and whether two processes can talk."""

from __future__ import annotations

import importlib.metadata
import importlib.util
import json
import subprocess
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from cocorosim_ros.foundation.compiling import cache_place
from cocorosim_ros.library import health

Run = Callable[..., SimpleNamespace]


def test_packages_are_looked_up_in_the_metadata() -> None:
    """What lacks is bad, or absent where an extra alone asks for it; both say how to get it."""
    found = list(
        health.packages(
            ["numpy>=1.26", "elephant>=2", 'giraffe[neck]==1; extra == "ros"', 'mujoco>=3; extra == "bench"']
        )
    )
    assert [(each.name, each.state) for each in found] == [
        ("numpy", "good"),
        ("elephant", "bad"),
        ("giraffe", "absent"),
    ]
    assert found[0].words == importlib.metadata.version("numpy")
    assert 'pip install "elephant>=2"' in found[1].words
    assert 'pip install "cocorosim[ros]"' in found[2].words


@pytest.mark.parametrize("version, state", [((3, 10, 9), "bad"), ((3, 11, 0), "good"), ((3, 14, 0), "good")])
def test_a_newer_python_is_told_not_refused(
    version: tuple[int, int, int], state: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """One too old cannot work; one newer than those tested works where numba has a wheel, and is told."""
    monkeypatch.setattr(health.sys, "version_info", version)
    found = health.examine()[0]
    assert (found.name, found.state) == ("python", state)
    assert ("are tested" in found.words) == (version[1] != 11)


def test_it_works_without_ros_and_says_so(cocorosim: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    """Without rclpy nothing essential lacks, and the way without ROS is named."""
    whole = importlib.util.find_spec
    monkeypatch.setattr(
        importlib.util, "find_spec", lambda name, *more: None if name == "rclpy" else whole(name, *more)
    )
    done = cocorosim("doctor", "--json", "-")
    told: Any = json.loads(done.out)
    (ros,) = [each for each in told["findings"] if each["name"] == "ros"]
    assert (done.status, told["healthy"], ros["state"]) == (0, True, "absent")
    assert "--in-process" in ros["found"]


def test_something_essential_lacks(cocorosim: Run, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """A cache that cannot be written is named, with what to do, and the status is 1."""
    monkeypatch.setattr(health, "cache_base", lambda: tmp_path / "nowhere")
    monkeypatch.setattr("cocorosim_ros.commands.doctor._middleware", lambda: iter(()))
    done = cocorosim("doctor")
    assert done.status == 1
    assert "Lacking: cache." in done.out
    assert "set XDG_CACHE_HOME" in done.out
    assert cache_place.cache_base() != tmp_path / "nowhere"


def test_two_processes_talk(start: Callable[..., subprocess.Popen[str]], domain: int) -> None:
    """A question to another process is answered, and the time that it took is told."""
    process = start("doctor", "--json", "-")
    out, _ = process.communicate(timeout=120)
    told = json.loads(out[out.index('{\n  "healthy"') :])
    (middleware,) = [each for each in told["findings"] if each["name"] == "middleware"]
    assert middleware["state"] == "good", middleware
    assert "question and answer in" in middleware["found"]
    assert process.returncode == 0
