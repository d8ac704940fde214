"""Choice of an effect by free runs: which of those that the likelihood finds worth considering foretells best.

The likelihood with one stationary random force prefers what acts where the water pushes most, and cannot tell a law
from what stands in for it there. So the candidate with most evidence gives way to one whose free runs through unseen
parts are clearly better, and what makes them worse is not named. Errors of readings are left to the likelihood: a free
run has no readings.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass, field
from functools import cached_property

from cocorosim_ros.diagnosis.catalogue.entry import SENSOR_CHANNELS
from cocorosim_ros.diagnosis.criteria.foretelling import FREE_RUN_GAINS
from cocorosim_ros.diagnosis.criteria.naming import NAMING, SEARCH
from cocorosim_ros.diagnosis.fitting.candidate import Candidate
from cocorosim_ros.diagnosis.fitting.fit import Fit
from cocorosim_ros.diagnosis.fitting.screening import Screen, Screened
from cocorosim_ros.diagnosis.foretelling.gains import FreeRuns, Gain, rows_without_held_out
from cocorosim_ros.diagnosis.foretelling.unseen import Unseen
from cocorosim_ros.diagnosis.naming.contest import Begun, Refined
from cocorosim_ros.diagnosis.naming.named_effect import Refused
from cocorosim_ros.diagnosis.naming.needed_evidence import standing
from cocorosim_ros.foundation.arrays import Floats


def moves(candidate: Candidate) -> bool:
    """Tell whether a candidate acts on the motion, and not on readings alone."""
    return candidate.entry.channel not in SENSOR_CHANNELS


def _is_no_loss(gain: Gain) -> bool:
    """Tell whether free runs gain, or do not feel an effect at all."""
    return gain.mean > 0.0 or (gain.windows > 0 and gain.mean > -FREE_RUN_GAINS.felt)


def can_be_law(candidate: Candidate, lasting: Collection[str]) -> bool:
    """Tell whether a law may be that of a candidate, beside robots some of whose readings have errors that last.

    The filter follows such errors by whole steps, so that what changes within a step, as a command does, may pass for a
    law of these readings.
    """
    return moves(candidate) or set(lasting).isdisjoint(candidate.robots)


def harms(candidate: Candidate, gain: Gain) -> bool:
    """Tell whether free runs speak against a candidate: they lose by it, or gain too little by one of the many laws."""
    return gain.is_loss if candidate.entry.law is None else not gain.is_likely


@dataclass(frozen=True)
class Choice:
    """Free runs of the models that one more effect makes of `fit`; those of a model are run once.

    onsets: columns of moments of events that the fit has, of which what is held out may tell alone. must_gain: no
    candidate that moves is named without a gain, however likely a small loss is by chance. refused: candidates with
    evidence enough, which free runs were against. traces: errors of readings that may be what these leave there.
    judged: numbers of the tracks whose held-out blocks count; None: all. instruments_apart: nats by which an error of
    one stream's readings has to be ahead of that of another's, which is a rival otherwise. instruments_share: share of
    its own nats by which it has to be ahead too. begun: fits of candidates
    that were begun.
    """

    unseen: Unseen
    fit: Fit
    onsets: frozenset[str] = frozenset()
    must_gain: bool = False
    judged: Collection[int] | None = None
    instruments_apart: float = NAMING.ambiguity
    instruments_share: float = 0.0
    refused: list[Refused] = field(default_factory=list)
    traces: list[Candidate] = field(default_factory=list)
    begun: list[Begun] = field(default_factory=list)
    _known: list[tuple[Refined, Floats]] = field(default_factory=list)

    @cached_property
    def _runs(self) -> FreeRuns:
        return FreeRuns(self.unseen, self.fit.filled)

    @cached_property
    def _before(self) -> Floats:
        return self._runs.errors(rows_without_held_out(self.fit, self.unseen.splits, self.onsets))

    def gain(self, refined: Refined) -> Gain:
        """Gain of a refined candidate over the model without any, both without the held-out readings."""
        return self._runs.gain(self._before, self._of(refined))

    def refuses(self, candidate: Candidate, gain: Gain) -> bool:
        """Tell whether free runs are against naming a candidate that moves."""
        return harms(candidate, gain) or (self.must_gain and not _is_no_loss(gain))

    def may_be_trace(self, candidate: Candidate, nats: float) -> bool:
        """Tell whether an error of readings may be what a motion leaves there that free runs refused a name."""
        refused = max((each.effect.nats for each in self.refused), default=0.0)
        return not moves(candidate) and nats < NAMING.law_share * refused

    def better(self, leader: Refined, others: Sequence[Refined]) -> list[Refined]:
        """List the entries of the catalogue that foretell clearly better than a leader that moves, best first.

        A law outside the catalogue does not take the place of an entry, nor does an effect that explains so little of
        the leader's evidence that the leader cannot stand in for it.
        """
        found = []
        needed = NAMING.stands_for * standing(leader)
        for other in others:
            if _may_replace(leader.candidate, other.candidate) and standing(other) > needed:
                gain = self._runs.gain(self._of(leader), self._of(other))
                if gain.is_clear:
                    found.append((gain.mean, other))
        return [other for _, other in sorted(found, key=lambda pair: -pair[0])]

    def excludes(self, best: Refined, other: Refined) -> bool:
        """Tell whether free runs are clearly better with `best` than with another candidate, which is then no rival."""
        if not (moves(best.candidate) and moves(other.candidate)):
            return False
        return self._runs.gain(self._of(other), self._of(best)).is_clear

    def reach(self, best: Refined, other: Candidate) -> float:
        """Nats within which another candidate is a rival of the best one."""
        topics = {best.candidate.entry.topic, other.entry.topic} - {None}
        if len(topics) < 2:
            return NAMING.ambiguity
        return max(self.instruments_apart, self.instruments_share * (best.nats + best.usual))

    def promising(self, leader: Begun, others: Sequence[Begun]) -> list[Begun]:
        """List those of some candidates whose free runs, as far as they are fitted, are clearly better than a leader's.

        These models have seen all readings; with a few numbers more this is no great advantage.
        """
        wanted = [each for each in others if _may_replace(leader.candidate, each.candidate)]
        if not wanted:
            return []
        of_leader = self._runs.errors(leader.fit.filled)
        return [each for each in wanted if self._runs.gain(of_leader, self._runs.errors(each.fit.filled)).is_clear]

    def overlooked(self, screen: Screen, tested: Sequence[Screened], chosen: Sequence[Screened]) -> list[Screened]:
        """List a few candidates that are not `chosen`, but whose promised models clearly foretell better than the best.

        tested: all screened candidates, best first.
        """
        leaders = [each for each in chosen if moves(each.candidate)]
        if not leaders:
            return []
        some = [
            each
            for each in tested
            if each.nats > NAMING.threshold
            and not any(each is other for other in chosen)
            and _may_replace(leaders[0].candidate, each.candidate)
        ][: SEARCH.most_refined]
        if not some:
            return []
        of_leader = self._runs.errors(screen.stepped(leaders[0]))
        gains = [(self._runs.gain(of_leader, self._runs.errors(screen.stepped(each))), each) for each in some]
        better = sorted(((gain, each) for gain, each in gains if gain.is_clear), key=lambda pair: -pair[0].mean)
        return [each for _, each in better[: SEARCH.overlooked]]

    def _of(self, refined: Refined) -> Floats:
        """Mean squared errors (windows, channels) of a candidate's model that has not seen what is held out."""
        for known, errors in self._known:
            if known is refined:
                return errors
        onsets = self.onsets | refined.candidate.onset_columns
        rows = rows_without_held_out(refined.fit, self.unseen.splits, onsets)
        self._known.append((refined, self._runs.errors(rows)))
        return self._known[-1][1]


def _may_replace(leader: Candidate, other: Candidate) -> bool:
    return moves(leader) and moves(other) and (other.entry.law is None or leader.entry.law is not None)
