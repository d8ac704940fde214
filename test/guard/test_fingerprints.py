"""The guard finds what has changed."""

from __future__ import annotations

import sys
from pathlib import Path

FOLDER = str(Path(__file__).resolve().parents[1])
if FOLDER not in sys.path:
    sys.path.append(FOLDER)


def test_a_changed_and_a_missing_result_are_said() -> None:
    """A result that differs and one that is gone are each a line; new ones are none."""
    from guard.fingerprints import differences

    assert differences({"a": "1", "b": "2"}, {"a": "1", "b": "2", "c": "3"}) == []
    assert differences({"a": "1", "b": "2"}, {"a": "0", "c": "3"}) == ["changed  a", "missing  b"]
