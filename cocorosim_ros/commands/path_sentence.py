"""A path that the system refuses, in a sentence: a name that is too long, a folder not to be entered, a full disk."""

from __future__ import annotations

import os

_LONGEST = 60
"""Characters of a path that a sentence shows."""


def path_sentence(error: OSError) -> str | None:
    """The sentence for a path that the system refuses; None if the error is about none."""
    if not isinstance(error.filename, str | bytes) or error.strerror is None:
        return None
    path = os.fsdecode(error.filename)
    shown = path if len(path) <= _LONGEST else f"{path[:_LONGEST]}... ({len(path)} characters)"
    return f"{shown} cannot be used: {error.strerror}; check the name, whether you may use it, and room on the disk."
