"""The quality of service that a recording says its topics were offered with.

Recordings of every age are read: numbers where rosbag2 wrote numbers (up to metadata version 8), names where it
writes names. Where several publishers differed, or nothing was recorded, the offer is the one that all subscribers
accept which accepted any of them. Source: rosbag2_storage/qos.cpp and rmw/types.h of ROS 2 Jazzy.
"""

from __future__ import annotations

from typing import Any

from ruamel.yaml import YAML
from ruamel.yaml.error import YAMLError

from cocorosim_ros.wire.topics.service_quality import ServiceQuality

_BEST_EFFORT = (2, "best_effort")
_TRANSIENT_LOCAL = (1, "transient_local")
_USUAL_DEPTH, _GREATEST_DEPTH = 10, 100_000
_WHY = "as recorded"


def offered_quality(profiles: str) -> ServiceQuality:
    """The offer of a replay, from the YAML text `offered_qos_profiles` of a recorded topic."""
    recorded = [profile for profile in _parsed(profiles) if isinstance(profile, dict)]
    weak = [profile.get("reliability") in _BEST_EFFORT for profile in recorded]
    latched = [profile.get("durability") in _TRANSIENT_LOCAL for profile in recorded]
    depths = [profile["depth"] for profile in recorded if isinstance(profile.get("depth"), int)]
    return ServiceQuality(
        "recorded",
        "best_effort" if weak and all(weak) else "reliable",
        "transient_local" if any(latched) else "volatile",
        min(max([*depths, 0]) or _USUAL_DEPTH, _GREATEST_DEPTH),
        _WHY,
    )


def _parsed(profiles: str) -> list[Any]:
    try:
        content = YAML(typ="safe", pure=True).load(profiles)
    except YAMLError:
        return []
    return content if isinstance(content, list) else []
