"""A platform that takes over what another platform's file knows beyond the basic physics: effects, axes, units."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import TypeVar

from cocorosim_ros.scenario.parts.platform import Platform

Part = TypeVar("Part")


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
                (platform.effect_quantities, own.effect_quantities), (known.effect_quantities, other.effect_quantities)
            ),
            frame_corrections=_of_robot(
                (platform.frame_corrections, own.frame_corrections), (known.frame_corrections, other.frame_corrections)
            ),
        )

    return replace(
        platform,
        effect_quantities={**platform.effect_quantities, **known.effect_quantities},
        frame_corrections={**platform.frame_corrections, **known.frame_corrections},
        robots={name: of(name) for name in {**platform.robots, **known.robots}},
    )


def _of_robot(
    mine: tuple[Mapping[str, Part], Mapping[str, Part]], known: tuple[Mapping[str, Part], Mapping[str, Part]]
) -> dict[str, Part]:
    """What holds for one robot; of each side what it says of all, and what of this one."""
    alone = [{key: part for key, part in own.items() if of_all.get(key) != part} for of_all, own in (mine, known)]
    return {**mine[0], **known[0], **alone[0], **alone[1]}
