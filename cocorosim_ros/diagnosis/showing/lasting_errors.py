"""Remarks on errors of readings that last."""

from __future__ import annotations

import math

from cocorosim_ros.diagnosis.fitting.fit import Fit
from cocorosim_ros.diagnosis.tracks.columns import NOISE_WORDS, READING_MEMORY, WANDER
from cocorosim_ros.foundation.units.quantity_text import said_quantity


def memory_remarks(fit: Fit) -> tuple[str, ...]:
    """Sentences on errors that a fit reckons to last, one for each robot and kind of readings."""
    return tuple(
        f"Errors of {_words(unknown.column)} of {', '.join(unknown.owner.robots)} last for about "
        f"{math.exp(unknown.value(q)):.2g} s; readings so near each other are reckoned as sharing an error."
        for unknown, q in zip(fit.noise, fit.q_noise.tolist(), strict=True)
        if unknown.column in READING_MEMORY
    )


def wander_remarks(fit: Fit) -> tuple[str, ...]:
    """Sentences on places that a fit reckons to wander, one for each robot."""
    return tuple(
        f"Beside errors of single readings, the place of {', '.join(unknown.owner.robots)} that readings show wanders "
        f"as that of a satellite receiver, by about {said_quantity(math.exp(unknown.value(q)), 'm')} in a second and "
        f"{said_quantity(math.exp(unknown.value(q)) * math.sqrt(60.0), 'm')} in a minute; this is reckoned with."
        for unknown, q in zip(fit.noise, fit.q_noise.tolist(), strict=True)
        if unknown.column == WANDER
    )


def _words(column: str) -> str:
    return NOISE_WORDS[column.partition(".")[2]].removeprefix("a reading of ")
