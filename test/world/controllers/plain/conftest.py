"""Plain Python controllers from text: one Lily's, asked without a simulation."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.scenario.parts.controller_choice import chosen_controller
from cocorosim_ros.scenario.parts.platform import load_platform
from cocorosim_ros.scenario.scenario import RobotDescription
from cocorosim_ros.world.controllers.request import REQUEST_SIZE
from cocorosim_ros.world.state.observation import Observation, blank_observation
from cocorosim_ros.world.state.radio import MESSAGE_SIZE


@pytest.fixture
def robot_with(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[..., RobotDescription]:
    """Function of (source, arguments, class name, platform): lily_01 controlled by a class of the file `mine.py`."""
    monkeypatch.chdir(tmp_path)

    def make(
        source: str, parameters: dict[str, Any] | None = None, name: str = "Mine", platform: str = "lily"
    ) -> RobotDescription:
        (tmp_path / "mine.py").write_text(source, "utf-8")
        controller = replace(chosen_controller(f"mine.py:{name}", "a test"), parameters=parameters or {})
        return RobotDescription("lily_01", load_platform(platform), controller, external=False)

    return make


@pytest.fixture
def asked(robot_with: Callable[..., RobotDescription]) -> Callable[..., Any]:
    """Function of (robot, observations, seed, run): its request and message after these observations."""
    from cocorosim_ros.world.controllers.plain.plain_controller import PlainController, plain_of

    def ask(
        robot: RobotDescription, observations: tuple[Observation, ...] | None = None, seed: int = 1, run: int = 0
    ) -> Any:
        request, said = np.full(REQUEST_SIZE, np.nan), np.full(MESSAGE_SIZE, np.nan)
        named = plain_of(robot)
        assert named is not None
        controller = PlainController(robot, named, seed, run)
        for observation in observations or (blank_observation(5, 4),):
            controller.ask(observation, request, said)
        return request, said

    return ask
