"""How a result shows itself: the same few facts as lines in a shell and as a small table in a notebook."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from html import escape

_MOST_ROWS = 20
_MOST_REMARKS = 8


@dataclass(frozen=True)
class Card:
    """What a result shows of itself.

    facts: name and value of what there is one of. rows: a table below `headings`. remarks: sentences.
    """

    title: str
    facts: Mapping[str, str]
    headings: tuple[str, ...] = ()
    rows: Sequence[Sequence[str]] = ()
    remarks: Sequence[str] = field(default=())


class Shown(ABC):
    """A result that shows itself in a shell and in a notebook."""

    @abstractmethod
    def card(self) -> Card:
        """What there is to be shown."""

    def sketch(self) -> str:
        """A drawing of it as HTML, for a notebook; "" for none."""
        return ""

    def __repr__(self) -> str:
        try:
            return card_text(self.card())
        except (TypeError, ValueError, LookupError, AttributeError):  # made by hand of what it cannot hold
            return object.__repr__(self)

    def _repr_html_(self) -> str:
        return card_html(self.card(), self.sketch())


def card_text(card: Card) -> str:
    """The title and the facts in one line, for a shell."""
    facts = ", ".join(f"{name} {value}" for name, value in card.facts.items())
    return f"<{card.title}: {facts}>" if facts else f"<{card.title}>"


def card_html(card: Card, sketch: str = "") -> str:
    """The card as HTML that needs no style sheet, no script and no other file; a sketch stands below the facts."""
    parts = [f"<strong>{escape(card.title)}</strong>"]
    parts.append(
        _table([(f"<th>{escape(name)}</th>", f"<td>{escape(value)}</td>") for name, value in card.facts.items()])
    )
    parts += [sketch] if sketch else []
    if card.rows:
        head = tuple(f"<th>{escape(heading)}</th>" for heading in card.headings)
        body = [tuple(f"<td>{escape(cell)}</td>" for cell in row) for row in card.rows[:_MOST_ROWS]]
        parts.append(_table([head, *body]))
    parts += [_line(f"{len(card.rows) - _MOST_ROWS} more rows")] if len(card.rows) > _MOST_ROWS else []
    parts += [_line(escape(remark)) for remark in card.remarks[:_MOST_REMARKS]]
    parts += [_line(f"{len(card.remarks) - _MOST_REMARKS} more remarks")] if len(card.remarks) > _MOST_REMARKS else []
    return f"<div>{''.join(parts)}</div>"


def card_markdown(card: Card) -> str:
    """The card as Markdown: title, facts, table and remarks, each whole."""
    lines = [f"### {card.title}", "", *(f"- {name}: {value}" for name, value in card.facts.items())]
    if card.rows:
        rows = [card.headings, ["---"] * len(card.headings), *card.rows]
        lines += ["", *(f"| {' | '.join(cell.replace('|', chr(92) + '|') for cell in row)} |" for row in rows)]
    lines += [part for remark in card.remarks for part in ("", f"> {remark}")]
    return "\n".join(lines) + "\n"


def digits(value: float | None) -> str:
    """A number with four significant digits; a dash where there is none."""
    return "-" if value is None or math.isnan(value) else f"{value:.4g}"


def _table(rows: Sequence[tuple[str, ...]]) -> str:
    return "<table>" + "".join(f"<tr>{''.join(row)}</tr>" for row in rows) + "</table>" if rows else ""


def _line(text: str) -> str:
    return f"<p>{text}</p>"
