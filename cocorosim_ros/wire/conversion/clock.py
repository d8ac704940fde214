"""Times that were written down as a date and a time of day, `2025/04/11 12:08:14.676961101`.

Some loggers count the nanoseconds behind the point and leave out the zeros before them: `.4067` is then 4067 ns.
"""

from __future__ import annotations

from dataclasses import dataclass
from datetime import UTC, datetime, timedelta
from functools import lru_cache

from cocorosim_ros.scenario.reading.entry import Entry

_EPOCH, _SECOND = datetime(1970, 1, 1, tzinfo=UTC), timedelta(seconds=1)
_DIGITS = 9  # of a second in nanoseconds


@dataclass(frozen=True)
class Clock:
    """A column of dates and times of day, and how they are written."""

    column: Entry
    form: str  # of the whole seconds, as `strptime` has it
    counts: bool  # whether nanoseconds are counted behind the point, else its digits are a decimal fraction
    ahead_ns: int = 0  # how far the clock is ahead of UTC

    def nanoseconds(self, text: str) -> int:
        """Since 1970, UTC. Raises ArithmeticError for what is not written in that form."""
        pieces, points = text.split("."), self.form.count(".")
        whole, fraction = ".".join(pieces[: points + 1]), ".".join(pieces[points + 1 :])
        if not (fraction or "0").isdecimal() or len(fraction) > _DIGITS:
            raise ArithmeticError(text)
        behind = int((fraction if self.counts else fraction.ljust(_DIGITS, "0")) or 0)
        return _seconds(whole, self.form) * 1_000_000_000 + behind - self.ahead_ns


@lru_cache(maxsize=4)
def _seconds(text: str, form: str) -> int:
    """Whole seconds since 1970 of the clock's own zone; rows of one second follow each other."""
    try:
        return (datetime.strptime(text, form).replace(tzinfo=UTC) - _EPOCH) // _SECOND
    except ValueError as error:
        raise ArithmeticError(text) from error
