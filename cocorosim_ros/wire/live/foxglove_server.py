"""The live topics for Foxglove and Lichtblick: the bytes of every message over the WebSocket of foxglove-sdk.

Messages go out as CDR with the schema of their type, as they are recorded, and with their stamps as times. A viewer
that connects late gets the last message of latched topics.
"""

from __future__ import annotations

import socket
from types import TracebackType
from typing import TYPE_CHECKING

import foxglove
from foxglove.websocket import Capability, ServerListener, WebSocketServer

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.wire.cdr.type_store import schema_text

if TYPE_CHECKING:
    from foxglove.websocket import ChannelView, Client

HOST = "127.0.0.1"
CLOCK_TOPIC = "/clock"


def check_port(port: int) -> int:
    """The port, if a server can listen there, and one that is free for 0. Raises CocorosimError if none can."""
    try:
        with socket.socket() as probe:
            probe.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            probe.bind((HOST, port))
            return int(probe.getsockname()[1])
    except (OSError, OverflowError) as error:
        raise _no_port(port, error) from error


class FoxgloveServer(ServerListener):
    """A server on this machine; its threads are its own. Not to be carried over a fork."""

    def __init__(self, port: int, name: str) -> None:
        """port: 0 for one that is free; name: what a viewer shows. Raises CocorosimError if the port is in use."""
        self._context = foxglove.Context()
        self._channels: dict[str, foxglove.Channel] = {}
        self._latched: dict[str, tuple[bytes, int]] = {}
        try:
            self._server: WebSocketServer = foxglove.start_server(
                name=name,
                host=HOST,
                port=port,
                capabilities=[Capability.Time],
                server_listener=self,
                context=self._context,
            )
        except (OSError, RuntimeError, OverflowError) as error:
            raise _no_port(port, error) from error
        self.port: int = self._server.port
        self.address = f"ws://{HOST}:{self.port}"

    def add(self, topic: str, type_name: str, schema: str = "") -> None:
        """Offer a topic. schema: `ros2msg` text of a type that the type store does not know."""
        text = schema or schema_text(type_name)
        described = foxglove.Schema(name=type_name, encoding="ros2msg", data=text.encode())
        self._channels[topic] = foxglove.Channel(topic, schema=described, message_encoding="cdr", context=self._context)

    def send(self, topic: str, stamp_ns: int, data: bytes, *, latched: bool = False) -> None:
        """Send a message of a topic that was added; a latched one again to each viewer that asks for it later."""
        if latched:
            self._latched[topic] = data, stamp_ns
        self._channels[topic].log(data, log_time=stamp_ns)
        if topic == CLOCK_TOPIC:
            self._server.broadcast_time(stamp_ns)

    def on_subscribe(self, client: Client, channel: ChannelView) -> None:
        """A viewer asks for a topic."""
        if channel.topic in self._latched:
            data, stamp_ns = self._latched[channel.topic]
            self._channels[channel.topic].log(data, log_time=stamp_ns)

    def close(self) -> None:
        """Say goodbye to all viewers."""
        self._server.stop()

    def __enter__(self) -> FoxgloveServer:
        """The server itself."""
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        """Close it."""
        self.close()


def _no_port(port: int, error: Exception) -> CocorosimError:
    reason = getattr(error, "strerror", None) or str(error).rstrip(".")
    return CocorosimError(
        f"--foxglove has {port}, where no server can listen ({reason}); give another port from 1024 to 65535, such as "
        "8765, or 0 for any that is free."
    )
