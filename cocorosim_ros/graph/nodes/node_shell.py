"""Starting and ending a node process: rclpy, signals, parameter services, errors as sentences."""

from __future__ import annotations

import ctypes
import os
import signal
import sys
import threading
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress

import rclpy
from rclpy.exceptions import InvalidNamespaceException, InvalidNodeNameException
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.impl.implementation_singleton import rclpy_implementation
from rclpy.node import Node
from rclpy.signals import SignalHandlerOptions
from rclpy.utilities import remove_ros_args

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.graph.runs.run_error import RunError

FAILED, UNUSABLE_INPUT, INTERRUPTED = 1, 2, 130  # exit statuses
_PR_SET_PDEATHSIG = 1
_UNUSABLE = (
    rclpy_implementation.RCLError,
    rclpy_implementation.RCLInvalidROSArgsError,
    InvalidNamespaceException,
    InvalidNodeNameException,
    ValueError,
)


@contextmanager
def ros_node(name: str, arguments: Sequence[str], *, services: bool) -> Iterator[Node]:
    """A node that is shut down at the end; `arguments` are ROS arguments, without the program's name.

    With `services` the node answers `ros2 param` and logs to /rosout; a supervised node does without, which
    halves the start of a swarm. Raises CocorosimError for arguments that ROS does not take.
    """
    node = _started(name, list(arguments), services=services)
    server = threading.Thread(target=_serve, args=(node,), daemon=True)
    try:
        if services:
            server.start()
        yield node
    finally:
        with suppress(Exception):
            if services:
                rclpy.shutdown()  # ends the server, which must not hold the node any more
                server.join(timeout=1.0)
            node.destroy_node()  # says goodbye; otherwise the others would believe it there for 20 s
            rclpy.shutdown()


def _started(name: str, arguments: list[str], *, services: bool) -> Node:
    try:
        foreign = remove_ros_args([name, *arguments])[1:]
        if foreign:
            raise CocorosimError(f"{name} does not know '{foreign[0]}'; give --help, or '--ros-args -p NAME:=VALUE'.")
        rclpy.init(args=arguments, signal_handler_options=SignalHandlerOptions.NO)
        return Node(name, start_parameter_services=services, enable_rosout=services)
    except _UNUSABLE as error:
        words = " ".join(str(error).partition(", at ")[0].split())
        raise CocorosimError(f"{name} cannot start with the arguments {' '.join(arguments)}: {words}.") from error


def _serve(node: Node) -> None:
    """Answer the node's parameter services until rclpy is shut down."""
    executor = SingleThreadedExecutor()
    executor.add_node(node)
    with suppress(ExternalShutdownException, RuntimeError):
        executor.spin()


def on_termination(stop: Callable[[], None], *, supervised: bool) -> None:
    """Call `stop` on SIGTERM and SIGINT; a supervised node leaves SIGINT (Ctrl-C) to its supervisor."""
    signal.signal(signal.SIGTERM, lambda number, frame: stop())
    signal.signal(signal.SIGINT, signal.SIG_IGN if supervised else lambda number, frame: stop())


def end_with_parent(parent: int, how: signal.Signals) -> None:
    """Ask the kernel to end this process by signal `how` when its parent (a process id) dies.

    So no node outlives its supervisor; SIGKILL ends one that hangs, too. The kernel means the thread that forked:
    fork from the main thread.
    """
    ctypes.CDLL(None).prctl(_PR_SET_PDEATHSIG, how)
    if os.getppid() != parent:
        os.kill(os.getpid(), how)


def run_main(main: Callable[[Sequence[str]], None], usage: str) -> int:
    """Run a node's entry point: `--help` prints `usage`, an error is one sentence and status 1 or 2."""
    arguments = sys.argv[1:]
    if {"-h", "--help"} & set(arguments):
        sys.stdout.write(usage.strip() + "\n")
        return 0
    try:
        main(arguments)
    except CocorosimError as error:
        sys.stderr.write(f"{error}\n")
        return FAILED if isinstance(error, RunError) else UNUSABLE_INPUT
    except KeyboardInterrupt:
        return INTERRUPTED
    return 0
