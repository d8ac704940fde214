"""From the table of effects to the lines of compiled functions: which effects act where."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal

from cocorosim_ros.world.effects import EFFECTS
from cocorosim_ros.world.terms.effect import Hook
from cocorosim_ros.world.vehicle_model.vehicles import EFFECT_BIT, PARAMETER_COLUMNS, parameter_names

Place = Literal["wrench", "inertia", "centre", "water", "command", "thrust", "response"]


def hooks(place: Place, effects: Mapping[str, object] = EFFECTS) -> dict[str, Hook]:
    """The functions of those effects that act at a place, in the order of the table."""
    found = {name: getattr(EFFECTS[name], place) for name in effects}
    return {name: hook for name, hook in found.items() if hook is not None}


def bits(place: Place) -> int:
    """The bits of all effects that act at a place."""
    return sum(EFFECT_BIT[name] for name in hooks(place))


def calls(names: Mapping[str, Hook], arguments: str) -> list[str]:
    """One guarded call per effect; '{parameters}' among the arguments becomes its own slice of the parameter row."""
    lines: list[str] = []
    for name in names:
        first = PARAMETER_COLUMNS[parameter_names(name)[0]]
        own = f"parameters[{first}:{first + len(EFFECTS[name].parameters)}]"
        lines += [f"if active & {EFFECT_BIT[name]}:", f"    {name}({arguments.format(parameters=own)})"]
    return lines
