"""Words for the verdict of a diagnosis: what is known, and no more than that."""

from __future__ import annotations

from typing import NamedTuple

from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES
from cocorosim_ros.diagnosis.catalogue.entry import SENSOR_CHANNELS
from cocorosim_ros.diagnosis.findings import Diagnosis, FoundEffect
from cocorosim_ros.diagnosis.foretelling.collapse import collapsed_channels
from cocorosim_ros.diagnosis.showing.probability import probabilities_of
from cocorosim_ros.diagnosis.showing.suspect_sets import SOMETHING_ELSE


class Words(NamedTuple):
    """Heading, sentence below it, and what to do with the found model, '' where nothing is to be done with it."""

    heading: str
    sentence: str
    next: str = ""


_SIMULATE = "Simulate with model.yaml as the platform of a scenario"
_FINDS_NOTHING = f"{_SIMULATE}, and diagnose the next recording with --platform model.yaml: it should find nothing."
_AGAIN = (
    "Diagnose the next recording with the platform as it is: a suspected effect that is real is named again, with a "
    "number inside its interval. Until then, model.yaml holds what is only suspected."
)
_NO_MODEL = "Do not simulate with model.yaml: the fit behind its numbers has collapsed."
_NOT_BY_NUMBERS = "No choice of the platform's own numbers explains the recording"
_BETTER = "The effects below explain the recording better than any choice of the platform's own numbers does"

CONSISTENT = Words(
    "Nothing was found",
    "The recording is what the model of this platform expects, within its noise: no number of the platform has moved, "
    "and no effect of the catalogue explains anything. What the recording could not show is listed below.",
)
RECALIBRATE = Words(
    "Recalibrate",
    "No effect of the catalogue explains anything, but numbers of the platform differ from its file. With the fitted "
    "numbers of model.yaml the simulation follows the recording.",
    _FINDS_NOTHING,
)
NOTHING_NAMED = Words(
    "Something is missing, and nothing is named",
    "No number of the platform has moved and no effect of the catalogue explains anything, but free runs err by more "
    "than noise does: the warnings say where.",
)
SHIFTED_AND_MORE = Words(
    "Something is missing, and numbers have shifted",
    "Numbers of the platform differ from its file. With those of model.yaml, too, free runs err by more than noise "
    "does, and no effect of the catalogue explains that: the warnings say where.",
)
INSUFFICIENT = Words(
    "This recording cannot tell",
    "The file can be read, but it does not hold the information that a diagnosis needs; nothing is said for or against "
    "the model.",
)
CONFIRMED = Words(
    "Physics is missing", f"{_NOT_BY_NUMBERS}; the effects below do.", _FINDS_NOTHING
)  # all of them confirmed
PARTLY = Words(
    "Physics is missing",
    f"{_NOT_BY_NUMBERS}. The confirmed effects below are missing from the model; the suspected ones may be.",
    _AGAIN,
)
SUSPECTED = Words(
    "Perhaps physics is missing", f"{_BETTER}, but each of them is only suspected: none has to be there.", _AGAIN
)
ELSE = Words(
    "Something is missing, and its name is not known",
    f"{_BETTER}, but none of their names is sure: take them for what is most like it.",
    _AGAIN,
)
INSTRUMENTS = Words(
    "Readings err",
    "What was found are errors of instruments and of their clocks; nothing says that physics is missing.",
    _FINDS_NOTHING,
)
PERHAPS_INSTRUMENTS = Words(
    "Perhaps readings err",
    "All that is suspected are errors of instruments and of their clocks, and none has to be there; nothing says that "
    "physics of the vehicle is missing.",
    _AGAIN,
)
COLLAPSED = Words(
    "The fit has collapsed: nothing is known",
    "The recalibrated model foretells unseen data worse than the platform as given does. What such a fit finds may be "
    "its own fault; whether physics is missing is not known.",
    _NO_MODEL,
)
KEPT_AS_GIVEN = Words(
    "The fit has collapsed: little is known",
    "Fitted numbers of the platform foretold unseen data worse than the platform as given, so the file's are "
    "kept. What is found beside them may stand for something else; whether physics is missing is not known.",
    "Look at what the numbers that are kept stand for: the platform's file may lack a cause there, or be wrong in one.",
)
WITHOUT_NAME = Words(
    "Something is missing",
    f"{_NOT_BY_NUMBERS}, and no effect does beyond doubt: those that explain something may as well be nothing, each by "
    "itself, or foretell nothing.",
)
DIFFERENCES = {
    "consistent": Words(
        "Nothing differs",
        "These recordings are what the vehicle of the compared ones would do, within noise and spread.",
    ),
    "recalibrate": Words(
        "Numbers have changed",
        "Numbers of the vehicle differ from those of the compared recordings; no further effect does.",
    ),
    "insufficient": INSUFFICIENT,
}
ANOTHER = Words(
    "These recordings look like another vehicle's",
    "They differ from the compared recordings in more than happens to one vehicle; nothing is said of what differs.",
    "Give recordings of the same vehicle with --against, or diagnose these with the platform of their own.",
)
DIFFERS = Words(
    "Something differs",
    "No change of the vehicle's own numbers explains the difference from the compared recordings; effects do.",
)
PERHAPS_DIFFERS = Words(
    "Perhaps something differs",
    "With the effects below the difference from the compared recordings is explained better than by any change of the "
    "vehicle's own numbers, but each of them is only suspected: none has to be there.",
)
READINGS_DIFFER = Words(
    "Readings differ",
    "What differs are errors of instruments and of their clocks; nothing says that the vehicle moves otherwise.",
)
DIFFERS_WITHOUT_NAME = Words(
    "Something differs",
    "The compared recordings differ from these, but by nothing with a sure size.",
)
_CHANNEL = {entry.id: entry.channel for entry in ENTRIES}


