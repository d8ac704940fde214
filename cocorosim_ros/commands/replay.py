"""`cocorosim replay`: publishes a recording on its topics again."""

from __future__ import annotations

import os
import time
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path
from types import TracebackType
from typing import TYPE_CHECKING, Any

import click
from rich.console import Console
from rich.progress import BarColumn, Progress, TextColumn

from cocorosim_ros.commands.examples import with_examples
from cocorosim_ros.commands.interruption import INTERRUPTED, Interruption
from cocorosim_ros.commands.json_output import console_beside, give_json, json_option
from cocorosim_ros.commands.terminal import say
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.wire.bags.bag_reader import Bag, read_bag, recording_at
from cocorosim_ros.wire.live.opening import foxglove_port, foxglove_server

if TYPE_CHECKING:
    from cocorosim_ros.graph.nodes.replay import Position, Replay
    from cocorosim_ros.wire.bags.playback import Span

SHOWN_EVERY = 0.1  # s


@dataclass(frozen=True)
class ReplayChoices:
    """The options of one call."""

    bag: Path
    rate: float | None
    fast: bool
    start: float | None
    end: float | None
    loop: bool
    topics: tuple[str, ...]
    wait: int
    reliable: bool
    network: bool
    foxglove: int | None
    json_file: Path | None
    force: bool

    def __post_init__(self) -> None:
        """Raise CocorosimError for options that make no sense or contradict each other."""
        if self.rate is not None and not 0.0 < self.rate < float("inf"):
            raise CocorosimError(f"--rate has {self.rate:g}; give a positive number, or --fast.")
        if self.rate is not None and self.fast:
            raise CocorosimError("--rate and --fast exclude each other; give one of them.")
        if self.wait < 0:
            raise CocorosimError(f"--wait has {self.wait}; give the number of subscriptions to wait for.")


@with_examples("cocorosim replay runs/one", "cocorosim replay runs/one --fast --wait 1 --topics '/lily_01/*'")
@click.command("replay", short_help="publish a recording on its topics again")
@click.argument("bag", type=click.Path(path_type=Path))
@click.option("--rate", type=float, help="seconds of recording per second of wall clock [default: 1]")
@click.option("--fast", is_flag=True, help="as fast as reliable subscriptions acknowledge, so that they lose nothing")
@click.option("--from", "start", type=float, metavar="S", help="begin so many seconds after the first message")
@click.option("--to", "end", type=float, metavar="S", help="end so many seconds after the first message")
@click.option("--loop", is_flag=True, help="begin again at the end, until Ctrl-C")
@click.option("--topics", multiple=True, metavar="PATTERN", help="only topics such as '/lily_01/*' (repeatable)")
@click.option("--wait", type=int, default=0, metavar="N", help="wait for N subscriptions before the first message")
@click.option("--reliable", is_flag=True, help="offer every topic reliably, whatever was recorded")
@click.option("--network", is_flag=True, help="let other machines listen")
@click.option("--foxglove", type=int, metavar="PORT", help="show it to Foxglove or Lichtblick; 0: any free port")
@json_option
@click.option("--force", is_flag=True, help="replace a file that is there")
@click.pass_context
def command(ctx: click.Context, /, **options: object) -> None:
    """Publish BAG (a rosbag2 folder, an .mcap file, or the folder of a run) on its topics again, with /clock.

    Bytes, types and offered qualities of service are the recorded ones. Without a recorded /clock one is made from the
    log times, 40 times a second. Topics whose type is not installed here are left out, which is said.
    /shoal_statistics is left to a metrics node where one publishes them.
    """
    choices = ReplayChoices(**options)  # type: ignore[arg-type]
    console = console_beside(choices.json_file, force=choices.force, inputs=[recording_at(choices.bag)])
    bag = read_bag(choices.bag)
    from cocorosim_ros.wire.bags.playback import choose_span, choose_topics

    span = choose_span(bag, choices.start, choices.end)
    topics = choose_topics(bag, choices.topics)
    if bag.summary.damage:
        say(console, bag.summary.damage, "yellow")
    with Interruption() as interruption:
        tree = _replay(choices, bag, topics, span, console, interruption)
    give_json(console, choices.json_file, tree)
    ctx.exit(INTERRUPTED if interruption.happened else 0)


