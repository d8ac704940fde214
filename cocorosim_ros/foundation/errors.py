"""The errors that a user of cocorosim meets: one, and a kind of it that is about arguments."""

from __future__ import annotations

from collections.abc import Mapping


class CocorosimError(Exception):
    """A sentence for the person who made the mistake: which file, which key, what was found, what to do.

    Commands print it on standard error and end with status 2.
    """


class ArgumentError(CocorosimError):
    """A sentence that names arguments of a function, each in quotes: "The argument 'seed' has ...; give another 'out'".

    A command has options in their place, and says so (`with_options`).
    """

    def __init__(self, sentence: str, *arguments: str) -> None:
        """`arguments`: the names of those that the sentence is about."""
        super().__init__(sentence)
        self.arguments = arguments

    def with_options(self, options: Mapping[str, str]) -> str:
        """The sentence with a command's options, by the names of the arguments, in their places."""
        sentence = str(self)
        for name in self.arguments:
            if name in options:
                quoted = f"'{name}'"
                sentence = sentence.replace(f"The argument {quoted}", options[name]).replace(quoted, options[name])
        return sentence
