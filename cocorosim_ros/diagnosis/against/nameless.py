"""Differences that no entry of the catalogue explains: they count where recordings that are alike have none.

Laws outside the catalogue are many, and their evidence is not divided by what alike recordings differ in beyond the
best of them. Where those of a sound vehicle differ among themselves by such a law, another law says nothing.
"""

from __future__ import annotations

from collections.abc import Sequence

from cocorosim_ros.diagnosis.catalogue.law_words import identifier_words
from cocorosim_ros.world.laws.law import UNKNOWN


def differ_namelessly(control: Sequence[str]) -> bool:
    """Tell whether alike recordings differ from each other by a law outside the catalogue; control: names of theirs."""
    return any(name.startswith(UNKNOWN) for name in control)


def left_over_words(law: str, control: Sequence[str]) -> tuple[str, ...]:
    """Words of a warning of a difference that has no name: that of a law, '' for none.

    control: names of what alike recordings differ in.
    """
    if not law:
        return ()
    words = identifier_words(law)
    if differ_namelessly(control):
        return (
            f"What is left over looks like {words}; but the recordings of --against differ among themselves by "
            "something that no entry of the catalogue explains either, so that this is no difference.",
        )
    return (
        f"Something differs that no entry of the catalogue clearly explains. It looks like {words}, "
        "but this often stands in for something else; look at the residuals.",
    )
