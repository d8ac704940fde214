"""Limits of effects: one whose size ends where such an effect can be no larger is no hypothesis.

Something else drives the fit there, as where a glider that flies up and down seems to have less mass than it weighs.
"""

from __future__ import annotations

from cocorosim_ros.diagnosis.fitting.candidate import Candidate
from cocorosim_ros.diagnosis.fitting.fit import Fit


def is_at_its_limit(candidate: Candidate, fit: Fit) -> bool:
    """Tell whether an amplitude of a candidate stands at an end of what it can be, other than where it is absent."""
    amplitudes = {amplitude.name: amplitude for amplitude in candidate.entry.amplitudes}
    for place in candidate.places_among(fit.unknowns):
        unknown, q = fit.unknowns[place], float(fit.q[place])
        amplitude = amplitudes.get(unknown.owner.parameter)
        if amplitude is None:
            continue
        ends = zip((amplitude.least, amplitude.most), unknown.at_ends(q), strict=True)
        if any(there and end != 0.0 for end, there in ends):
            return True
    return False
