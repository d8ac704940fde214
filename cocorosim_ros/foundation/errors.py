"""The one error that a user of cocorosim meets."""

from __future__ import annotations


class CocorosimError(Exception):
    """A sentence for the person who made the mistake: which file, which key, what was found, what to do.

    Commands print it on standard error and end with status 2.
    """
