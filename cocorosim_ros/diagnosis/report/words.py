"""Words of the report: verdicts, and checks on the robot for each effect of the catalogue."""

from __future__ import annotations

import math

from cocorosim_ros.diagnosis.catalogue.law_words import identifier_words, short_words
from cocorosim_ros.diagnosis.criteria.report import REPORT
from cocorosim_ros.diagnosis.findings import Comparison, FoundEffect
from cocorosim_ros.diagnosis.naming.single_thrusters import ONE_THRUSTER
from cocorosim_ros.diagnosis.naming.steering_trims import STEERING_TRIM
from cocorosim_ros.diagnosis.tracks.columns import NOISE_WORDS
from cocorosim_ros.world.effects import EFFECTS
from cocorosim_ros.world.laws.law import is_law
from cocorosim_ros.world.sensors.errors import ERRORS, units_of

BORNE_OUT = "confirmed: it also improves data that its fit did not see"
BECAUSE = "suspected, and no more than that, for these reasons"
CHANNEL_WORDS = {"position": "position, horizontal"}

NOISES = {
    "random.force": "random force, horizontal",
    "random.heave_force": "random force, vertical",
    "random.moment": "random yaw moment",
    "random.correlation": "memory of the random forces",
    "random.smoothness": "smoothness of the random forces (0 rough, 1 smooth)",
    "random.place": "wander of the places that readings show (in a second; in a minute eight times as far)",
    "random.with_speed": "random force that comes with speed (at the highest, over that at rest)",
    "random.with_thrust": "random force that comes with thrust (at the highest, over that at rest)",
    **{f"reading.{name}": words for name, words in NOISE_WORDS.items()},
    **{f"memory.{name}": f"memory of the errors of {words}" for name, words in NOISE_WORDS.items()},
}

CHECKS = {
    ONE_THRUSTER: "Weigh its thrust and that of another one at the same command; look for weed and a damaged blade.",
    STEERING_TRIM: "Look along it at command zero: a linkage that has slipped, or a zero that was set anew.",
    **{name: effect.check for name, effect in EFFECTS.items() if effect.check},
    **{name: error.check for name, error in ERRORS.items()},
}


def effect_words(identifier: str) -> str:
    """An identifier of the catalogue, with a stream or a number after a colon, or of a law outside it, as words."""
    return identifier_words(identifier) if is_law(identifier) else short_words(identifier)


def tier_words(found: FoundEffect) -> str:
    """Words for how sure an effect is, with the reason where it has no sentences on that."""
    if found.because:
        return BECAUSE
    return BORNE_OUT if found.tier == "confirmed" else f"suspected: {_doubt(found)}"


def reasons_of(found: FoundEffect) -> tuple[str, ...]:
    """Sentences on why an effect is only suspected; () for a confirmed one."""
    if found.because or found.tier == "confirmed":
        return found.because
    doubt = _doubt(found)
    return (f"{doubt[0].upper()}{doubt[1:]}.",)


def _doubt(found: FoundEffect) -> str:
    """Words for why an effect is only suspected although no sentence speaks against it."""
    if rivals := [effect_words(each.id) for each in found.ambiguous_with]:
        return f"{', '.join(rivals)} would explain the recordings as well, or nearly"
    return "the evidence is there, but data that its fit did not see are not improved beyond doubt"


def check_words(identifier: str) -> str:
    """Advice on what to check on the robot or in the tank, for an effect or law; '' if there is none."""
    if is_law(identifier):
        return (
            "No entry of the catalogue has this law: look for what could act like it, and record again to see it twice."
        )
    return CHECKS.get(identifier, "")


def parameter_unit(effect: str, parameter: str) -> str:
    """The SI unit of a parameter of the catalogue, '1' if the catalogue does not know it."""
    known: dict[str, str] = {}
    if effect in EFFECTS:
        known = {each.name: each.unit for each in EFFECTS[effect].parameters}
    elif effect in ERRORS:
        known = units_of(effect)
    return known.get(parameter, "rad" if effect == STEERING_TRIM else "1")


def control_words(against: Comparison | None) -> str:
    """Sentence about the recordings that others are compared with: whether one half of them differs from the other."""
    if against is None:
        return ""
    if against.control:
        names = ", ".join(map(effect_words, against.control))
        return f"one half of these recordings differs from the other in {names}: nothing here is more than suspected"
    return "one half of these recordings does not differ from the other"


def odds_words(nats: float) -> str:
    """Words for the odds of a rival that is `nats` behind."""
    if not math.isfinite(nats):
        return "\u2013"
    factor = math.exp(min(nats, REPORT.most_told_nats))
    told = f"{factor:.2g}"
    if told == "1":
        return "as likely"
    return f"{told} times less likely" if factor < REPORT.told_odds else "much less likely"
