"""Influences on instruments that several of them have in common, as products of regressors (written as in laws.law)."""

from __future__ import annotations

MOTORS = ("thrust", "yaw_command", "|thrust|")
PUMP = ("pump", "pump_rate")
PLACE = ("x", "y", "z")
HEADING = ("sin_yaw", "cos_yaw")
TURN = ("yaw", "sin_yaw", "cos_yaw", "r")
"""What a heading or its rate shows."""
