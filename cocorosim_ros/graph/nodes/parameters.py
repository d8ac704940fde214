"""ROS parameters: declared with type, range and description; most are read once at the start and read-only then."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any

from rcl_interfaces.msg import FloatingPointRange, IntegerRange, ParameterDescriptor
from rclpy.exceptions import InvalidParameterTypeException, InvalidParameterValueException
from rclpy.node import Node

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.graph.nodes.quality_overrides import PREFIX
from cocorosim_ros.graph.nodes.rclpy_internals import given_parameters

_OF_EVERY_NODE = ("use_sim_time", "start_type_description_service", PREFIX)


@dataclass(frozen=True)
class NodeParameter:
    """One parameter of a node; its type is that of its default."""

    name: str
    default: Any
    description: str
    span: tuple[float, float] | None = field(default=None)  # smallest and greatest value
    changeable: bool = False  # while the node runs


def declare(node: Node, parameters: tuple[NodeParameter, ...]) -> dict[str, Any]:
    """Declare the parameters, read-only unless they are changeable, and return their values.

    Raises CocorosimError for a value of another type or out of range.
    """
    return {parameter.name: _declared(node, parameter) for parameter in parameters}


def warn_of_unknown(node: Node) -> None:
    """Log the parameters that were given to the node and that it does not have, as misspelt ones."""
    for name in given_parameters(node):
        if not node.has_parameter(name) and not name.startswith(_OF_EVERY_NODE):
            node.get_logger().warning(f"parameter '{name}' was given, but {node.get_name()} has none of that name")


def usage_lines(parameters: tuple[NodeParameter, ...]) -> str:
    """The parameters as lines of a usage text."""
    return "\n".join(f"  {part.name} (default {part.default!r}): {part.description}" for part in parameters)


def _declared(node: Node, parameter: NodeParameter) -> Any:
    try:
        return node.declare_parameter(parameter.name, parameter.default, _descriptor(parameter)).value
    except InvalidParameterTypeException as error:
        kind = {str: "a text", bool: "true or false", int: "a whole number"}.get(type(parameter.default), "a number")
        given = given_parameters(node).get(parameter.name)
        found = "another type" if given is None else repr(given.value)
        raise CocorosimError(
            f"{node.get_name()}: parameter '{parameter.name}' has {found}; give {kind}"
            f"{', with a decimal point' if isinstance(parameter.default, float) else ''} ({parameter.description})."
        ) from error
    except InvalidParameterValueException as error:
        given = getattr(given_parameters(node).get(parameter.name), "value", "a value")
        low, high = parameter.span or (-math.inf, math.inf)
        raise CocorosimError(
            f"{node.get_name()}: parameter '{parameter.name}' has {given}, which is out of range; "
            f"give {low:g} to {high:g} ({parameter.description})."
        ) from error


def _descriptor(parameter: NodeParameter) -> ParameterDescriptor:
    descriptor = ParameterDescriptor(description=parameter.description, read_only=not parameter.changeable)
    if parameter.span is None:
        return descriptor
    low, high = parameter.span
    if isinstance(parameter.default, int):
        descriptor.integer_range = [IntegerRange(from_value=int(low), to_value=int(high), step=0)]
    else:
        descriptor.floating_point_range = [FloatingPointRange(from_value=float(low), to_value=float(high), step=0.0)]
    return descriptor
