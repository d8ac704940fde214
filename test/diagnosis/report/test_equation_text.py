"""Plain equations typeset for a page."""

from __future__ import annotations

import pytest

from cocorosim_ros.diagnosis.report.equation_text import typeset


@pytest.mark.parametrize(
    ("plain", "html"),
    [
        ("N = -d_r * r", "<i>N</i> = \u2212<i>d</i><sub>r</sub>\u2009\u00b7\u2009<i>r</i>"),
        ("|u|^0.5*u", "|<i>u</i>|<sup>0.5</sup>\u2009\u00b7\u2009<i>u</i>"),
        ("c sin(omega t + phase)", "<i>c</i> sin(<i>\u03c9</i> <i>t</i> + phase)"),
        ("a < b & c", "<i>a</i> &lt; <i>b</i> &amp; <i>c</i>"),
        ("x ** (2 - n)", "<i>x</i><sup>2 \u2212 <i>n</i></sup>"),
        ("exp(-t/tau)", "exp(\u2212<i>t</i>/<i>\u03c4</i>)"),
    ],
)
def test_equations(plain: str, html: str) -> None:
    """Variables in italics, functions upright, powers high, signs as in print, nothing that could be markup."""
    assert str(typeset(plain)) == html
