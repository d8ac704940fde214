"""How cocorosim_ros is installed: by pip into a virtual environment, or by colcon into a ROS workspace."""

from __future__ import annotations

import re
from pathlib import Path

from setuptools import find_packages, setup

PACKAGE = "cocorosim_ros"  # as Python imports it and as ROS and colcon know it
DISTRIBUTION = "cocorosim"  # as pip knows it: `uvx --from cocorosim cocorosim diagnose ...`
INSTALLED_FOLDERS = ("config", f"{PACKAGE}/graph/launch", "msg_defs/msg")  # recordings need the texts of messages

# What each package is for stands in requirements.in.
WITHOUT_ROS = [
    "click",
    "jinja2",
    "llvmlite",
    "lz4",
    "markupsafe",
    "matplotlib",
    "numba>=0.60",
    "numpy>=1.26",
    "pandas",
    "pyarrow",
    "rich",
    "rosbags>=0.10",
    "ruamel.yaml>=0.18",
    "scipy>=1.11",
    "zstandard",
]
EXTRAS = {
    "ros": ["ros-jazzy-rclpy==7.1.6", "ros-rclpy[fastrtps]==7.1.6", "ros-jazzy-common-interfaces==5.3.6"],
    "logs": ["pyulog", "pymavlink"],  # what `cocorosim convert` reads logs of PX4 and ArduPilot with
    "netcdf": ["xarray", "h5netcdf", "h5py"],  # water currents from files
    "view": ["rerun-sdk>=0.41"],  # what `cocorosim view --3d` writes scenes with
    "foxglove": ["foxglove-sdk>=0.16"],  # `cocorosim run --foxglove` and `replay --foxglove`
    "dask": ["dask", "distributed"],  # `cocorosim experiment --dask`, `cocorosim diagnose --fleet --dask`
    "bench": ["mujoco>=3"],
}


def version() -> str:
    """Return `__version__` of the package, read without importing it."""
    text = Path(PACKAGE, "__init__.py").read_text(encoding="utf-8")
    return re.search(r'^__version__ = "(.+)"$', text, re.MULTILINE)[1]


def shared_files() -> list[tuple[str, list[str]]]:
    """Return (folder under the prefix, files): index marker, package.xml, config and launch files."""
    share = Path("share", PACKAGE)
    files = [
        ("share/ament_index/resource_index/packages", [f"resource/{PACKAGE}"]),
        (str(share), ["package.xml"]),
    ]
    for root in map(Path, INSTALLED_FOLDERS):
        for folder in sorted(path for path in (root, *root.rglob("*")) if path.is_dir()):
            content = sorted(str(path) for path in folder.iterdir() if path.is_file())
            if content and folder.name != "__pycache__":
                files.append((str(share / folder.relative_to(root.parent)), content))
    return files


setup(
    name=DISTRIBUTION,
    version=version(),
    description="Swarms of underwater robots on ROS 2, and a diagnosis of where recordings and models differ",
    long_description=Path("README.md").read_text(encoding="utf-8"),
    long_description_content_type="text/markdown",
    keywords=["underwater robotics", "swarm robotics", "simulation", "system identification", "ROS 2"],
    classifiers=[
        "Development Status :: 4 - Beta",
        "Intended Audience :: Science/Research",
        "Programming Language :: Python :: 3",
        *(f"Programming Language :: Python :: {tried}" for tried in ("3.11", "3.12", "3.13")),
        "Topic :: Scientific/Engineering",
        "Typing :: Typed",
    ],
    license="Apache-2.0",
    maintainer="cocorosim_ros maintainers",
    maintainer_email="maintainers@example.org",
    packages=find_packages(include=[PACKAGE, f"{PACKAGE}.*"]),
    package_data={
        PACKAGE: [
            "py.typed",
            *("study/results/*.jinja", "study/pictures/*.jinja", "study/pictures/*.js", "study/pictures/*.css"),
            *("diagnosis/report/*.jinja", "diagnosis/fleet/*.jinja"),
        ]
    },
    data_files=shared_files(),
    python_requires=">=3.11",
    install_requires=WITHOUT_ROS,
    extras_require=EXTRAS,
    zip_safe=False,
    entry_points={
        "console_scripts": [
            f"cocorosim = {PACKAGE}.commands.main:main",
            f"physics_node = {PACKAGE}.commands.node_programs:physics_node",
            f"controller_node = {PACKAGE}.commands.node_programs:controller_node",
            f"metrics_node = {PACKAGE}.commands.node_programs:metrics_node",
        ],
    },
)
