"""The tree as a colcon workspace, built by colcon from PyPI against the ROS of this virtual environment."""

from __future__ import annotations

import os
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
ENTRY_POINTS = ("cocorosim", "controller_node", "metrics_node", "physics_node")


@dataclass(frozen=True)
class Workspace:
    """What colcon has built."""

    install: Path
    log: str

    def run(self, command: str) -> subprocess.CompletedProcess[str]:
        """Run a shell command where the workspace is sourced, as a ROS user does."""
        script = f"source {self.install}/local_setup.bash && {command}"
        return subprocess.run(
            ["bash", "-c", script], cwd=self.install, capture_output=True, text=True, timeout=60, check=False
        )


@pytest.fixture(scope="session")
def workspace(tmp_path_factory: pytest.TempPathFactory) -> Workspace:
    """Both packages, built into a temporary folder."""
    base = tmp_path_factory.mktemp("workspace")
    scripts = Path(sys.prefix, "bin")
    environment = os.environ | {
        "AMENT_PREFIX_PATH": sys.prefix,
        "CMAKE_PREFIX_PATH": sys.prefix,
        "LD_LIBRARY_PATH": f"{sys.prefix}/lib:{os.environ.get('LD_LIBRARY_PATH', '')}",
        "PATH": f"{scripts}:{os.environ['PATH']}",
    }
    command = [scripts / "colcon", "--log-base", base / "log", "build", "--base-paths", ".", "msg_defs"]
    command += ["--build-base", base / "build", "--install-base", base / "install"]
    command += ["--cmake-args", "-G", "Ninja", f"-DPython3_EXECUTABLE={sys.executable}"]
    built = subprocess.run(command, cwd=ROOT, env=environment, capture_output=True, text=True, check=False)
    assert built.returncode == 0, built.stdout + built.stderr
    return Workspace(base / "install", built.stdout)


def test_both_packages_are_built(workspace: Workspace) -> None:
    """colcon sees the root package and msg_defs, and finishes both."""
    assert "2 packages finished" in workspace.log
    assert {path.name for path in workspace.install.iterdir() if path.is_dir()} == {
        "cocorosim_msgs",
        "cocorosim_ros",
    }


def test_ros2_run_would_find_the_executables(workspace: Workspace) -> None:
    """`ros2 run PACKAGE` looks in lib/PACKAGE, for packages that have a marker in the resource index."""
    prefix = workspace.install / "cocorosim_ros"
    assert {path.name for path in (prefix / "lib/cocorosim_ros").iterdir()} == set(ENTRY_POINTS)
    assert (prefix / "share/ament_index/resource_index/packages/cocorosim_ros").is_file()
    assert (prefix / "share/cocorosim_ros/package.xml").is_file()


def test_configuration_is_installed(workspace: Workspace) -> None:
    """Every file of config/ lies under share/cocorosim_ros/config."""
    installed = workspace.install / "cocorosim_ros/share/cocorosim_ros"
    expected = {path.relative_to(ROOT) for path in (ROOT / "config").rglob("*") if path.is_file()}
    assert expected
    assert {path.relative_to(installed) for path in (installed / "config").rglob("*") if path.is_file()} == expected


@pytest.mark.parametrize("module", ["cocorosim_ros", "cocorosim_msgs"])
def test_the_workspace_comes_before_the_virtual_environment(workspace: Workspace, module: str) -> None:
    """A sourced workspace gives its own modules, so the tests here are about what colcon has installed."""
    shown = workspace.run(f"{sys.executable} -c 'import {module}; print({module}.__file__)'")
    assert Path(shown.stdout.strip()).is_relative_to(workspace.install), shown.stderr


@pytest.mark.parametrize("name", ENTRY_POINTS)
def test_an_installed_entry_point_starts(workspace: Workspace, name: str) -> None:
    """`--help` of each installed executable ends well and tells its usage."""
    shown = workspace.run(f"{workspace.install}/cocorosim_ros/lib/cocorosim_ros/{name} --help")
    assert shown.returncode == 0, shown.stderr
    assert "usage" in shown.stdout.lower()
