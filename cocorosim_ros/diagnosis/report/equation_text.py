"""Equations written plainly, as in the catalogue, typeset for a page: italics, subscripts, powers, Greek."""

from __future__ import annotations

import re

from markupsafe import Markup, escape

_GREEK = {
    "alpha": "\u03b1", "beta": "\u03b2", "gamma": "\u03b3", "delta": "\u03b4", "epsilon": "\u03b5", "lambda": "\u03bb",
    "mu": "\u03bc", "nu": "\u03bd", "omega": "\u03c9", "phi": "\u03c6", "pi": "\u03c0", "psi": "\u03c8",
    "rho": "\u03c1", "sigma": "\u03c3", "tau": "\u03c4", "theta": "\u03b8", "Delta": "\u0394",
}  # fmt: skip
_TOKEN = re.compile(
    r"(?P<power>\^(?:\([^()]*\)|-?[A-Za-z0-9.]+))|(?P<name>[A-Za-z]+)(?P<below>_[A-Za-z0-9]+)?"
    r"|(?P<sign>~|<=|>=|->|[*-])|(?P<rest>.)",
    re.DOTALL,
)
_SIGNS = {"~": "\u223c", "<=": "\u2264", ">=": "\u2265", "->": "\u2192", "*": "\u2009\u00b7\u2009", "-": "\u2212"}


def typeset(equation: str) -> Markup:
    """The equation as HTML that may stand in a line of text."""
    compact = re.sub(r"\s*\*\s*", "*", re.sub(r"\s*(\*\*|\^)\s*", "^", equation))
    return Markup("").join(_typeset(match) for match in _TOKEN.finditer(compact))


def _typeset(match: re.Match[str]) -> Markup:
    if match["power"]:
        inner = match["power"].lstrip("^").removeprefix("(").removesuffix(")")
        return Markup("<sup>{}</sup>").format(typeset(inner))
    if match["name"]:
        below = Markup("<sub>{}</sub>").format(match["below"][1:]) if match["below"] else Markup("")
        return _name(match["name"]) + below
    if match["sign"]:
        return Markup(_SIGNS[match["sign"]])
    return escape(match["rest"])


def _name(name: str) -> Markup:
    if name in _GREEK:
        return Markup("<i>{}</i>").format(_GREEK[name])
    return escape(name) if len(name) > 1 else Markup("<i>{}</i>").format(name)
