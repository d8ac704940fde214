"""Callbacks of nodes, run by one executor in a thread of its own until rclpy is shut down."""

from __future__ import annotations

import threading
from contextlib import suppress
from weakref import WeakKeyDictionary

from rclpy.context import Context
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.node import Node

_threads: WeakKeyDictionary[Context, _CallbackThread] = WeakKeyDictionary()


def run_callbacks(node: Node) -> None:
    """Run what the node is called back for, beside all other nodes of its context; a second call changes nothing."""
    if node.executor is not None:
        return
    if node.context not in _threads:
        _threads[node.context] = _CallbackThread(node.context)
    _threads[node.context].executor.add_node(node)


def wait_for_callbacks_to_end(seconds: float) -> None:
    """Return when no callback of a context that has been shut down runs any more, or after `seconds`."""
    for context in [context for context in _threads if not context.ok()]:
        _threads.pop(context).thread.join(seconds)


class _CallbackThread:
    """The executor of one context."""

    def __init__(self, context: Context) -> None:
        self.executor = SingleThreadedExecutor(context=context)
        self.thread = threading.Thread(target=self._spin, daemon=True)
        self.thread.start()

    def _spin(self) -> None:
        with suppress(ExternalShutdownException, RuntimeError):
            self.executor.spin()
