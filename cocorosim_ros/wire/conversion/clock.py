"""Times that were written down as a date and a time of day, `2025/04/11 12:08:14.676961101`.

Some loggers count the nanoseconds behind the point and leave out the zeros before them: `.4067` is then 4067 ns.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from datetime import UTC, datetime, timedelta
from functools import lru_cache

from cocorosim_ros.scenario.reading.entry import Entry

FIELDS: dict[str, str] = {
    **dict.fromkeys("dHImMSUWV", r"[ \d]?\d"),  # one digit, or two; `strptime` takes a space in place of a zero
    **dict.fromkeys("YG", r"\d{4}"),
    **dict.fromkeys("wu", r"\d"),
    **dict.fromkeys("aAbBp", r"\D+?"),
    "y": r"\d\d",
    "j": r"\d{1,3}",
    "%": "%",
}
"""What may stand behind % in a form, as in `strptime`, with a pattern that fits at least what that reads."""
_EPOCH, _SECOND = datetime(1970, 1, 1, tzinfo=UTC), timedelta(seconds=1)
_DIGITS = 9  # of a second in nanoseconds
_PIECES = re.compile(r"%.|\s+|.", re.DOTALL)


@dataclass(frozen=True)
class Clock:
    """A column of dates and times of day, and how they are written."""

    column: Entry
    form: str  # of the whole seconds, as `strptime` has it
    counts: bool  # whether nanoseconds are counted behind the point, else its digits are a decimal fraction
    ahead_ns: int = 0  # how far the clock is ahead of UTC; negative behind it

    def nanoseconds(self, text: str, mark: str = ".") -> int:
        """Since 1970, UTC; the fraction stands behind the seconds and a point, or behind that mark.

        Raises ArithmeticError for what is not written in that form.
        """
        found = _pattern(self.form, mark).fullmatch(text)
        if found is None:
            raise ArithmeticError(text)
        begin, end = found.span("fraction") if "fraction" in found.re.groupindex else (len(text), len(text))
        fraction = text[begin:end].lstrip(f".{mark}")
        behind = int((fraction if self.counts else fraction.ljust(_DIGITS, "0")) or 0)
        return _seconds(text[:begin] + text[end:], self.form) * 1_000_000_000 + behind - self.ahead_ns


def fields_of(form: str) -> list[str]:
    """The fields of a form in order, `%Y`; a last % alone too."""
    return [piece for piece in _PIECES.findall(form) if piece.startswith("%")]


def comes_back(form: str) -> bool:
    """Tell whether a moment that is written in that form can be read again: its date, and what it has of the time."""
    # All fields differ, so that none stands for another; in the afternoon, so that hours to 12 need their %p.
    moment = datetime(2023, 11, 25, 14, 37, 52)
    try:
        read = datetime.strptime(moment.strftime(form), form)
    except (ValueError, re.error):  # `strptime` lets through what its own pattern does not take: fields twice
        return False
    hour, minute = moment.replace(minute=0, second=0), moment.replace(second=0)
    return read in (moment, minute, hour, hour.replace(hour=0))


@lru_cache(maxsize=16)
def _pattern(form: str, mark: str) -> re.Pattern[str]:
    """The pattern of a form's cells; its group `fraction` is what stands behind the seconds, with its point."""
    text = ""
    for piece in _PIECES.findall(form):
        if piece.isspace():
            text += r"\s+"
        else:
            text += f"(?:{FIELDS[piece[1]]})" if piece.startswith("%") else re.escape(piece)
        if piece == "%S":
            text += rf"(?P<fraction>(?:[.{re.escape(mark)}]\d{{0,{_DIGITS}}})?)"
    return re.compile(text, re.IGNORECASE)


@lru_cache(maxsize=4)
def _seconds(text: str, form: str) -> int:
    """Whole seconds since 1970 of the clock's own zone; rows of one second follow each other."""
    try:
        return (datetime.strptime(text, form).replace(tzinfo=UTC) - _EPOCH) // _SECOND
    except ValueError as error:
        raise ArithmeticError(text) from error
