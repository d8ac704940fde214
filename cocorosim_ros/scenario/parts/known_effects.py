"""A platform that takes over what another platform's file knows beyond the basic physics: effects, axes, units."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Generic, TypeVar

from cocorosim_ros.scenario.parts.platform import Platform

Part = TypeVar("Part")


@dataclass(frozen=True)
class _Said(Generic[Part]):
    """What one platform file says."""

    of_all: Mapping[str, Part]
    of_one: Mapping[str, Part]
    """What holds for one robot: what is said of all, where nothing else is said of this one."""

    def of_one_alone(self) -> dict[str, Part]:
        """What is not said of all in the same words."""
        return {key: part for key, part in self.of_one.items() if self.of_all.get(key) != part}


def knowing(platform: Platform, known: Platform) -> Platform:
    """The platform with the effects and frame corrections of `known` beside its own, robot by robot; numbers stay.

    What is said of one robot counts for more than what is said of all, then what `known` says for more than what the
    platform says itself.
    """

    def of(name: str) -> Platform:
        own, other = platform.of_robot(name), known.of_robot(name)
        return replace(
            own,
            effect_quantities=_of_robot(
                _Said(platform.effect_quantities, own.effect_quantities),
                _Said(known.effect_quantities, other.effect_quantities),
            ),
            frame_corrections=_of_robot(
                _Said(platform.frame_corrections, own.frame_corrections),
                _Said(known.frame_corrections, other.frame_corrections),
            ),
        )

    return replace(
        platform,
        effect_quantities={**platform.effect_quantities, **known.effect_quantities},
        frame_corrections={**platform.frame_corrections, **known.frame_corrections},
        robots={name: of(name) for name in {**platform.robots, **known.robots}},
    )


def _of_robot(mine: _Said[Part], known: _Said[Part]) -> dict[str, Part]:
    """What holds for one robot."""
    return {**mine.of_all, **known.of_all, **mine.of_one_alone(), **known.of_one_alone()}
