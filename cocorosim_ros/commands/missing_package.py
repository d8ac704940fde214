"""A package that only parts of the work need, and that is not there: what is missing and how to get it."""

from __future__ import annotations

import importlib.util
import sys
from collections.abc import Sequence

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.foundation.installation import DISTRIBUTION

_GENERATED = "build msg_defs with colcon and source it, or use the environment that 'make demo' builds in a checkout"
_ROS = f"source a ROS 2 Jazzy installation, or 'pip install \"{DISTRIBUTION}[ros]\"' on Linux on x86-64"
_REMEDIES = {
    **dict.fromkeys(("cocorosim_msgs", "tf2_msgs"), _GENERATED),
    **dict.fromkeys(("rclpy", "rcl_interfaces", "builtin_interfaces", "rosgraph_msgs"), _ROS),
    **dict.fromkeys(
        ("std_msgs", "std_srvs", "geometry_msgs", "sensor_msgs", "diagnostic_msgs", "visualization_msgs"), _ROS
    ),
    **dict.fromkeys(("dask", "distributed"), f"'pip install \"{DISTRIBUTION}[dask]\"'"),
    **dict.fromkeys(("xarray", "h5netcdf", "h5py"), f"'pip install \"{DISTRIBUTION}[netcdf]\"'"),
    "foxglove": f"'pip install \"{DISTRIBUTION}[foxglove]\"'",
    "rerun": f"'pip install \"{DISTRIBUTION}[view]\"'",
}


def missing_package(module: str, instead: str = "") -> CocorosimError | None:
    """The sentence for a module that could not be imported; None for one that every installation must have.

    `instead`: how to do without it, as words that go on after "or".
    """
    package = module.partition(".")[0]
    if package not in _REMEDIES:
        return None
    way_out = f", or {instead}" if instead else ""
    return CocorosimError(
        f"This needs the Python package {package}, which is not installed for {sys.executable}: "
        f"{_REMEDIES[package]}{way_out}."
    )


def check_ros(instead: str) -> None:
    """Nothing, if nodes can be started. Raises CocorosimError if rclpy or our message classes are missing."""
    check_installed(("rclpy", "cocorosim_msgs"), instead)


def check_installed(modules: Sequence[str], instead: str) -> None:
    """Nothing, if all are there. Raises CocorosimError for the first that is not; instead: as in missing_package."""
    for module in modules:
        error = missing_package(module, instead)
        if error and importlib.util.find_spec(module) is None:
            raise error
