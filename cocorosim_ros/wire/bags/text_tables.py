"""Text tables, CSV and TSV, told from other text by how a file begins."""

from __future__ import annotations

import codecs
import re

TABLE_HEAD = 1 << 14  # bytes; enough for the header of a table of a thousand columns and a row below it
_SEPARATORS = (",", ";", "\t", "|", None)  # None: any white space
_MOST_LINES = 20
_NO_TEXT = re.compile("[\x00-\x08\x0e-\x1f]")
_NUMBER = re.compile(r"[-+]?(\d+[.,]?\d*|[.,]\d+)([eE][-+]?\d+)?|[-+]?(nan|inf)|", re.IGNORECASE)


def is_text_table(head: bytes) -> bool:
    """Tell whether a file that begins with these bytes is text in columns, most cells of its last whole line numbers.

    `head` are the first `TABLE_HEAD` bytes of the file, or all that it has.
    """
    lines = _lines(head)
    if len(lines) < 2:
        return False
    return any(_is_table(lines, separator) for separator in _SEPARATORS)


def _lines(head: bytes) -> list[str]:
    """The first whole lines that are neither empty nor a comment; none if it is no text."""
    marked = head.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE))
    text = head.decode("utf-16" if marked else "utf-8-sig", "replace")
    if _NO_TEXT.search(text):
        return []
    lines = text.splitlines()
    whole = lines[:-1] if len(head) >= TABLE_HEAD else lines
    return [line for line in whole if line.strip() and not line.lstrip().startswith(("#", "%"))][:_MOST_LINES]


def _is_table(lines: list[str], separator: str | None) -> bool:
    """Tell whether the last two lines have as many cells, two or more, and those of the last are mostly numbers."""
    before, last = (line.strip("\r\n").split(separator) for line in lines[-2:])
    numbers = sum(bool(_NUMBER.fullmatch(cell.strip().strip('"'))) for cell in last)
    return len(last) == len(before) > 1 and 2 * numbers > len(last)
