"""Words for nats, told where the word is first seen."""

from __future__ import annotations

import re

NATS_IN_WORDS = "each of which makes it 2.7 times as likely"
_NATS = re.compile(r"\bnats?\b")
# What is not text of a page: styles and scripts with their content, and tags.
_NO_TEXT = re.compile(r"<(style|script)\b.*?</\1>|<[^>]*>", re.DOTALL)


def explained_at_first_sight(page: str) -> str:
    """The page with an explanation behind the first "nats" of its text, if there is one.

    That must not stand in a picture, where it has no room.
    """
    begin = 0
    for hidden in _NO_TEXT.finditer(page):
        found = _NATS.search(page, begin, hidden.start())
        if found is not None:
            return f"{page[: found.end()]}, {NATS_IN_WORDS}{page[found.end() :]}"
        begin = hidden.end()
    return page
