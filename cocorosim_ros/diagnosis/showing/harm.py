"""Effects that make free runs on unseen data worse: whatever their evidence, they are taken back."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from cocorosim_ros.diagnosis.criteria.foretelling import FREE_RUN_GAINS
from cocorosim_ros.diagnosis.criteria.showing import VERDICT
from cocorosim_ros.diagnosis.findings import HeldOut, PassedOver
from cocorosim_ros.diagnosis.fitting.candidate import Candidate
from cocorosim_ros.diagnosis.foretelling.exactness import is_beyond_steps, is_exact
from cocorosim_ros.diagnosis.foretelling.free_runs import HeldOutFreeRuns, held_out_free_runs
from cocorosim_ros.diagnosis.foretelling.rulers import CHANNELS
from cocorosim_ros.diagnosis.foretelling.unseen import Unseen
from cocorosim_ros.diagnosis.naming.choice import moves
from cocorosim_ros.diagnosis.naming.named_effect import Naming
from cocorosim_ros.diagnosis.naming.pruning import without_least
from cocorosim_ros.diagnosis.showing.estimates import fitted, found_effects
from cocorosim_ros.world.sensors.errors import ERRORS

FORETOLD_WORSE = "Unseen data are foretold worse by the model with it than by the recalibrated one."
HARMS = "free runs become worse with it"
WORSE_BESIDE_OTHERS = "Beside the other effects, unseen data are foretold worse with it than without it."
WORSE_BESIDE_KEPT = (
    "Beside the numbers that are kept as the file gives them, unseen data are foretold worse with it than by the "
    "platform as given."
)


def that_helps(naming: Naming, unseen: Unseen) -> tuple[Naming, HeldOutFreeRuns]:
    """Take back named effects that make free runs on unseen data worse, the one they gain least by first."""
    return _fewer(lambda left, free: not _is_harmed(left, free), naming, unseen, held_out_free_runs(unseen, naming.fit))


def fewer_until(
    is_well: Callable[[Mapping[str, HeldOut]], bool], naming: Naming, unseen: Unseen, free: HeldOutFreeRuns
) -> tuple[Naming, HeldOutFreeRuns]:
    """Take back named effects, the one that free runs gain least by first, until the table of free runs is well."""
    return _fewer(lambda _, runs: is_well(runs.table), naming, unseen, free)


def _fewer(
    is_well: Callable[[Naming, HeldOutFreeRuns], bool], naming: Naming, unseen: Unseen, free: HeldOutFreeRuns
) -> tuple[Naming, HeldOutFreeRuns]:
    while naming.named and not is_well(naming, free):
        naming = without_least(naming)
        free = held_out_free_runs(unseen, naming.fit)
    return naming, free


def harmful(before: Naming, after: Naming, because: str) -> tuple[PassedOver, ...]:
    """Effects that were taken back from one naming to another, as they would have been told; because: a sentence."""
    left = {effect.candidate.key for effect in after.named}
    gone = [effect for effect in before.named if effect.candidate.key not in left]
    told = found_effects(before.fit, gone, fitted(before.fit)) if gone else ()
    return tuple(PassedOver(each, False, (because,), HARMS) for each in told)


def harmful_to_others(naming: Naming) -> tuple[PassedOver, ...]:
    """Effects that were taken back beside others, one for each name, as they would have been told."""
    last = {each.effect.candidate.key: each for each in naming.harmful}
    return tuple(
        PassedOver(told, False, (WORSE_BESIDE_OTHERS,), HARMS)
        for each in last.values()
        for told in found_effects(each.fit, [each.effect], fitted(each.fit))
    )


def _is_harmed(naming: Naming, free: HeldOutFreeRuns) -> bool:
    """Tell whether free runs with all effects are worse than without, in all or clearly in a channel.

    In all is not asked of errors of the catalogue that act on readings alone, but for those that are told in terms of
    what other readings show, as an antenna off the centre is: free runs have these. Of a law of readings it is asked
    without any doubt in its favour: there are many, and they follow effects of motion. A course that stands in for the
    readings of a channel is bent by errors of other readings, and tells nothing where such an error is named.
    """
    in_all = False
    if free.gain is not None and not is_exact(free.table):
        named = [effect.candidate for effect in naming.named]
        of_reading = any(each.entry.law is not None and not moves(each) for each in named)
        worse = free.gain.mean < -FREE_RUN_GAINS.material
        in_all = (of_reading and worse) or (free.gain.is_loss and any(map(_is_foretold, named)))
    bent = any(not moves(effect.candidate) for effect in naming.named)
    asked = {channel: row for channel, row in free.table.items() if not (bent and _is_by_course(channel, row))}
    return in_all or any(_is_worse(channel, row) for channel, row in asked.items())


def _is_foretold(candidate: Candidate) -> bool:
    """Tell whether free runs foretell readings otherwise with a candidate of the catalogue."""
    error = ERRORS.get(candidate.entry.id)
    return moves(candidate) or (error is not None and bool(error.told_by))


def _is_by_course(channel: str, row: HeldOut) -> bool:
    return channel in CHANNELS and row.against == "course"


def _is_worse(channel: str, row: HeldOut) -> bool:
    """Tell whether the model with its effects errs clearly more than the model without, and by more than steps make.

    A single free run is nothing clear: the interval of its error is a point.
    """
    if not is_beyond_steps(channel, row.augmented):
        return False
    low, high = row.intervals["augmented"]
    clear = high > low > row.intervals["recalibrated"][1]
    return clear and row.augmented > VERDICT.worse * max(row.recalibrated, row.noise_floor)
