"""Quality of service of the topics: named profiles as plain numbers, for nodes and recordings."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

_UNLIMITED = {"sec": 9223372036, "nsec": 854775807}


@dataclass(frozen=True)
class ServiceQuality:
    """One profile: how a topic's messages are delivered."""

    name: str
    reliability: str  # reliable | best_effort
    durability: str  # volatile | transient_local
    depth: int  # messages kept for a slow reader
    why: str

    def as_rosbag2(self) -> dict[str, Any]:
        """The profile as rosbag2 of Jazzy (metadata version 9) writes it."""
        return {
            "history": "keep_last",
            "depth": self.depth,
            "reliability": self.reliability,
            "durability": self.durability,
            "deadline": dict(_UNLIMITED),
            "lifespan": dict(_UNLIMITED),
            "liveliness": "automatic",
            "liveliness_lease_duration": dict(_UNLIMITED),
            "avoid_ros_namespace_conventions": False,
        }


STREAM = ServiceQuality(
    "stream",
    "reliable",
    "volatile",
    1000,
    "a lock-step tick waits for every answer, so nothing may be lost; deep, as the recorder may lag behind",
)
CLOCK = ServiceQuality(
    "clock",
    "reliable",
    "volatile",
    1000,
    "every tick is recorded; a reliable offer also serves the best-effort time sources of other nodes",
)
TRANSFORMS = ServiceQuality("transforms", "reliable", "volatile", 100, "what tf2 broadcasters offer and listeners ask")
LATCHED = ServiceQuality("latched", "reliable", "transient_local", 1, "said once, and heard by all who come later")
PROFILES = {profile.name: profile for profile in (STREAM, CLOCK, TRANSFORMS, LATCHED)}
