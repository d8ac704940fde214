"""Phases of forces that swing in time, as a shape of an entry: the same for effects and for laws."""

from __future__ import annotations

from cocorosim_ros.world.terms.phases import phased, phases

__all__ = ["phased", "phases"]
