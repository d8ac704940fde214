"""The endurance run says what it promises: growth and losses are counted as they should be, on made-up moments."""

from __future__ import annotations

import importlib.util
import sys
from pathlib import Path
from types import ModuleType, SimpleNamespace

import pytest

from cocorosim_ros.world.checks.loading import load_scenario

FOLDER = Path(__file__).parent


@pytest.fixture
def endurance(monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    """The script as a module."""
    monkeypatch.syspath_prepend(FOLDER)
    described = importlib.util.spec_from_file_location("endurance", FOLDER / "endurance.py")
    assert described is not None and described.loader is not None
    module = importlib.util.module_from_spec(described)
    monkeypatch.setitem(sys.modules, "endurance", module)
    described.loader.exec_module(module)
    return module


def test_growth_counts_from_a_quarter_of_the_time(endurance: ModuleType) -> None:
    """What a process takes while it starts is no growth; what it takes later is."""
    memory = {0.0: 50.0, 20.0: 90.0, 25.0: 100.0, 60.0: 103.0, 100.0: 110.0}
    moments = [
        endurance.Moment(seconds, 1, 0, {"node": endurance.Use(size, 20 + (seconds > 50))})
        for seconds, size in memory.items()
    ]
    share, handles = endurance.growth(moments, "node")
    assert share == pytest.approx(0.1)
    assert handles == 1


def test_what_is_lost(endurance: ModuleType) -> None:
    """A topic with fewer messages than ticks has lost the difference; one that seldom speaks has not."""
    scenario = load_scenario("one_lily")
    every = endurance.lost(scenario, 10, {})
    assert "/lily_01/pose" in every and set(every.values()) == {10}
    counts = {topic: 10 for topic in every} | {"/lily_01/pose": 7}
    assert endurance.lost(scenario, 10, counts) == {"/lily_01/pose": 3}
    assert "/lily_01/radio_tx" not in every  # its controller says nothing
    assert "/lily_01/radio_tx" in endurance.lost(load_scenario("five_lilys"), 10, {})


def test_a_process_that_is_gone(endurance: ModuleType) -> None:
    """It has no use of anything; this one has memory and handles."""
    import os

    assert endurance.use_of(2**22 + 1) is None
    own = endurance.use_of(os.getpid())
    assert own.memory > 10.0 and own.handles >= 3


def test_the_watch_looks_every_so_often(endurance: ModuleType) -> None:
    """Nothing before the first tick, then at once, then not again within the time."""
    watch = endurance.Watch(1000.0)
    for ticks in (0, 1, 2, 3):
        watch.look(SimpleNamespace(ticks=ticks, missing_answers=0))
    assert [moment.ticks for moment in watch.moments] == [1]
