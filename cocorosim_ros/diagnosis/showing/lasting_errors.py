"""Remarks on errors of readings that last."""

from __future__ import annotations

import math

from cocorosim_ros.diagnosis.fitting.fit import Fit
from cocorosim_ros.diagnosis.tracks.columns import READING_MEMORY
from cocorosim_ros.world.sensors import KINDS

_WORDS = {f"memory.{kind.noise or kind.name}": kind.noise_words for kind in KINDS.values() if kind.noise_words}


def memory_remarks(fit: Fit) -> tuple[str, ...]:
    """Sentences on errors that a fit reckons to last, one for each robot and kind of readings."""
    return tuple(
        f"Errors of {_WORDS[unknown.column].removeprefix('a reading of ')} of {', '.join(unknown.owner.robots)} last "
        f"for about {math.exp(unknown.value(q)):.2g} s; readings so near each other are reckoned as sharing an error."
        for unknown, q in zip(fit.noise, fit.q_noise.tolist(), strict=True)
        if unknown.column in READING_MEMORY
    )
