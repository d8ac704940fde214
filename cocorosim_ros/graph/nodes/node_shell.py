"""Starting and ending a node process: rclpy, signals, parameter services, errors as sentences."""

from __future__ import annotations

import ctypes
import os
import signal
import sys
import threading
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from typing import Any, Literal

import rclpy
from rclpy.exceptions import InvalidNamespaceException, InvalidNodeNameException
from rclpy.node import Node
from rclpy.signals import SignalHandlerOptions
from rclpy.utilities import remove_ros_args

from cocorosim_ros.foundation.errors import ArgumentError, CocorosimError
from cocorosim_ros.graph.nodes.background import run_callbacks, wait_for_callbacks_to_end
from cocorosim_ros.graph.nodes.rclpy_internals import parameter_services
from cocorosim_ros.graph.runs.run_error import RunError

FAILED, UNUSABLE_INPUT, INTERRUPTED = 1, 2, 130  # exit statuses
_PR_SET_PDEATHSIG, _PR_SET_NAME = 1, 15
_REFUSED_BY_RCL = RuntimeError  # all of rclpy's own errors are of this kind
_UNUSABLE = (InvalidNamespaceException, InvalidNodeNameException, ValueError, _REFUSED_BY_RCL)


AS_PARAMETERS = {"force": "force:=true"}  # arguments as nodes and launch files are given them
LATER = 3.0  # s of wall clock
Services = Literal["now", "later", "never"]


@contextmanager
def ros_node(name: str, arguments: Sequence[str], *, services: Services) -> Iterator[Node]:
    """A node that is shut down at the end; `arguments` are ROS arguments, without the program's name.

    services: with "now" and "later" it logs to /rosout and answers `ros2 param`; with "later" only after LATER seconds,
    so that the start of a swarm in lock-step, and a short run, go without what that costs. Raises CocorosimError for
    arguments that ROS does not take.
    """
    with _living([_started(name, list(arguments), services)], services) as nodes:
        yield nodes[0]


@contextmanager
def ros_nodes(name: str, arguments: Sequence[Sequence[str]], *, services: Services) -> Iterator[list[Node]]:
    """Several nodes of that name in one process, which are one participant of DDS, with the ROS arguments of each.

    Otherwise as `ros_node`.
    """
    with _living(_started_together(name, arguments, services), services) as nodes:
        yield nodes


@contextmanager
def _living(nodes: list[Node], services: Services) -> Iterator[list[Node]]:
    later = threading.Timer(LATER, offer_parameters, nodes)
    try:
        if services == "now":
            for node in nodes:
                run_callbacks(node)
        elif services == "later":
            later.daemon = True
            later.start()
        yield nodes
    finally:
        later.cancel()
        if later.is_alive():
            later.join()
        end_nodes(nodes)


def end_nodes(nodes: Sequence[Node]) -> None:
    """Destroy nodes and shut down their contexts, callbacks first, which must not hold a node any more.

    A node that is destroyed says goodbye; otherwise the others would believe it there for 20 s.
    """
    with suppress(Exception):
        if any(node.executor is not None for node in nodes):
            for node in nodes:
                node.context.try_shutdown()
            wait_for_callbacks_to_end(1.0)
        for node in nodes:
            node.destroy_node()
        for node in nodes:
            node.context.try_shutdown()


def _started(name: str, arguments: list[str], services: Services) -> Node:
    with _sentence_for(name, arguments):
        foreign = remove_ros_args([name, *arguments])[1:]
        if foreign:
            raise CocorosimError(f"{name} does not know '{foreign[0]}'; give --help, or '--ros-args -p NAME:=VALUE'.")
        rclpy.init(args=arguments, signal_handler_options=SignalHandlerOptions.NO)
        return _node(name, services)


def _started_together(name: str, arguments: Sequence[Sequence[str]], services: Services) -> list[Node]:
    rclpy.init(args=[], signal_handler_options=SignalHandlerOptions.NO)
    nodes = []
    for own in arguments:
        with _sentence_for(name, own):
            nodes.append(_node(name, services, cli_args=list(own), use_global_arguments=False))
    return nodes


def _node(name: str, services: Services, **options: Any) -> Node:
    return Node(name, start_parameter_services=services == "now", enable_rosout=services != "never", **options)


@contextmanager
def _sentence_for(name: str, arguments: Sequence[str]) -> Iterator[None]:
    """Raise CocorosimError with the arguments that ROS did not take."""
    try:
        yield
    except _UNUSABLE as error:
        words = " ".join(str(error).partition(", at ")[0].split())
        raise CocorosimError(f"{name} cannot start with the arguments {' '.join(arguments)}: {words}.") from error


def offer_parameters(*nodes: Node) -> None:
    """Let nodes answer `ros2 param` from now on."""
    for node in nodes:
        parameter_services(node)
        run_callbacks(node)


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


def show_as(name: str) -> None:
    """Let `ps -o comm` and `top` show this process under that name, of which the kernel keeps 15 bytes."""
    ctypes.CDLL(None).prctl(_PR_SET_NAME, name.encode(), 0, 0, 0)


def run_main(main: Callable[[Sequence[str]], None], usage: str) -> int:
    """Run a node's entry point: `--help` prints `usage`, an error is one sentence and status 1 or 2."""
    arguments = sys.argv[1:]
    if {"-h", "--help"} & set(arguments):
        sys.stdout.write(usage.strip() + "\n")
        return 0
    try:
        main(arguments)
    except CocorosimError as error:
        words = error.with_options(AS_PARAMETERS) if isinstance(error, ArgumentError) else str(error)
        sys.stderr.write(f"{words}\n")
        return FAILED if isinstance(error, RunError) else UNUSABLE_INPUT
    except KeyboardInterrupt:
        return INTERRUPTED
    return 0
