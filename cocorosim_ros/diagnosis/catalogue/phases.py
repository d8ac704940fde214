"""The phase of what swings in time, as a shape of an entry: that of effects and laws alike."""

from __future__ import annotations

from cocorosim_ros.world.terms.phases import phased, phases

__all__ = ["phased", "phases"]
