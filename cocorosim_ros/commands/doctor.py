"""`cocorosim doctor`: whether what the work needs is here, and whether two processes can talk."""

from __future__ import annotations

import os
import statistics
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import click
from rich.table import Table
from rich.text import Text

from cocorosim_ros.commands.examples import with_examples
from cocorosim_ros.commands.json_output import console_beside, give_json, json_option
from cocorosim_ros.commands.missing_package import check_ros
from cocorosim_ros.commands.terminal import say, show_table
from cocorosim_ros.foundation.errors import CocorosimError

if TYPE_CHECKING:
    from cocorosim_ros.library.health import Finding

LACKING = 1  # exit status
_STYLES = {"good": "green", "absent": "yellow", "bad": "red"}
_QUESTIONS, _LIMIT = 100, 30.0  # s


@with_examples("cocorosim doctor")
@click.command(
    "doctor",
    short_help="what is installed, and whether two processes can talk",
    epilog="Exit status: 0 all that is essential is here; 1 something essential lacks. ROS is not essential: "
    "without it scenarios run with --in-process, and recordings are read as with it.",
)
@json_option
@click.option("--force", is_flag=True, help="replace a file that is there")
@click.pass_context
def command(ctx: click.Context, /, json_file: Path | None, force: bool) -> None:
    """Look at the interpreter, packages, configuration, cache, folders, middleware and processors."""
    from cocorosim_ros.library.health import examine

    console = console_beside(json_file, force=force)
    findings = [*examine(), *_middleware()]
    table = Table(title_justify="left")
    for heading in ("what", "state", "found"):
        table.add_column(heading)
    for each in findings:
        table.add_row(each.name, Text(each.state, style=_STYLES[each.state]), Text(each.words))
    show_table(console, table)
    lacking = [each.name for each in findings if each.state == "bad"]
    say(console, f"Lacking: {', '.join(lacking)}." if lacking else "All that is essential is here.")
    tree = [{"name": each.name, "state": each.state, "found": each.words} for each in findings]
    give_json(console, json_file, {"healthy": not lacking, "findings": tree})
    ctx.exit(LACKING if lacking else 0)


def _middleware() -> Iterator[Finding]:
    """Whether ROS is here, and how fast two processes talk over it."""
    from cocorosim_ros.library.health import Finding

    try:
        check_ros("give --in-process to `cocorosim run`, which does the same run without ROS")
    except CocorosimError as error:
        yield Finding("ros", "absent", str(error))
        return
    from cocorosim_ros.graph.nodes.conversation import installation, round_trips
    from cocorosim_ros.graph.nodes.domain import OwnDomain, keep_on_this_machine

    place, name = installation()
    distribution = f", ROS_DISTRO is {os.environ['ROS_DISTRO']}" if "ROS_DISTRO" in os.environ else ""
    yield Finding("ros", "good", f"rclpy in {place}{distribution}")
    domain = OwnDomain()
    os.environ["ROS_DOMAIN_ID"] = str(domain.number)
    keep_on_this_machine(network=False)
    try:
        times = round_trips(_QUESTIONS, _LIMIT)
    finally:
        domain.release()
    if len(times) < _QUESTIONS:
        words = f"{name}: two processes on this machine exchanged {len(times)} of {_QUESTIONS} messages in {_LIMIT:g} s"
        yield Finding("middleware", "bad", f"{words}; look at firewall, loopback interface and {_profile()}")
        return
    middle, most = 1e3 * statistics.median(times), 1e3 * max(times)
    yield Finding("middleware", "good", f"{name}: question and answer in {middle:.2g} ms, {most:.2g} ms at most")


def _profile() -> str:
    from cocorosim_ros.graph.nodes.domain import PROFILE_VARIABLES

    return next((f"{name}={os.environ[name]}" for name in PROFILE_VARIABLES if os.environ.get(name)), "the profile")
