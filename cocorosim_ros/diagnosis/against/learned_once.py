"""The learned vehicle of the recordings of --against, kept for the next ones that are compared with the same."""

from __future__ import annotations

import hashlib
import pickle
import threading
from collections.abc import Callable
from typing import NamedTuple

from cocorosim_ros.diagnosis.against.comparable import in_parts
from cocorosim_ros.diagnosis.against.learning import learned_vehicle
from cocorosim_ros.diagnosis.criteria.fitting import RECALIBRATION
from cocorosim_ros.diagnosis.evidence.streams.log import Evidence
from cocorosim_ros.diagnosis.fitting.acting_angles import driven_as_shown
from cocorosim_ros.diagnosis.fitting.drag_forms import with_best_form
from cocorosim_ros.diagnosis.fitting.fit import Fit
from cocorosim_ros.diagnosis.fitting.recalibration import base_fit
from cocorosim_ros.diagnosis.tracks.lately import Lately


class Learned(NamedTuple):
    """A vehicle that was learned, and the fit of the platform's own numbers from which learning began."""

    vehicle: Fit
    base: Fit


class _Kept(threading.local):
    """The last learned vehicle of each thread, by the content of its recordings."""

    def __init__(self) -> None:
        self.vehicles: Lately[Learned] = Lately(1)


_KEPT = _Kept()


def learned_once(good: Evidence, progress: Callable[[str, float], None]) -> Learned:
    """Learn the vehicle of recordings; of the same recordings as the time before it is known already.

    Learning takes most of a comparison, and many recordings are compared with the same.
    """

    def learn() -> Learned:
        base = driven_as_shown(good, lambda evidence: base_fit(in_parts(evidence))).base
        if good.platform.drag_form is None:
            base, _ = with_best_form(base, RECALIBRATION.most_rounds)
        return Learned(learned_vehicle(base, progress), base)

    return _KEPT.vehicles.once(_content(good), learn)


def _content(good: Evidence) -> bytes:
    """Digest of all that a vehicle is learned from."""
    return hashlib.sha256(pickle.dumps(good)).digest()
