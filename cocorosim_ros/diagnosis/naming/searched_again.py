"""Choice between two searches over the same recordings, of which the later one has free runs of another length.

Each search adds one effect at a time, and an effect is named that free runs gain by. Over longer runs none may gain
alone, though several do together: a blimp that lacks its side force and its drag sideways errs by metres with either.
So what the first search found is asked over the runs of the second as well, all together.
"""

from __future__ import annotations

from dataclasses import replace

from cocorosim_ros.diagnosis.fitting.polishing import polished
from cocorosim_ros.diagnosis.foretelling.gains import FreeRuns, rows_without_held_out
from cocorosim_ros.diagnosis.foretelling.unseen import Unseen
from cocorosim_ros.diagnosis.naming.contest import log_evidence
from cocorosim_ros.diagnosis.naming.named_effect import Naming, Stage, onsets_of
from cocorosim_ros.diagnosis.naming.pruning import pruned
from cocorosim_ros.foundation.arrays import Floats


def better_foretelling(first: Naming, again: Naming, unseen: Unseen) -> Naming:
    """Choose, of two searches from the same base, the one whose model foretells better.

    unseen: parts and free runs of the search `again`, by which the effects of `first` are pruned before. They are taken
    if they have more evidence and free runs likely gain by them; what `again` screened and refused stays.
    """
    kept = pruned(Stage(first.fit, first.named, first.harmful), first.base, first.known, unseen)
    if not kept.named or log_evidence(kept.fit) <= log_evidence(again.fit):
        return again
    runs = FreeRuns(unseen, first.base.filled)

    def errors(stage: Stage) -> Floats:
        return runs.errors(rows_without_held_out(stage.fit, unseen.splits, onsets_of(stage.named)))

    if not runs.gain(errors(Stage(again.fit, again.named)), errors(kept)).is_likely:
        return again
    return replace(again, fit=polished(kept.fit), named=kept.named, harmful=kept.harmful)
