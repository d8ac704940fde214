"""The way to a live server that loads its library only where somebody asks for one."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from cocorosim_ros.wire.live.foxglove_server import FoxgloveServer


def foxglove_server(port: int, name: str) -> FoxgloveServer:
    """A server as `FoxgloveServer` makes it. Raises CocorosimError, or ModuleNotFoundError without foxglove-sdk."""
    from cocorosim_ros.wire.live.foxglove_server import FoxgloveServer

    return FoxgloveServer(port, name)


def foxglove_port(port: int) -> int:
    """The port that a server can have. Raises CocorosimError, or ModuleNotFoundError without foxglove-sdk."""
    from cocorosim_ros.wire.live.foxglove_server import check_port

    return check_port(port)
