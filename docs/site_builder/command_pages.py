"""What `cocorosim COMMAND --help` says, for the page of commands."""

from __future__ import annotations

import click

from cocorosim_ros.commands.main import COMMANDS, cocorosim
from site_builder.markdown import block

_WIDTH = 100  # characters of a line of help


def command_helps() -> str:
    """Every sub-command with its help, a heading each."""
    return "\n\n".join(f"## {name}\n\n{block(_help(name))}" for name in COMMANDS)


def _help(name: str) -> str:
    root = click.Context(cocorosim, info_name="cocorosim", terminal_width=_WIDTH, max_content_width=_WIDTH)
    command = cocorosim.get_command(root, name)
    if command is None:
        raise ValueError(f"'{name}' stands among the commands, and there is none.")
    return command.get_help(click.Context(command, parent=root, info_name=name))
