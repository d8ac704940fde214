"""Effects that get no name although evidence speaks for them.

Those are of three kinds: the size may as well be nothing, free runs do not gain by the effect (`refused_effects`), or
the filter may have made it up (`made_up_delays`).

Evidence is reckoned with noise that is white and a law that is the same throughout. Where the one is coloured or the
other differs, numbers of single parts of the recordings scatter by far more than readings should let them, and whatever
fits the parts gains nats. So two questions are asked of each amplitude, with the scatter of parts (`form_width`):

- may it be nothing in a part that was not recorded? If not, it is there.
- may its mean over the parts be nothing? If not, it is there too, provided that data which its fit did not see clearly
  gain by the effect.

The second keeps an effect of many nats whose law has another form than the catalogue's: its number differs from slow to
fast, but is there in all parts, and foretells them. Beside effects that another diagnosis found only the first is
asked: what is left of those has numbers that differ too. So it is of delays among readings whose errors last: a filter
that follows such errors gains by a delay in held-out parts too, which in each part is another. That other laws of the
kind have other numbers, which widens the told interval as well, is not asked: it says how large an effect is, not
whether it is.
Source: DerSimonian and Laird, Controlled Clinical Trials 7 (1986) 177, for the mean of parts that differ; Higgins,
Thompson and Spiegelhalter, J. R. Statist. Soc. A 172 (2009) 137, for the part that was not seen.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from cocorosim_ros.diagnosis.criteria.naming import NAMING
from cocorosim_ros.diagnosis.criteria.showing import ESTIMATES
from cocorosim_ros.diagnosis.findings import PassedOver
from cocorosim_ros.diagnosis.fitting.coloured_readings import memories_of, robots_of
from cocorosim_ros.diagnosis.fitting.fit import Fit, covariance
from cocorosim_ros.diagnosis.fitting.unknowns import Z95
from cocorosim_ros.diagnosis.foretelling.gains import Gain
from cocorosim_ros.diagnosis.naming.named_effect import NamedEffect, Naming, Refused
from cocorosim_ros.diagnosis.showing.estimates import fitted, found_effects
from cocorosim_ros.diagnosis.showing.form_width import variances_between_parts
from cocorosim_ros.diagnosis.showing.hard_stops import FORETELLS_NOTHING
from cocorosim_ros.diagnosis.showing.made_up_delays import SHORTER_THAN_A_GAP, TOO_SHORT, is_made_up
from cocorosim_ros.diagnosis.showing.withdrawn import withdrawn
from cocorosim_ros.diagnosis.tracks.columns import OF_TIME
from cocorosim_ros.foundation.arrays import Flags

MAY_BE_NOTHING = (
    "Its size may as well be nothing: each of its amplitudes differs so much from part to part of the recordings, or "
    "is so badly known, that it may be zero."
)

GAINS_TOO_LITTLE = (
    "Held-out readings bear it out, but free runs through data that no fit saw do not gain by it: something like it is "
    "missing, perhaps another law of the same force."
)
SIZE_MAY_BE_NOTHING = "its size may as well be nothing"
NOT_FORETOLD = "free runs do not gain by it"


class Clear(NamedTuple):
    """Flags (unknowns,) of a fit: whether a number is more than nothing in any part, and whether its mean is."""

    in_parts: Flags
    in_mean: Flags

    def of(self, effect: NamedEffect, *, in_all_parts: bool = False) -> Flags:
        """Flags (unknowns,) as they count for an effect: the mean where unseen data clearly gain by it.

        in_all_parts: the mean is not enough, since others were found before, of whose forms it may be a rest, or since
        errors of readings last.
        """
        foretells = effect.held_out.p < ESTIMATES.held_out_p and not in_all_parts
        return np.asarray(self.in_parts | self.in_mean) if foretells else self.in_parts


def beyond_doubt(naming: Naming) -> tuple[Naming, tuple[PassedOver, ...]]:
    """Take back what may be nothing or made up, the weakest first, and fit the rest anew before the next is asked.

    An effect that is taken away makes the others surer, or less sure, so that all are asked again.
    """
    passed: list[PassedOver] = []
    while (weakest := _weakest(naming)) is not None:
        left, gone, told = withdrawn(naming, *weakest)
        made_up = is_made_up(weakest[0], naming.fit)
        reason, shortly = (TOO_SHORT, SHORTER_THAN_A_GAP) if made_up else (MAY_BE_NOTHING, SIZE_MAY_BE_NOTHING)
        stands = stands_without_name(gone) and not made_up and not _must_be_in_all_parts(naming, gone)
        passed += [PassedOver(found, stands, (reason, *_of_free_runs(gone.foretold)), shortly) for found in told]
        naming = left
    return naming, tuple(passed)


def refused_effects(naming: Naming) -> tuple[PassedOver, ...]:
    """List the effect of most evidence that free runs refused a name, where something is missing all the same.

    Free runs are short and few, and of the many laws a name needs that they gain by it. Evidence that held-out readings
    bear out, and that free runs do not surely contradict, says that something is missing, but not whether it is that.
    Beside effects that were found before, such evidence is a rest of theirs (`rests_of_found`).
    """
    strongest = _strongest_refused(naming)
    if strongest is None or naming.may_be_rest(strongest.effect):
        return ()
    fit, effect = strongest
    every = found_effects(fit, [effect], fitted(fit))
    return tuple(PassedOver(found, True, (GAINS_TOO_LITTLE,), NOT_FORETOLD) for found in every)


def rests_of_found(naming: Naming) -> tuple[str, ...]:
    """Sentence on the evidence that is left over beside effects that were found before; () if none is.

    The forms of these effects are rarely quite those of the vehicle, and whatever follows what they leave gains nats. A
    rest by which no free run becomes better is no reason to call a model that has been found once more wrong.
    """
    strongest = _strongest_refused(naming)
    if strongest is None or not naming.may_be_rest(strongest.effect):
        return ()
    effect = strongest.effect
    return (
        f"Beside the effects that the platform's file has from a diagnosis, {effect.nats:.0f} nats are left over, "
        f"which '{effect.candidate.entry.id}' would explain best. Free runs through data that no fit saw do not gain "
        "by it: most likely the forms of those effects are not quite those of this vehicle.",
    )


def _strongest_refused(naming: Naming) -> Refused | None:
    """Find the effect of most evidence that free runs refused a name, if evidence, and free runs, leave it open."""
    named = {effect.candidate.key for effect in naming.named}
    asked = [each for each in naming.refused if each.effect.candidate.key not in named]
    if not asked:
        return None
    strongest = max(asked, key=lambda each: each.effect.nats)
    effect = strongest.effect
    lost = effect.foretold is not None and _speaks_against(
        effect.foretold, is_law=effect.candidate.entry.law is not None
    )
    weak = effect.nats < NAMING.nameless or effect.held_out.p >= ESTIMATES.held_out_p
    return None if lost or weak else strongest


def _speaks_against(gain: Gain, *, is_law: bool) -> bool:
    """Tell whether free runs say that an effect is not there; of the many laws outside the catalogue sooner."""
    return gain.is_loss if is_law else gain.is_sure_loss


def _weakest(naming: Naming) -> tuple[NamedEffect, tuple[str, ...]] | None:
    """Find the named effect of least evidence that is in doubt, and on which robots; None if none is."""
    if not naming.named:
        return None
    clear = _clear(naming.fit)
    doubted = [(each, robots) for each in naming.named if (robots := _in_doubt(naming, each, clear))]
    return min(doubted, key=lambda pair: pair[0].nats) if doubted else None


def _in_doubt(naming: Naming, effect: NamedEffect, clear: Clear) -> tuple[str, ...]:
    """Names of the robots on which an effect may be nothing, or may be made up."""
    if is_made_up(effect, naming.fit):
        return effect.candidate.robots
    in_all_parts = _must_be_in_all_parts(naming, effect)
    return doubtful_robots(effect, naming.fit, clear.of(effect, in_all_parts=in_all_parts))


def _must_be_in_all_parts(naming: Naming, effect: NamedEffect) -> bool:
    """Tell whether the mean of an effect over parts that differ says nothing of it: see the head of this file."""
    if naming.may_be_rest(effect):
        return True
    is_delay = any(each.column in OF_TIME for each in effect.candidate.entry.amplitudes)
    return is_delay and not robots_of(memories_of(naming.fit)).isdisjoint(effect.candidate.robots)


def doubtful_robots(effect: NamedEffect, fit: Fit, clear: Flags) -> tuple[str, ...]:
    """Names of the robots on which every amplitude of an effect may be nothing; clear: by unknown (n,), if it is not.

    An effect that the base model has already is asked for its change.
    """
    amplitudes = {each.column for each in effect.candidate.entry.amplitudes}
    own = [place for place in effect.candidate.places_among(fit.unknowns) if fit.unknowns[place].column in amplitudes]

    def is_clear(robots: Sequence[str]) -> bool:
        return any(clear[place] for place in own if set(robots) <= set(fit.unknowns[place].owner.robots))

    return tuple(name for sharers in effect.candidate.sharers if not is_clear(sharers.names) for name in sharers.names)


def _clear(fit: Fit) -> Clear:
    """Tell of each unknown (n,) whether it is more than nothing; where its q is 0, it adds nothing to the model."""
    noise, differing = np.diag(covariance(fit)), variances_between_parts(fit)
    size = np.abs(fit.q)
    return Clear(*(size > Z95 * np.sqrt(noise + variance) for variance in differing))


def stands_without_name(gone: NamedEffect) -> bool:
    """Tell whether the evidence that something is missing stands without a name for it.

    The model without the effect is worse by enough, and free runs do not contradict that.
    """
    return gone.nats >= NAMING.threshold and not _of_free_runs(gone.foretold)


def _of_free_runs(gain: Gain | None) -> tuple[str, ...]:
    """The sentence on free runs that speak against an effect; none where they gain by it, or cannot judge it."""
    return () if gain is None or gain.mean > 0.0 else (FORETELLS_NOTHING,)
