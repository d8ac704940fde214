"""Somebody who looks at topics while they come."""

from __future__ import annotations

from typing import Protocol


class Viewers(Protocol):
    """To whom messages are shown as they are recorded or played."""

    def add(self, topic: str, type_name: str, schema: str = "") -> None:
        """Offer a topic. schema: `ros2msg` text of a type that the type store does not know."""

    def send(self, topic: str, stamp_ns: int, data: bytes, *, latched: bool = False) -> None:
        """Show a message of a topic that was added; a latched one to those who come later, too."""
