"""The error of a run that began and could not go on."""

from __future__ import annotations

from cocorosim_ros.foundation.errors import CocorosimError


class RunError(CocorosimError):
    """The input was usable, but the run failed midway: commands print the sentence and end with status 1."""
