"""A controller as its file describes it: which behaviour, with which parameters in which ranges."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from cocorosim_ros.scenario.reading.based_on import with_base
from cocorosim_ros.scenario.reading.config_files import find_config
from cocorosim_ros.scenario.reading.entry import Entry, entry_of, nearest
from cocorosim_ros.scenario.reading.quantity import (
    SOURCE_KEYS,
    Quantity,
    quantity_text,
    read_any_quantity,
    read_quantity,
    read_vector,
)
from cocorosim_ros.scenario.reading.records import TEXT, read_record, record_tree, stored
from cocorosim_ros.scenario.reading.sources import require_sources
from cocorosim_ros.scenario.reading.yaml_file import load_yaml

_SWITCH = "switch"


@dataclass(frozen=True)
class Parameter:
    """One number or switch of a controller: SI value, SI unit, allowed range (inclusive), meaning and source.

    A switch has a truth value, unit '' and the range 0 to 1.
    """

    value: float | bool
    unit: str
    dimension: str
    minimum: float
    maximum: float
    description: str
    source: str


def _read_parameters(entry: Entry) -> dict[str, Parameter]:
    return {name: _read_parameter(part) for name, part in entry.mapping().items()}


def _read_parameter(entry: Entry) -> Parameter:
    if isinstance(entry.mapping().get("value", entry).value, bool):
        section = entry.section(("value", "description", "source"), ("note", "confidence"))
        words = section["description"].text(), section["source"].text()
        return Parameter(section["value"].flag(), "", _SWITCH, 0.0, 1.0, *words)
    section = entry.section(("value", "unit", "allowed", "description", "source"), ("note", "confidence"))
    quantity = _sourced(entry, section)
    allowed = {"value": section["allowed"], "unit": section["unit"], "source": section["source"]}
    minimum, maximum = read_vector(replace(section["allowed"], value=allowed), [quantity.dimension] * 2)
    parameter = Parameter(
        quantity.value,
        quantity.unit,
        quantity.dimension,
        minimum,
        maximum,
        section["description"].text(),
        section["source"].text(),
    )
    _refuse_outside(parameter, quantity.value, section["value"])
    return parameter


def _sourced(entry: Entry, section: Mapping[str, Entry]) -> Quantity:
    keys = ("value", "unit", *SOURCE_KEYS)
    return read_any_quantity(replace(entry, value={name: part for name, part in section.items() if name in keys}))


def _parameters_tree(parameters: Mapping[str, Parameter]) -> dict[str, Any]:
    return {name: _parameter_tree(parameter) for name, parameter in parameters.items()}


def _parameter_tree(parameter: Parameter) -> dict[str, Any]:
    words = {"description": parameter.description, "source": parameter.source}
    if parameter.dimension == _SWITCH:
        return {"value": parameter.value, **words}
    return {
        "value": parameter.value,
        "unit": parameter.unit,
        "allowed": [parameter.minimum, parameter.maximum],
        **words,
    }


@dataclass(frozen=True)
class ControllerDescription:
    """Which behaviour a robot runs, and its parameters by name. `origin` is the file it came from."""

    name: str = field(metadata=TEXT)
    behaviour: str = field(metadata=TEXT)
    description: str = field(metadata=TEXT)
    parameters: Mapping[str, Parameter] = field(
        default_factory=dict,
        hash=False,
        metadata=stored(
            _read_parameters, _parameters_tree, form="mapping of names to numbers with unit, range and source"
        ),
    )
    origin: str = field(default="", compare=False)

    @property
    def values(self) -> dict[str, float | bool]:
        """The parameters' values in SI units by name."""
        return {name: parameter.value for name, parameter in self.parameters.items()}

    def with_overrides(self, values: Mapping[str, float | bool | str]) -> ControllerDescription:
        """The same controller with other parameter values: numbers in SI units, or text with a unit.

        Raises CocorosimError: unknown parameter, wrong unit, value outside the parameter's range.
        """
        origin = f"override of controller '{self.name}'"
        return self.with_override_entries(
            {name: entry_of(value, origin, name) for name, value in values.items()}, bare_si=True
        )

    def with_override_entries(self, entries: Mapping[str, Entry], bare_si: bool = False) -> ControllerDescription:
        """The same controller with the values of entries, whose place the complaints name.

        bare_si: a number without a unit counts as SI; otherwise it is refused where the parameter has a unit.
        """
        changed = dict(self.parameters)
        for name, entry in entries.items():
            if name not in changed:
                raise entry.problem(f"is no parameter of controller '{self.name}'{nearest(name, changed)}.")
            changed[name] = _overridden(changed[name], entry, bare_si)
        return replace(self, parameters=changed)


def load_controller(name_or_path: str | Path) -> ControllerDescription:
    """The controller of that name in config/controllers, or of that file.

    Raises CocorosimError: unknown name, unreadable file, unknown key, wrong unit, value outside its range.
    """
    return read_controller_file(find_config("controllers", str(name_or_path)))


def read_controller_file(path: Path) -> ControllerDescription:
    """The controller that a file describes; every number in it must carry its source."""
    entry = load_yaml(path)
    require_sources(entry)
    return read_controller(with_base(entry, "controllers", merged=("parameters",)))


def read_controller(entry: Entry) -> ControllerDescription:
    """The controller that a mapping describes."""
    return replace(read_record(ControllerDescription, entry), origin=entry.file)


def controller_tree(controller: ControllerDescription) -> dict[str, Any]:
    """The controller as nested plain values that `read_controller` reads back."""
    return record_tree(controller)


def _overridden(parameter: Parameter, entry: Entry, bare_si: bool) -> Parameter:
    if parameter.dimension == _SWITCH:
        return replace(parameter, value=entry.flag())
    if bare_si and isinstance(entry.value, (int, float)) and not isinstance(entry.value, bool):
        entry = replace(entry, value=quantity_text(float(entry.value), parameter.dimension))
    value = read_quantity(entry, parameter.dimension)
    _refuse_outside(parameter, value, entry)
    return replace(parameter, value=value)


def _refuse_outside(parameter: Parameter, value: float, entry: Entry) -> None:
    if not parameter.minimum <= value <= parameter.maximum:
        unit = "" if parameter.unit == "1" else f" {parameter.unit}"
        raise entry.problem(
            f"has {value:.9g}{unit}, outside what is allowed; "
            f"choose from {parameter.minimum:.9g} to {parameter.maximum:.9g}{unit}."
        )