def _replay(
    choices: ReplayChoices, bag: Bag, topics: list[str], span: Span, console: Console, interruption: Interruption
) -> dict[str, Any]:
    """Publish it; what was done, for programs."""
    from cocorosim_ros.graph.nodes.domain import OwnDomain
    from cocorosim_ros.graph.nodes.node_shell import ros_node
    from cocorosim_ros.graph.nodes.replay import Pace, Replay

    domain = OwnDomain()
    try:
        _prepare_middleware(domain.number, network=choices.network)
        pace = Pace(0.0 if choices.fast else choices.rate or 1.0, choices.loop, choices.wait, choices.reliable)
        with ExitStack() as stack:
            viewers = None
            if choices.foxglove is not None:
                viewers = stack.enter_context(foxglove_server(foxglove_port(choices.foxglove), choices.bag.name))
                say(console, f"Foxglove and Lichtblick: {viewers.address}")
            node = stack.enter_context(ros_node("replay", [], services="later"))
            replay = Replay(node, bag, topics, span, pace, viewers)
            interruption.then(lambda: setattr(replay, "stop", True))
            _announce(console, choices, replay, domain.number)
            replay.wait_for_subscriptions()
            if not replay.subscriptions and not interruption.happened:
                say(console, "nobody listens yet; --wait N waits for N subscriptions")
            start = time.monotonic()
            with _ReplayProgress(console, span, choices.bag.name) as progress:
                replay.run(progress.show)
            seconds = time.monotonic() - start
            say(console, _summary(replay, seconds, fast=choices.fast))
            return _tree(replay, seconds, domain.number)
    finally:
        domain.release()


def _prepare_middleware(domain: int, *, network: bool) -> None:
    """Choose domain, reach and profile for this process; a profile that the user has chosen stays."""
    from cocorosim_ros.graph.nodes.domain import PROFILE_VARIABLES, keep_on_this_machine
    from cocorosim_ros.scenario.reading.config_files import shipped_file

    os.environ["ROS_DOMAIN_ID"] = str(domain)
    keep_on_this_machine(network=network)
    chosen = {os.environ[name] for name in PROFILE_VARIABLES if os.environ.get(name)}
    if chosen <= {str(shipped_file("middleware/fastdds_local.xml"))}:
        profile = shipped_file(f"middleware/fastdds_replay{'_network' if network else ''}.xml")
        os.environ[PROFILE_VARIABLES[0]] = str(profile)


def _announce(console: Console, choices: ReplayChoices, replay: Replay, domain: int) -> None:
    for sentence in replay.left_out:
        say(console, sentence, "yellow")
    clock = ", /clock made from the log times" if replay.makes_clock else ""
    where = "on the network" if choices.network else "on this machine only"
    say(console, f"{len(replay.topics)} topics{clock}, ROS domain {domain}, {where}")
    settings = f"ROS_DOMAIN_ID={domain}" + ("" if choices.network else " ROS_AUTOMATIC_DISCOVERY_RANGE=LOCALHOST")
    say(console, f"to listen: export {settings}")
    if choices.wait:
        say(console, f"waiting for {choices.wait} subscriptions")


def _tree(replay: Replay, seconds: float, domain: int) -> dict[str, Any]:
    position = replay.position
    return {
        "topics": list(replay.topics),
        "left_out": list(replay.left_out),
        "domain": domain,
        "messages": position.messages,
        "rounds": position.rounds + 1,
        "seconds": seconds,
        "behind_at_most_s": position.late,
        "interrupted": replay.stop,
    }


def _summary(replay: Replay, seconds: float, *, fast: bool) -> str:
    position = replay.position
    words = f"{position.messages} messages in {seconds:.2f} s"
    if position.rounds:
        words += f" and {position.rounds + 1} rounds"
    if not fast:
        words += f", at most {position.late * 1e3:.1f} ms behind their time"
    return words + (" (interrupted)" if replay.stop else "")


class _ReplayProgress:
    """A progress bar over the recorded time."""

    def __init__(self, console: Console, span: Span, name: str) -> None:
        self._span = span
        self._bar = Progress(
            TextColumn("{task.description}", markup=False),
            BarColumn(),
            TextColumn("{task.fields[words]}", markup=False),
            console=console,
            transient=not console.is_terminal,
            disable=not console.is_terminal,
        )
        self._task = self._bar.add_task(name, total=max(span.seconds, 1e-9), words="")
        self._start = self._last_shown = time.monotonic()
        self._position: Position | None = None

    def __enter__(self) -> _ReplayProgress:
        self._bar.start()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self._position is not None:
            self._update(self._position)
        self._bar.stop()

    def show(self, position: Position) -> None:
        """Show how far the replay is, a few times a second."""
        self._position = position
        if time.monotonic() - self._last_shown >= SHOWN_EVERY:
            self._update(position)

    def _update(self, position: Position) -> None:
        now = self._last_shown = time.monotonic()
        played = position.after_ns / 1e9
        words = f"{played:.1f} of {self._span.seconds:.1f} s, {position.messages} messages"
        pace = (position.rounds * self._span.seconds + played) / (now - self._start)
        words += ", waiting for a subscriber" if position.held_up else f", {pace:.1f} x real time"
        words += f", round {position.rounds + 1}" if position.rounds else ""
        self._bar.update(self._task, completed=played, words=words)
