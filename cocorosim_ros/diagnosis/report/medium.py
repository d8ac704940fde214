"""Words for what a vehicle moves in: the catalogue's are of water, and of a vehicle in the air air is said."""

from __future__ import annotations

import re

from cocorosim_ros.diagnosis.fitting.vehicle_needs import moves_in_air
from cocorosim_ros.scenario.parts.platform import Platform

_OF_AIR = {
    "filter pumps, inflows, convection: let a float drift": "draughts, fans, convection: let a balloon drift",
    "an inflow or a wall near by: let floats drift at several places and depths": (
        "a draught or a wall near by: let balloons drift at several places and heights"
    ),
    "a pump that cycles, a tide, a seiche of the tank": "a fan or a heating that cycles",
    "the water": "the air",
    "of water": "of air",
    "water that turns": "air that turns",
}
"""Words of air in place of words of water, the longest first."""
_WORDS = re.compile("|".join(rf"\b{re.escape(words)}\b" for words in _OF_AIR), re.IGNORECASE)


def in_its_medium(page: str, platform: Platform) -> str:
    """The page as it stands for a vehicle in water; with the words of air for one in the air."""
    return _WORDS.sub(_in_air, page) if moves_in_air(platform) else page


def _in_air(match: re.Match[str]) -> str:
    """Words of air that begin with a capital where those of water do."""
    words = _OF_AIR[match[0].lower()]
    return words[0].upper() + words[1:] if match[0][0].isupper() else words
