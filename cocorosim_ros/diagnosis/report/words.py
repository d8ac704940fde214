"""Words of the report: verdicts, and checks on the robot for each effect of the catalogue."""

from __future__ import annotations

import math

from cocorosim_ros.diagnosis.criteria.report import REPORT
from cocorosim_ros.diagnosis.findings import Comparison, Diagnosis
from cocorosim_ros.diagnosis.tracks.columns import NOISE_WORDS
from cocorosim_ros.world.effects import EFFECTS
from cocorosim_ros.world.laws.law import is_law, subject_and_product
from cocorosim_ros.world.sensors.errors import ERRORS, units_of

VERDICTS = {
    "consistent": (
        "Nothing is missing",
        "The recording is what the model of this platform expects, within its noise: no number of the platform has "
        "moved, and no effect of the catalogue explains anything.",
    ),
    "recalibrate": (
        "Recalibrate",
        "The physics is complete, but numbers of the platform differ from its file. With the fitted numbers of "
        "model.yaml the simulation follows the recording.",
    ),
    "mismatch": (
        "Physics is missing",
        "No choice of the platform's own numbers explains the recording; the effects below do.",
    ),
    "insufficient": (
        "This recording cannot tell",
        "The file can be read, but it does not hold the information that a diagnosis needs; nothing is said for or "
        "against the model.",
    ),
}
WITHOUT_NAME = (
    "Something is missing",
    "No choice of the platform's own numbers explains the recording, and no effect does beyond doubt: those that "
    "explain something may as well be nothing, each by itself, or foretell nothing.",
)
"""Words of a mismatch without a name."""
DIFFERENCES = {
    "consistent": (
        "Nothing differs",
        "These recordings are what the vehicle of the compared ones would do, within noise and spread.",
    ),
    "recalibrate": (
        "Numbers have changed",
        "Numbers of the vehicle differ from those of the compared recordings; no further effect does.",
    ),
    "mismatch": (
        "Something differs",
        "No change of the vehicle's own numbers explains the difference from the compared recordings; effects do.",
    ),
    "insufficient": VERDICTS["insufficient"],
}
"""Words of the verdicts about recordings that are compared with others of the same vehicle."""
DIFFERS_WITHOUT_NAME = (
    "Something differs",
    "The compared recordings differ from these, but by nothing with a sure size.",
)
TIERS = {
    "confirmed": "confirmed: it also improves data that its fit did not see",
    "suspected": "suspected: the evidence is there, but data that its fit did not see are not improved beyond doubt",
}
BECAUSE = "suspected, and no more than that, for these reasons"
CHANNEL_WORDS = {"position": "position, horizontal"}

NOISES = {
    "random.force": "random force, horizontal",
    "random.heave_force": "random force, vertical",
    "random.moment": "random yaw moment",
    "random.correlation": "memory of the random forces",
    "random.smoothness": "smoothness of the random forces (0 rough, 1 smooth)",
    "random.with_speed": "random force that comes with speed (at the highest, over that at rest)",
    "random.with_thrust": "random force that comes with thrust (at the highest, over that at rest)",
    **{f"reading.{name}": words for name, words in NOISE_WORDS.items()},
    **{f"memory.{name}": f"memory of the errors of {words}" for name, words in NOISE_WORDS.items()},
}

CHECKS = {
    **{name: effect.check for name, effect in EFFECTS.items() if effect.check},
    **{name: error.check for name, error in ERRORS.items()},
}


def effect_words(identifier: str) -> str:
    """An identifier of the catalogue, with a stream or a number after a colon, or of a law outside it, as words."""
    if is_law(identifier):
        equation, product = subject_and_product(identifier)
        return f"unknown law of {equation.replace('_', ' ')} in proportion to {product.text.replace('*', chr(0xB7))}"
    return identifier.replace("_", " ").replace(":", ", ")


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
    return known.get(parameter, "1")


def verdict_words(diagnosis: Diagnosis) -> tuple[str, str]:
    """Heading and sentence of a verdict."""
    if diagnosis.verdict == "mismatch" and not diagnosis.effects and diagnosis.passed_over:
        return WITHOUT_NAME
    if diagnosis.verdict == "mismatch" and not diagnosis.effects and diagnosis.against is not None:
        return DIFFERS_WITHOUT_NAME
    return (VERDICTS if diagnosis.against is None else DIFFERENCES)[diagnosis.verdict]


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
    return f"{factor:.2g} times less likely" if factor < REPORT.told_odds else "much less likely"


def nothing_missing_words(diagnosis: Diagnosis) -> str:
    """The reason, as a sentence, for a diagnosis without effects."""
    if diagnosis.verdict == "insufficient":
        return "Nothing could be tested, because the recording holds too little information."
    if diagnosis.passed_over:
        return "No effect is named: those below explain something, but none beyond doubt."
    if diagnosis.against is not None and diagnosis.verdict == "mismatch":
        return "No difference is beyond doubt: what these recordings cannot tell is said with what they do not show."
    if diagnosis.against is not None:
        return "No effect of the catalogue, and no law outside it, differs from the compared recordings."
    return "No effect of the catalogue, and no law outside it, explains what the fitted model leaves over."