def verdict_words(diagnosis: Diagnosis) -> Words:
    """Words of a verdict, by what is known of the names that were found."""
    if diagnosis.against is not None:
        return _of_difference(diagnosis)
    if diagnosis.held:
        return KEPT_AS_GIVEN
    if collapsed_channels(diagnosis.fit) and diagnosis.verdict != "consistent":
        # The model file of recordings that cannot tell is the platform as given.
        return COLLAPSED if diagnosis.verdict != "insufficient" else COLLAPSED._replace(next="")
    if diagnosis.verdict == "insufficient":
        return INSUFFICIENT
    if diagnosis.verdict == "mismatch":
        return _of_mismatch(diagnosis) if diagnosis.effects else _of_nameless(diagnosis)
    return CONSISTENT if diagnosis.verdict == "consistent" else RECALIBRATE


def _of_nameless(diagnosis: Diagnosis) -> Words:
    """Words where something is missing that has no name: by evidence for some effect, or by free runs alone."""
    if any(each.stands for each in diagnosis.passed_over):
        return WITHOUT_NAME
    return SHIFTED_AND_MORE if diagnosis.recalibrated else NOTHING_NAMED


def is_of_instruments(found: FoundEffect) -> bool:
    """Tell whether an effect is an error of a reading, of its axes or of its clock, and no force."""
    if found.law is not None:
        return found.law.topic is not None
    return found.correction is not None or _CHANNEL.get(found.id) in SENSOR_CHANNELS


def is_untested(diagnosis: Diagnosis) -> bool:
    """Tell whether recordings hold so little that no effect was tried, and no model fitted."""
    return diagnosis.verdict == "insufficient" and not (diagnosis.screened or diagnosis.fit)


def untested_because(diagnosis: Diagnosis) -> str:
    """The reason for which a page has nothing to show of a fit, as a clause; '' where it has."""
    if not is_untested(diagnosis):
        return ""
    if _is_of_another(diagnosis):
        return "because these recordings do not look like the same vehicle"
    return "because the recording holds too little information"


