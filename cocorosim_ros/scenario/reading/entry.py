"""One place in a YAML file: its value and where it stands, for complaints that name file, line and key."""

from __future__ import annotations

import difflib
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from cocorosim_ros.foundation.errors import ArgumentError, CocorosimError

_LONGEST_SHOWN = 60
_ARGUMENT = "the argument"  # how the origin of a value begins that was given to a function


@dataclass(frozen=True)
class Entry:
    """A value of a YAML file with its place.

    value: text, number, truth value, None, dict of name to Entry, or list of Entry.
    line: counted from 1; 0 when the value does not come from a file.
    key: dotted path from the top of the file, '' for the top itself.
    """

    value: Any
    file: str
    line: int
    key: str

    def problem(self, sentence: str) -> CocorosimError:
        """The error to raise: file, line and key, then `sentence`, as one line whatever the value is.

        Of an argument, an ArgumentError that names it.
        """
        if self.file.startswith(_ARGUMENT) and not self.line:
            told = " ".join(f"The argument '{self.key}' {sentence}".split())
            return ArgumentError(told, self.key.partition("[")[0].partition(".")[0])
        place = f"{self.file} line {self.line}" if self.line else self.file
        told = f"{place}: '{self.key}' {sentence}" if self.key else f"{place}: {sentence}"
        return CocorosimError(" ".join(told.split()))

    def found(self) -> str:
        """The value as the sentence shows it."""
        if isinstance(self.value, dict):
            return "a mapping"
        if isinstance(self.value, list):
            return f"[{', '.join(part.found().strip(chr(39)) for part in self.value)}]"
        if self.value is None:
            return "nothing"
        if isinstance(self.value, bool):
            return "'true'" if self.value else "'false'"
        shown = str(self.value)
        return f"'{shown if len(shown) <= _LONGEST_SHOWN else shown[:_LONGEST_SHOWN] + '...'}'"

    def section(self, required: Iterable[str] = (), optional: Iterable[str] = ()) -> dict[str, Entry]:
        """The entries of a mapping that has all required keys and none beyond the optional ones."""
        entries = self.mapping()
        required = list(required)
        allowed = list(dict.fromkeys((*required, *optional)))
        for name, entry in entries.items():
            if name not in allowed:
                raise entry.problem(f"is not a known key{nearest(name, allowed)}.")
        missing = [name for name in required if name not in entries]
        if missing:
            raise self.problem(f"lacks {quoted(missing)}; add {'it' if len(missing) == 1 else 'them'}.")
        return entries

    def mapping(self) -> dict[str, Entry]:
        """The entries of a mapping with any keys."""
        if not isinstance(self.value, dict):
            raise self.problem(f"has {self.found()} where a mapping is needed; write 'name: value' lines under it.")
        return self.value

    def items(self) -> list[Entry]:
        """The entries of a list."""
        if not isinstance(self.value, list):
            raise self.problem(f"has {self.found()} where a list is needed; write it as [..., ...] or as '- ' lines.")
        return self.value

    def text(self) -> str:
        """The value as text that is not empty."""
        if not isinstance(self.value, str) or not self.value.strip():
            raise self.problem(
                f"has {self.found()} where text is needed; put quotes around it if it looks like a number."
            )
        return self.value

    def flag(self) -> bool:
        """The value as true or false."""
        if not isinstance(self.value, bool):
            raise self.problem(f"has {self.found()}; write true or false.")
        return self.value

    def choice(self, options: Sequence[str]) -> str:
        """The value as one of the options."""
        if self.value not in options:
            raise self.problem(f"has {self.found()}{nearest(str(self.value), options)}.")
        return str(self.value)

    def whole_number(self, least: int, most: int) -> int:
        """The value as an integer from `least` to `most`."""
        if isinstance(self.value, bool) or not isinstance(self.value, int) or not least <= self.value <= most:
            raise self.problem(f"has {self.found()}; write a whole number from {least} to {most}.")
        return self.value


def entry_of(tree: Any, origin: str, key: str = "") -> Entry:
    """Plain values (dict, list, text, numbers) as entries; complaints name `origin` instead of a file."""
    value = tree
    if isinstance(tree, Mapping):
        value = {name: entry_of(part, origin, f"{key}.{name}" if key else name) for name, part in tree.items()}
    elif isinstance(tree, (list, tuple)):
        value = [entry_of(part, origin, f"{key}[{i}]") for i, part in enumerate(tree)]
    return Entry(value, origin, 0, key)


def argument_entry(value: Any, name: str) -> Entry:
    """Plain values that a function was given as an argument; complaints name that."""
    return entry_of(value, f"{_ARGUMENT} '{name}'", name)


def plain_value(entry: Entry) -> Any:
    """The value of an entry without the places: dict, list, text, number, truth value or None."""
    if isinstance(entry.value, dict):
        return {name: plain_value(part) for name, part in entry.value.items()}
    if isinstance(entry.value, list):
        return [plain_value(part) for part in entry.value]
    return entry.value


def quoted(names: Iterable[str]) -> str:
    """The names in quotes, with commas and a last 'and'."""
    return listed((f"'{name}'" for name in names), "and")


def listed(words: Iterable[str], last: str = "or") -> str:
    """The words with commas, and `last` before the last one."""
    every = list(words)
    return " ".join([", ".join(every[:-1]), last, every[-1]]) if len(every) > 1 else "".join(every)


def nearest(word: str, options: Iterable[str]) -> str:
    """The end of a complaint about an unknown word: the nearest match, and everything that is allowed."""
    allowed = list(options)
    close = difflib.get_close_matches(word, allowed, n=1)
    guess = f"; did you mean '{close[0]}'?" if close else ""
    return f"{guess}{' Allowed' if guess else '; allowed'}: {', '.join(allowed) or 'nothing'}"
