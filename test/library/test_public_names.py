"""The names of the package: cheap until used, complete for checkers, documented, typed, and without ROS."""

from __future__ import annotations

import ast
import inspect
import subprocess
import sys
from collections.abc import Callable
from dataclasses import fields, is_dataclass
from pathlib import Path
from typing import Any

import pytest

import cocorosim_ros

ROOT = Path(__file__).parents[2]
PACKAGE = ROOT / "cocorosim_ros"
FUNCTIONS = [name for name in cocorosim_ros.__all__ if name.islower()]
RECORDS = [
    "Conversion",
    "DesignResults",
    "DiagnosisResult",
    "FleetResult",
    "Recording",
    "ShoalStatistics",
    "SimulatedRun",
]
WITHOUT_ROS = """
import sys

class NoRos:
    def find_spec(self, name, path=None, target=None):
        root = name.partition(".")[0]
        if root in ("rclpy", "builtin_interfaces", "rcl_interfaces", "ament_index_python") or root.endswith("_msgs"):
            raise ModuleNotFoundError(f"ROS is blocked: {name}")

sys.meta_path.insert(0, NoRos())
import cocorosim_ros as cocorosim
for name in cocorosim.__all__:
    getattr(cocorosim, name)
run = cocorosim.simulate("five_lilys", duration="5 s")
bag = cocorosim.record("five_lilys", "bag", duration="5 s")
assert bag.tracks["lily_01"].position.tolist() == run.position[:, 0].tolist()
assert bag.measure().values == run.measure().values
from cocorosim_ros.diagnosis.diagnose import diagnose
print("done")
"""


def output_of(program: str, folder: Path) -> str:
    """What a program prints in an interpreter of its own."""
    done = subprocess.run([sys.executable, "-c", program], cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout.strip()


def test_the_package_is_cheap_to_import(tmp_path: Path) -> None:
    """Neither the package nor the command's help loads arrays, compilers or tables."""
    heavy = {"numpy", "numba", "pandas", "scipy", "matplotlib", "pyarrow", "rosbags", "cocorosim_ros.library"}
    for module in ("cocorosim_ros", "cocorosim_ros.commands.main"):
        loaded = output_of(f"import sys, {module}; dir({module}); print(*sys.modules)", tmp_path)
        assert not heavy & set(loaded.split()), module


def test_checkers_see_the_names_that_there_are() -> None:
    """What is imported for type checkers, what can be asked for, and __all__ are the same, from the same modules."""
    tree = ast.parse((PACKAGE / "__init__.py").read_text("utf-8"))
    block = next(node for node in tree.body if isinstance(node, ast.If))
    homes = {alias.name: node.module for node in block.body if isinstance(node, ast.ImportFrom) for alias in node.names}
    assert homes == {name: f"cocorosim_ros.{home}" for name, home in cocorosim_ros._HOMES.items()}
    assert sorted(homes) == sorted(cocorosim_ros.__all__)
    assert set(cocorosim_ros.__all__) <= set(dir(cocorosim_ros))


def test_inside_the_package_nothing_comes_in_by_the_front_door() -> None:
    """The modules of the package import its version from it and no other name: wings stay in their order."""
    taken = {
        (path.name, alias.name)
        for path in PACKAGE.rglob("*.py")
        for node in ast.walk(ast.parse(path.read_text("utf-8")))
        if isinstance(node, ast.ImportFrom) and node.module == "cocorosim_ros" and node.level == 0
        for alias in node.names
    }
    assert taken
    assert {name for _, name in taken} == {"__version__"}


def test_an_unknown_name_is_an_attribute_error() -> None:
    """As of any module; sub-packages are still found."""
    with pytest.raises(AttributeError, match="module 'cocorosim_ros' has no attribute 'simulator'"):
        _ = cocorosim_ros.simulator
    from cocorosim_ros import world

    assert world.__name__ == "cocorosim_ros.world"


@pytest.mark.parametrize("name", FUNCTIONS)
def test_functions_say_what_they_take_give_and_refuse(name: str) -> None:
    """Every parameter is typed and named in the docstring, which says what is raised; there is an example."""
    function: Callable[..., Any] = getattr(cocorosim_ros, name)
    signature, words = inspect.signature(function), " ".join((function.__doc__ or "").split())
    assert signature.return_annotation is not inspect.Signature.empty
    for parameter in signature.parameters.values():
        assert parameter.annotation is not inspect.Parameter.empty, parameter.name
    assert "Raises CocorosimError" in words
    if function.__module__.startswith("cocorosim_ros.library"):
        assert "Returns " in words and "Example: `" in words
        missing = [each for each in signature.parameters if each not in words and each != "source"]
        assert not missing or "as for `simulate`" in words or "those of `simulate`" in words, missing


@pytest.mark.parametrize("name", RECORDS)
def test_results_say_what_they_hold(name: str) -> None:
    """They are frozen records that show themselves; every public property and method is typed and documented."""
    record = getattr(cocorosim_ros, name)
    assert is_dataclass(record) and record.__dataclass_params__.frozen  # type: ignore[attr-defined]
    assert record.__doc__ and fields(record)
    assert callable(record._repr_html_) and "pd.DataFrame" in inspect.signature(record.to_frame).return_annotation
    for own, value in vars(record).items():
        if own.startswith("_") or own in {field.name for field in fields(record)}:
            continue
        function = getattr(value, "fget", None) or getattr(value, "func", None) or value
        assert function.__doc__, own
        assert inspect.signature(function).return_annotation is not inspect.Signature.empty, own


@pytest.mark.parametrize("name", [*RECORDS, "ConvertedRecording", "TopicReadings", "Watch"])
def test_fields_that_are_arrays_say_their_shape(name: str) -> None:
    """An array's own text, below its line, begins with its shape."""
    record = getattr(cocorosim_ros, name)
    body = ast.parse(inspect.getsource(record)).body[0]
    assert isinstance(body, ast.ClassDef)
    for node, after in zip(body.body, [*body.body[1:], None], strict=True):
        if isinstance(node, ast.AnnAssign) and ast.unparse(node.annotation) in ("Floats", "Integers", "Flags"):
            assert isinstance(after, ast.Expr) and ast.literal_eval(after.value).startswith("("), ast.unparse(node)


def test_everything_works_without_ros(tmp_path: Path) -> None:
    """With rclpy and all message packages out of reach a run is simulated, recorded and measured."""
    assert output_of(WITHOUT_ROS, tmp_path) == "done"


def test_a_star_gives_the_public_names(tmp_path: Path) -> None:
    """`from cocorosim_ros import *` loads them all."""
    program = "from cocorosim_ros import *; print(simulate.__name__, Recording.__name__, CocorosimError.__name__)"
    assert output_of(program, tmp_path) == "simulate Recording CocorosimError"
