"""The controller that a scenario chooses: a behaviour of ours with its file, or a class in a Python file."""

from __future__ import annotations

from typing import Any

from cocorosim_ros.scenario.parts.controller_file import (
    ControllerDescription,
    controller_tree,
    read_controller,
    read_controller_file,
)
from cocorosim_ros.scenario.parts.python_controller import (
    PythonController,
    names_python,
    python_controller_tree,
    read_python_controller,
)
from cocorosim_ros.scenario.reading.config_files import referenced_config
from cocorosim_ros.scenario.reading.entry import Entry, entry_of

AnyController = ControllerDescription | PythonController


def read_controller_choice(entry: Entry) -> AnyController:
    """The controller that a name, a path, `my_file.py:MyController` or a mapping tells."""
    if isinstance(entry.value, dict):
        return read_python_controller(entry) if "file" in entry.value else read_controller(entry)
    if isinstance(entry.value, str) and names_python(entry.value):
        return read_python_controller(entry)
    return read_controller_file(referenced_config("controllers", entry))


def controller_choice_tree(controller: AnyController) -> dict[str, Any]:
    """The controller as nested plain values that `read_controller_choice` reads back."""
    if isinstance(controller, PythonController):
        return python_controller_tree(controller)
    return controller_tree(controller)


def chosen_controller(text: str, origin: str) -> AnyController:
    """The controller that a text tells as a scenario would; complaints name `origin`."""
    return read_controller_choice(entry_of(text, origin, "controller"))