def nothing_missing_words(diagnosis: Diagnosis) -> str:
    """The reason, as a sentence, for a diagnosis without effects."""
    if diagnosis.verdict == "insufficient":
        return _why_untold(diagnosis)
    if diagnosis.passed_over:
        return "No effect is named: those below explain something, but none beyond doubt."
    if diagnosis.against is not None and diagnosis.verdict == "mismatch":
        return "No difference is beyond doubt: what these recordings cannot tell is said with what they do not show."
    if diagnosis.against is not None:
        return "No effect of the catalogue, and no law outside it, differs from the compared recordings."
    return "No effect of the catalogue, and no law outside it, explains what the fitted model leaves over."


def _why_untold(diagnosis: Diagnosis) -> str:
    """The reason for which recordings cannot tell: nothing was tried, the fit has collapsed, or too little shows."""
    if _is_of_another(diagnosis):
        return "Nothing is named: what differs is more than happens to one vehicle."
    if is_untested(diagnosis):
        return f"Nothing could be tested, {untested_because(diagnosis)}."
    if diagnosis.held or collapsed_channels(diagnosis.fit):
        return "Nothing is named: effects were tried, but what explains something here may be the fault of the fit."
    return "Nothing is named: effects were tried, but most of them this recording would not have shown."


def weighed_words(diagnosis: Diagnosis) -> str:
    """Sentence on what the probabilities were learned from, and where they are no more than a guess."""
    if not (diagnosis.effects or diagnosis.screened):
        return "Nothing was learned from this recording: this is what is believed without it."
    weighed = "Learned from simulated recordings of Lilys, in which about this share of such statements was right"
    if diagnosis.against is not None and not diagnosis.effects:
        return (
            f"{weighed}; two in three of them lacked something, which is too many for recordings of the same vehicle: "
            "nothing is more probable here than this says."
        )
    if diagnosis.verdict in ("consistent", "recalibrate") and not collapsed_channels(diagnosis.fit):
        return (
            f"{weighed}; two in three of them lacked something. So what would not show is here what was believed "
            "before the recording was seen; nothing in it speaks for that."
        )
    return f"{weighed}; of another vehicle it is a guess."


def _is_of_another(diagnosis: Diagnosis) -> bool:
    return diagnosis.against is not None and bool(diagnosis.against.unlike)


def _of_difference(diagnosis: Diagnosis) -> Words:
    """Words of a comparison with recordings of the same vehicle when it was well."""
    if _is_of_another(diagnosis):
        return ANOTHER
    if diagnosis.verdict != "mismatch":
        return DIFFERENCES[diagnosis.verdict]
    if not diagnosis.effects:
        return WITHOUT_NAME if diagnosis.passed_over else DIFFERS_WITHOUT_NAME
    if not diagnosis.recalibrated and all(map(is_of_instruments, diagnosis.effects)):
        return READINGS_DIFFER
    sure = bool(diagnosis.recalibrated) or any(each.tier == "confirmed" for each in diagnosis.effects)
    return DIFFERS if sure else PERHAPS_DIFFERS


def _of_mismatch(diagnosis: Diagnosis) -> Words:
    """Words where effects are named against a platform, by how sure they are."""
    confirmed = [each for each in diagnosis.effects if each.tier == "confirmed"]
    nameless = [each.found for each in diagnosis.passed_over if each.stands]
    if all(map(is_of_instruments, (*diagnosis.effects, *nameless))):
        return INSTRUMENTS if len(confirmed) == len(diagnosis.effects) else PERHAPS_INSTRUMENTS
    if not confirmed:
        told = probabilities_of(diagnosis).told
        return ELSE if max(told, key=lambda name: told[name]) == SOMETHING_ELSE else SUSPECTED
    if not all(map(is_of_instruments, confirmed)):
        return CONFIRMED if len(confirmed) == len(diagnosis.effects) else PARTLY
    return SUSPECTED
