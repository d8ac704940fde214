"""A controller that is a class in a Python file of the user's own: which class, of which file, with which arguments.

Reading a scenario does not run the file: what a recording was made with can be looked at where the file is gone.
"""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.reading.entry import Entry, plain_value
from cocorosim_ros.scenario.reading.yaml_file import shown_path

SUFFIX = ".py"
EXAMPLE = "my_file.py:MyController"


@dataclass(frozen=True)
class PythonController:
    """Which class a robot's controller is made from. `origin` is where the scenario names it."""

    file: str
    """Path of the Python file, absolute."""
    class_name: str
    sha256: str
    """Of the file's bytes when the scenario named it; the controller runs with these bytes and no others."""
    parameters: Mapping[str, Any] = field(default_factory=dict, hash=False)
    """Arguments of the constructor by name, as the YAML file has them."""
    origin: str = field(default="", compare=False)

    @property
    def name(self) -> str:
        """The name of the class."""
        return self.class_name

    @property
    def shown(self) -> str:
        """The path of the file as sentences show it."""
        return shown_path(Path(self.file))

    @property
    def values(self) -> dict[str, Any]:
        """The arguments of the constructor by name."""
        return dict(self.parameters)

    def with_override_entries(self, entries: Mapping[str, Entry]) -> PythonController:
        """The same controller with other arguments, or more of them."""
        given = {name: plain_value(entry) for name, entry in entries.items()}
        return replace(self, parameters={**self.parameters, **given})


def names_python(text: str) -> bool:
    """Whether a text names a Python file, with a class or without."""
    return text.endswith(SUFFIX) or f"{SUFFIX}:" in text


def read_python_controller(entry: Entry) -> PythonController:
    """The controller that `my_file.py:MyController` or {file, parameters, sha256} names.

    A relative path counts from the folder of the file that names it. Raises CocorosimError: no class is named, or
    there is no such file. With 'sha256', as recordings have it, the file is not looked for.
    """
    named, sha256, parameters = entry, "", {}
    if isinstance(entry.value, dict):
        section = entry.section(("file",), ("parameters", "sha256"))
        named = section["file"]
        sha256 = section["sha256"].text() if "sha256" in section else ""
        given = section["parameters"].mapping() if "parameters" in section else {}
        parameters = {name: plain_value(part) for name, part in given.items()}
    place, _, class_name = named.text().rpartition(":")
    if not place.endswith(SUFFIX) or not class_name.isidentifier():
        raise named.problem(f"has {named.found()}, which names no class of a Python file; write '{EXAMPLE}'.")
    path = (Path(named.file).parent / Path(place).expanduser()).resolve()
    try:
        sha256 = sha256 or digest_of(path.read_bytes())
    except OSError as error:
        raise named.problem(f"names the file '{path}', which cannot be read ({error.strerror}); correct it.") from error
    return PythonController(str(path), class_name, sha256, parameters, origin=entry.file)


def python_controller_tree(controller: PythonController) -> dict[str, Any]:
    """The controller as nested plain values that `read_python_controller` reads back."""
    tree: dict[str, Any] = {"file": f"{controller.file}:{controller.class_name}", "sha256": controller.sha256}
    return {**tree, "parameters": dict(controller.parameters)} if controller.parameters else tree


def file_bytes(controller: PythonController) -> bytes:
    """The file's content. Raises CocorosimError if it cannot be read, or is not what the scenario was made with."""
    try:
        content = Path(controller.file).read_bytes()
    except OSError as error:
        raise CocorosimError(
            f"{controller.shown}, which has the controller '{controller.name}', cannot be read ({error.strerror}); "
            "put the file there."
        ) from error
    if (found := digest_of(content)) != controller.sha256:
        raise CocorosimError(
            f"{controller.shown} has changed since {controller.origin or 'the scenario'} was made with its class "
            f"'{controller.name}' (SHA-256 {found[:12]}..., was {controller.sha256[:12]}...); put the file back as it "
            "was, or take 'sha256' out of the scenario."
        )
    return content


def digest_of(content: bytes) -> str:
    """The SHA-256 of bytes, in hex digits."""
    return hashlib.sha256(content).hexdigest()
