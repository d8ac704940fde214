"""The class that a scenario names, loaded from the user's own file, and what it says of itself."""

from __future__ import annotations

import inspect
import sys
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType
from typing import Any

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.parts.python_controller import PythonController, file_bytes
from cocorosim_ros.scenario.reading.entry import nearest
from cocorosim_ros.world.controllers.controller import EXTRA_TOPICS, MEDIA
from cocorosim_ros.world.controllers.plain.faults import raised_in

RANDOM = "random"  # the argument of a constructor that asks for a generator of random numbers
_modules: dict[tuple[str, str], ModuleType] = {}


@dataclass(frozen=True)
class UserClass:
    """A class of a user's file that makes controllers."""

    named: PythonController
    kind: type[Any]

    @property
    def place(self) -> str:
        """Its `__call__`, as file:line."""
        return _place(self.named, self.kind)

    def needs(self) -> tuple[str, ...]:
        """Topics of EXTRA_TOPICS that it asks for, by its attribute `needs`. Raises CocorosimError for others."""
        needs = getattr(self.kind, "needs", ())
        listed = tuple(needs) if isinstance(needs, Iterable) and not isinstance(needs, str) else (needs,)
        for name in listed:
            if name not in EXTRA_TOPICS:
                raise CocorosimError(
                    f"{self.place}: 'needs' of '{self.named.name}' has {name!r}{nearest(str(name), EXTRA_TOPICS)}."
                )
        return listed

    def medium(self) -> str:
        """Over which of MEDIA it speaks, by its attribute `medium`. Raises CocorosimError for others."""
        medium = getattr(self.kind, "medium", MEDIA[0])
        if medium not in MEDIA:
            raise CocorosimError(
                f"{self.place}: 'medium' of '{self.named.name}' has {medium!r}{nearest(str(medium), MEDIA)}."
            )
        return str(medium)

    @property
    def wants_random(self) -> bool:
        """Whether its constructor asks for random numbers."""
        return RANDOM in self._signature() and RANDOM not in self.named.parameters

    def check(self) -> None:
        """Nothing, if its constructor takes the scenario's parameters, and `needs` and `medium` are such.

        Raises CocorosimError otherwise.
        """
        self.needs()
        self.medium()
        self._check_arguments()

    def _check_arguments(self) -> None:
        takes = self._signature()
        given = {**self.named.parameters, **({RANDOM: None} if self.wants_random else {})}
        anything = any(part.kind is part.VAR_KEYWORD for part in takes.values())
        named = {
            name: part for name, part in takes.items() if part.kind in (part.KEYWORD_ONLY, part.POSITIONAL_OR_KEYWORD)
        }
        for name in given:
            if not anything and name not in named:
                raise CocorosimError(
                    f"{self.place}: the constructor of '{self.named.name}' takes no '{name}', which "
                    f"{self.named.origin} gives as a parameter{nearest(name, named)}."
                )
        missing = [name for name, part in named.items() if part.default is part.empty and name not in given]
        if missing:
            raise CocorosimError(
                f"{self.place}: the constructor of '{self.named.name}' needs '{missing[0]}'; give it in "
                f"{self.named.origin} below 'parameters', or a default value in the class."
            )

    def scalar_arguments(self) -> dict[str, bool | int | float | str]:
        """Numbers, texts and truth values that its constructor takes, as the scenario gives them or by default."""
        defaults = {name: part.default for name, part in self._signature().items()}
        every = {**defaults, **self.named.parameters}
        return {name: value for name, value in every.items() if isinstance(value, bool | int | float | str)}

    def _signature(self) -> Mapping[str, inspect.Parameter]:
        try:
            return inspect.signature(self.kind).parameters
        except (TypeError, ValueError):  # a class whose constructor is not written in Python
            return {}


def load_class(named: PythonController) -> UserClass:
    """The class, from its file as it was when the scenario named it; a file is loaded once in a process.

    Raises CocorosimError: the file is gone, has changed, cannot be imported, or has no such class with `__call__`.
    """
    module = _loaded(named)
    found = getattr(module, named.class_name, None)
    if found is None:
        classes = ", ".join(_classes_of(module)) or "no class that can be called"
        raise CocorosimError(f"{named.shown} has no class '{named.class_name}'; it has {classes}.")
    if not isinstance(found, type):
        raise CocorosimError(
            f"{named.shown}: '{named.class_name}' is no class but of type '{type(found).__name__}'; name a class with "
            "'def __call__(self, sensed)'."
        )
    if _call_of(found) is None:
        raise CocorosimError(
            f"{_place(named, found)}: objects of the class '{named.class_name}' cannot be called; "
            "give it 'def __call__(self, sensed)'."
        )
    return UserClass(named, found)


def forget(named: PythonController) -> None:
    """Have the file executed anew when its class is loaded next."""
    if (module := _modules.pop((named.file, named.sha256), None)) is not None:
        sys.modules.pop(module.__name__, None)


def _call_of(kind: type[Any]) -> Any:
    """The `__call__` that objects of a class have, None without; every class can be called itself."""
    return next((vars(part)["__call__"] for part in kind.__mro__ if "__call__" in vars(part)), None)


def _place(named: PythonController, kind: type[Any]) -> str:
    """Where `__call__` begins in the user's file, otherwise the class, as file:line."""
    code = getattr(_call_of(kind), "__code__", None)
    if code is not None and code.co_filename == named.file:
        return f"{named.shown}:{code.co_firstlineno}"
    try:
        return f"{named.shown}:{inspect.getsourcelines(kind)[1]}"
    except (OSError, TypeError):
        return named.shown


def _classes_of(module: ModuleType) -> Iterator[str]:
    for name, part in vars(module).items():
        if isinstance(part, type) and part.__module__ == module.__name__ and _call_of(part) is not None:
            yield name


def _loaded(named: PythonController) -> ModuleType:
    key = (named.file, named.sha256)
    if key not in _modules:
        _modules[key] = _execute(named, file_bytes(named))
    return _modules[key]


def _execute(named: PythonController, content: bytes) -> ModuleType:
    """The file as a module; modules beside it can be imported, behind all others of their names."""
    path = Path(named.file)
    if str(path.parent) not in sys.path:
        sys.path.append(str(path.parent))
    module = ModuleType(f"own_controller_{path.stem}_{named.sha256[:16]}")
    module.__file__ = named.file
    sys.modules[module.__name__] = module  # where dataclasses and pickle look for it
    try:
        exec(compile(content, named.file, "exec"), vars(module))
    except (Exception, SystemExit) as error:
        del sys.modules[module.__name__]
        raise CocorosimError(
            f"{raised_in(named, error)}; this file cannot be imported, correct it or the name of the controller."
        ) from error
    return module
