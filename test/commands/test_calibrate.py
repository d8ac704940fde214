"""`cocorosim calibrate` as it is typed."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner

from cocorosim_ros.commands.calibrate import command
from cocorosim_ros.foundation.errors import CocorosimError

Typed = Callable[..., Any]


@pytest.fixture
def typed(monkeypatch: pytest.MonkeyPatch) -> Typed:
    """Function of arguments: the result of the command on a wide terminal; errors of ours are raised."""
    monkeypatch.setenv("COLUMNS", "160")

    def run(*arguments: str) -> Any:
        result = CliRunner().invoke(command, list(arguments))
        if isinstance(result.exception, CocorosimError):
            raise result.exception
        return result

    return run


def test_without_argument_it_shows_the_table_and_what_does_not_fit(typed: Typed) -> None:
    """Ours beside the paper's and the measured numbers, and the sentences below."""
    shown = typed()
    assert shown.exit_code == 0
    line = next(row for row in shown.output.splitlines() if "10 cm from rest" in row)
    assert [cell.strip() for cell in line.strip("│").split("│")] == [
        "10 cm from rest",
        "3.03",
        "3.03",
        "2.87",
        "3.17",
        "s",
    ]
    assert "13.3 cm/s" in " ".join(shown.output.split())


def test_a_recording_is_fitted_and_written(typed: Typed, tmp_path: Path) -> None:
    """Lily's own calibration run gives Lily back, within a thousandth; a second time needs --force."""
    from cocorosim_ros.graph.runs.in_process import run_in_process
    from cocorosim_ros.graph.runs.run_record import RunRecord
    from cocorosim_ros.scenario.parts.platform import load_platform
    from cocorosim_ros.wire.topics.body import describe_body
    from cocorosim_ros.world.checks.loading import load_scenario

    scenario = load_scenario("calibration_run")
    record = RunRecord(tmp_path / "bag", [describe_body(robot) for robot in scenario.robots], {})
    with record.writer:
        run_in_process(scenario, record)
    arguments = (str(tmp_path / "bag"), "--platform", "lily", "--out", str(tmp_path / "found.yaml"))
    assert typed(*arguments).exit_code == 0
    found, lily = load_platform(tmp_path / "found.yaml"), load_platform("lily")
    assert found.drag == pytest.approx(lily.drag, rel=1e-3)
    assert found.yaw_inertia == pytest.approx(lily.yaw_inertia, rel=1e-3)
    with pytest.raises(CocorosimError, match="exists already"):
        typed(*arguments)
    assert typed(*arguments, "--force").exit_code == 0


def test_options_of_a_recording_need_one(typed: Typed, tmp_path: Path) -> None:
    """--out without BAG is a mistake, and nothing is written."""
    with pytest.raises(CocorosimError, match="give the BAG"):
        typed("--out", str(tmp_path / "x.yaml"))
    assert not list(tmp_path.iterdir())
