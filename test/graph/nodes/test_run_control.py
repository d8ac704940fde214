"""A run of the command, looked at and held from outside while it waits for somebody else's controller."""

from __future__ import annotations

import json
import time
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from std_srvs.srv import SetBool

from cocorosim_ros.graph.nodes import run_control

ONLOOKER = Path(__file__).with_name("onlooker.py")
Begin = Callable[..., tuple[Any, Path]]


def test_every_node_has_parameters_and_refuses_in_sentences(begin: Begin, start: Callable[..., Any]) -> None:
    """Settings of a controller change within their range, all else is refused; a recorded run is not reset."""
    run, _ = begin(2, 6, "lily_02")
    domain = run.wait_for(r"export ROS_DOMAIN_ID=(\d+)")[1]
    shell = {"ROS_DOMAIN_ID": domain, "ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST"}
    controller, physics = "/lily_01/controller_node", "/physics_node"
    described = start(ONLOOKER, "describe", controller, env=shell)
    assert described.finish() == 0, described.output
    parameters = json.loads(described.output.splitlines()[-1])
    weight = parameters["setting.alignment_weight"]
    assert not weight["read_only"]
    assert not [(one, other) for one in parameters for other in parameters if other.startswith(f"{one}.")]
    actions = [
        f"{controller}/setting.alignment_weight={weight['range'][0][1]}",
        f"{controller}/setting.alignment_weight={weight['range'][0][1] + 1.0}",
        f"{controller}/period=1.0",
        f"{physics}/rate=2.0",
        f"{physics}/reset",
        "/metrics_node/period=1.0",
    ]
    held = start(ONLOOKER, "do", *actions, env=shell)
    assert held.finish() == 0, held.output
    answers = [json.loads(line) for line in held.output.splitlines()]
    assert [success for success, _ in answers] == [True, False, False, False, False, False]
    assert "read-only" in answers[2][1]
    assert answers[3][1].startswith("parameter 'rate' stays 0: lock-step (rate 0.0) and the wall clock cannot be exch")
    assert answers[4][1].startswith("the run is recorded, and the time of a recording cannot go backwards")
    run.find_nodes()
    run.interrupt()
    assert run.finish() == 130, run.output


def test_a_node_that_has_answered_stays_until_the_answer_has_arrived(monkeypatch: pytest.MonkeyPatch) -> None:
    """A run of a few ticks is over before the answer that frees the run; without an answer nothing is waited for."""
    slept: list[float] = []
    monkeypatch.setattr(run_control, "time", SimpleNamespace(monotonic=time.monotonic, sleep=slept.append))
    answer: dict[str, Any] = {}

    def create_service(kind: type, name: str, called: Callable[..., Any]) -> None:
        answer[name] = called

    log = SimpleNamespace(info=lambda words: None)
    node: Any = SimpleNamespace(
        get_logger=lambda: log, create_service=create_service, add_on_set_parameters_callback=lambda called: None
    )
    control = run_control.RunControl(node, 0.0, recorded=False)
    control.let_answers_arrive()
    assert slept == [0.0]
    assert answer["~/pause"](SetBool.Request(data=False), SetBool.Response()).success
    control.let_answers_arrive()
    assert 0.0 < slept[1] <= run_control.ON_ITS_WAY
