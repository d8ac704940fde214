"""The message types of msg_defs, as their files have them."""

from __future__ import annotations

from pathlib import Path

from site_builder.markdown import block

_FOLDER = Path(__file__).parents[2] / "msg_defs" / "msg"


def messages() -> str:
    """Every type, a heading each."""
    return "\n\n".join(f"## {path.stem}\n\n{block(path.read_text('utf-8'))}" for path in sorted(_FOLDER.glob("*.msg")))
