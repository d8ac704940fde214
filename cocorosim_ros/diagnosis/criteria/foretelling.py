"""Thresholds of the free runs: what is held out, how long models run, and what the noise floor learns."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class FreeRunCriteria:
    """Parts of a recording through which models run freely (`foretelling.free_runs`)."""

    held_out: float = 0.4
    """[of each recording, or of the recordings] is held out; the rest is fitted. Chosen, not measured."""
    most_blocks: int = 4
    """[blocks] of a recording that are held out. Chosen, not measured."""
    seen_windows: float = 3.0
    """[windows] that are fitted between two blocks, so that a fit sees whole motions. Chosen, not measured."""
    places: tuple[float, ...] = (0.6, 0.05, 0.3)
    """[of the period of the blocks] begin of the held-out block: late in the first recording, early in the second, in
    the middle of the third, and so on. Early is not at once, because a state has to be known. Chosen, not measured."""
    assignments: int = 5
    """[assignments] of places, or of whole recordings, to recordings that are compared. Reckoned from two of five
    recordings, and one of three places, that are held out: there are no more."""
    unlike: float = 1.75
    """[standard deviations] between the means of held-out and fitted parts, from which other places are taken; two that
    have nothing in common differ by 2.04. Chosen, not measured: drives at random of two minutes differ by 1.6 at most,
    but for their depth."""
    of_depth: float = 0.9
    """[1] by which a difference of depth counts: it changes slowly, so that drives at random differ by 1.9, and only
    parts with no depth in common are to count as unlike. Chosen, not measured."""
    steady: float = 0.05
    """[of the largest value] a quantity that varies less tells no regime. Chosen, not measured."""
    off: float = 0.05
    """[of the largest thrust] actuators below it are as good as off. Chosen, not measured."""
    many: int = 6
    """[recordings] each too short for two blocks: from so many on whole ones are held out. Chosen, not measured."""
    coasted: float = 6.0
    """[coasting times of the vehicle] that a free run lasts. Chosen, not measured: the 20 s of a
    Lily, which coasts for 3.3 s."""
    lengths: tuple[float, ...] = (0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0)
    """[s] of free runs: one length for vehicles that are nearly alike, so that their errors can be compared.
    Chosen, not measured."""
    most_turned: float = 30.0
    """[rad] in a window at the usual turn rate: after five turns no model foretells a heading. Chosen, not measured."""
    lost: float = 0.9
    """[rad] by which the noise floor's heading errs where free runs are too long. Reckoned from the pi / sqrt(3) of a
    heading of which nothing is known: half of it. A hovercraft erred by 1.45 rad in 5 s; the model that runs of 2 s
    found foretold 5 s of unseen recordings better too (1.49 for 1.77 rad)."""
    fewest_points: int = 10
    """[grid points] of a window, and twice as many of a fitted piece. Chosen, not measured."""


@dataclass(frozen=True)
class NamelessForceCriteria:
    """A smooth force without a name, learnt for the noise floor (`foretelling.nameless_force`)."""

    folds: int = 20
    """[parts of all courses] each foretold by what the others teach. Chosen, not measured."""
    most_terms: int = 12
    """[terms] of the force along one axis. Chosen, not measured."""
    memories: tuple[float, ...] = (2.0, 5.0, 15.0, 50.0)
    """[steps of the grid] over which late forces may fade. Chosen, not measured: from a step's blur to a
    pump."""
    steps_of_coasting: float = 45.0
    """[steps of the grid] that make the coasting time of a vehicle for which these memories are meant, as the 33 of a
    Lily; where more do, memories are longer in proportion. Chosen, not measured."""
    rounding: float = 1e-12
    """[of the largest term] smaller terms are rounding. Chosen, not measured."""


@dataclass(frozen=True)
class GainCriteria:
    """Gains of free runs from one model to another, by which effects are chosen (`foretelling.gains`)."""

    most: float = 3.0
    """[logarithm of the error] by which one window counts at most: a model that has run away is no worse than one that
    errs by e^3. Chosen, not measured."""
    sure: float = 2.0
    """[standard deviations] of a mean gain over the windows from which it is clear: one in forty is that by
    chance. Known of the normal distribution."""
    doubt: float = 1.0
    """[standard deviations] of a mean loss from which an effect is not kept, and of a mean gain that a law outside the
    catalogue needs: an effect that is right gains in the mean, and of the many laws some gain by chance. Chosen, not
    measured."""
    fewest: int = 3
    """[windows] fewer do not tell how far a gain is chance: of two, Student's interval is thirteen standard
    deviations wide, and no law would be found in a short recording. Chosen, not measured."""
    material: float = 0.02
    """[logarithm of the error] a smaller change is none: 2 % of an error at the noise floor. Chosen, not measured."""
    felt: float = 0.001
    """[logarithm of the error] free runs that change by less, to either side, do not feel an effect, and forbid none.
    Chosen, not measured: a current of 877 nats changed headings, all that was shown of the way, by 0.0001."""


@dataclass(frozen=True)
class RestraintCriteria:
    """Numbers of the platform that are held as its file gives them (`foretelling.restraint`)."""

    worse: float = 1.25
    """[of the error of the platform as given] by which a found model errs more, from which numbers are held. Chosen,
    not measured: beside a file that is right, what a fit of minutes errs by makes a tenth; the ferry's headings were
    3.4 times worse."""
    fewest: int = 3
    """[windows] fewer do not tell what foretells worse from chance. Chosen, not measured, as FREE_RUN_GAINS.fewest: of
    eight minutes of sound Lilys, with one window each, three would have had numbers held."""


FREE_RUNS = FreeRunCriteria()
FREE_RUN_GAINS = GainCriteria()
NAMELESS_FORCE = NamelessForceCriteria()
RESTRAINT = RestraintCriteria()
