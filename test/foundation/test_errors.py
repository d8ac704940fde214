"""Sentences about arguments, and the same about a command's options."""

from __future__ import annotations

import pickle

from cocorosim_ros.foundation.errors import ArgumentError, CocorosimError


def test_a_command_says_its_options() -> None:
    """Where the command has one for the argument; other words in quotes stay."""
    error = ArgumentError(
        "The argument 'seed' has 'out'; give another 'folder', or 'force'.", "seed", "force", "folder"
    )
    assert isinstance(error, CocorosimError)
    options = {"seed": "--seed", "force": "--force", "out": "--out"}
    assert error.with_options(options) == "--seed has 'out'; give another 'folder', or --force."
    assert error.with_options({}) == str(error)


def test_it_comes_back_from_another_process() -> None:
    """Workers hand their errors over as bytes."""
    error = pickle.loads(pickle.dumps(ArgumentError("The argument 'out' is full.", "out")))
    assert (str(error), error.arguments) == ("The argument 'out' is full.", ("out",))
