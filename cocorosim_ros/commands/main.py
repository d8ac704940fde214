"""`cocorosim`: the one command, its sub-commands and how its errors are shown."""

from __future__ import annotations

import importlib
import sys
from typing import Any

import click

from cocorosim_ros import __version__
from cocorosim_ros.commands.interruption import INTERRUPTED
from cocorosim_ros.commands.missing_package import missing_package
from cocorosim_ros.commands.path_sentence import path_sentence
from cocorosim_ros.foundation.errors import ArgumentError, CocorosimError

UNUSABLE_INPUT = 2
COMMANDS: dict[str, str] = {
    "run": "run a scenario: node graph, recording, statistics, picture",
    "replay": "publish a recording on its topics again",
    "calibrate": "Lily's calibration from the published measurements, or a platform fitted to a recording",
    "view": "look at a recording: a page that plays it",
    "metrics": "shoaling statistics of any recording that has poses",
    "check": "what is odd about any robot's recording, in seconds: clocks, rates, frames, covariances, units",
    "diagnose": "where a recording and the model of a platform disagree, why, and a model that does not",
    "convert": "other people's logs (tables, bags of ROS 1 and 2, ULog, DataFlash, tlog) into the contract's recording",
    "experiment": "many runs without ROS, resumable, as one table",
    "report": "an experiment's table as a page with figures and tables",
    "claims": "the paper's claims beside what experiments show",
    "figure4": "which reading of what the paper leaves open gives back its figure 4",
    "new": "a commented platform, controller, scenario or map to begin with",
    "doctor": "what is installed, whether two processes can talk and how fast, cache and folders",
    "explain": "what a key, an effect, a metric, a topic or a controller means: unit, range, default, source, users",
    "digest": "the digest of recordings, and where two of them differ",
}


_COMPLETION = """\b
The tab key completes commands, options and names of scenarios, platforms,
controllers, effects and metrics after (or with zsh_source, fish_source)
  eval "$(_COCOROSIM_COMPLETE=bash_source cocorosim)"
"""


class _Commands(click.Group):
    """Loads a sub-command only when it is used, so that `--help` and errors are quick."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        return list(COMMANDS)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        if cmd_name not in COMMANDS:
            return None
        module = importlib.import_module(f"cocorosim_ros.commands.{cmd_name}")
        command: click.Command = module.command
        return command

    def invoke(self, ctx: click.Context) -> Any:
        """Run the sub-command; what is said of an argument of the library is said of its option."""
        try:
            return super().invoke(ctx)
        except ArgumentError as error:
            chosen = self.get_command(ctx, ctx.invoked_subcommand or "")
            raise CocorosimError(error.with_options(_options(chosen))) from error

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        with formatter.section("Commands"):
            formatter.write_dl(list(COMMANDS.items()))


def _options(command: click.Command | None) -> dict[str, str]:
    """The options of a command, such as `--group`, by the names of the arguments that they stand for."""
    given = [part for part in command.params if isinstance(part, click.Option)] if command else []
    return {name: part.opts[0] for part in given for name in (part.opts[0].lstrip("-"), str(part.name))}


@click.group(cls=_Commands, epilog=_COMPLETION)
@click.version_option(__version__, prog_name="cocorosim")
def cocorosim() -> None:
    """Swarms of small underwater robots as a ROS 2 node graph."""


def main() -> None:
    """Entry point: an error is one sentence on standard error and status 2."""
    try:
        status = cocorosim.main(prog_name="cocorosim", standalone_mode=False)
        sys.exit(status if isinstance(status, int) else 0)
    except click.Abort:
        sys.exit(INTERRUPTED)
    except BrokenPipeError:
        sys.exit(0)
    except (CocorosimError, click.ClickException, ModuleNotFoundError, OSError) as error:
        sentence = _sentence(error)
        if sentence is None:
            raise
        click.echo(f"cocorosim: {sentence}", err=True)
        sys.exit(UNUSABLE_INPUT)


def _sentence(error: Exception) -> str | None:
    """What is said of an error; None for one that is a fault of ours and keeps its traceback."""
    if isinstance(error, click.ClickException):
        return error.format_message()
    if isinstance(error, ModuleNotFoundError):
        missing = missing_package(error.name or "")
        return None if missing is None else str(missing)
    return path_sentence(error) if isinstance(error, OSError) else str(error)
