"""Results as JSON: one layout for every command, and files that are whole at any time."""

from __future__ import annotations

import json
from contextlib import suppress
from pathlib import Path
from typing import Any

from cocorosim_ros.foundation.errors import CocorosimError


def json_text(content: dict[str, Any]) -> str:
    """`content` as indented JSON; NaN cannot occur in it."""
    return json.dumps(content, indent=2, allow_nan=False) + "\n"


def write_json(path: Path, content: dict[str, Any]) -> None:
    """Write `content` as `json_text` has it. Raises CocorosimError if there is no room."""
    text = json_text(content)
    provisional = path.with_name(path.name + ".part")
    try:
        provisional.write_text(text, "utf-8")
        provisional.replace(path)
    except OSError as error:
        with suppress(OSError):
            provisional.unlink(missing_ok=True)
        raise CocorosimError(f"{path} cannot be written: {error.strerror}; choose another place.") from error
