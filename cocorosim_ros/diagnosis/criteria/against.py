"""Thresholds of the comparison with recordings of the same vehicle when it was well: what is learned, what is alike."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class LearningCriteria:
    """Numbers that a vehicle is given of its own (`against.learning`)."""

    worth: float = 1.0
    """[nats] from which an effect of the catalogue is a part of the learned vehicle. It is not named, so little
    evidence is enough: what is left out would be looked for as a difference. Chosen, not measured."""
    most: int = 8
    """[effects] that are learned beside those of the contest: each costs a screening. Chosen, not measured."""
    turns: int = 3
    """[turns of noise and unknowns] after all effects have been added. Chosen, not measured."""


@dataclass(frozen=True)
class AlikeCriteria:
    """The control: how much recordings that should be alike differ (`against.control`)."""

    quantile: float = 0.25
    """[probability] of a spread greater than the one that is taken, given what the recordings show: few recordings tell
    their spread badly, and less evidence is safer than more. Chosen, not measured."""
    parts: int = 6
    """[parts] of all recordings together that a spread is taken from; fewer recordings are cut. Chosen, not
    measured."""
    shortest: float = 20.0
    """[s] of a part into which a recording is cut. Chosen, not measured."""
    told: float = 1e-6
    """[information of the prior] a part that has less on a candidate tells nothing of it. Chosen, not measured."""
    weighed: int = 16
    """[candidates] of the best in a round whose spread is looked at: each costs slopes. Chosen, not measured."""


@dataclass(frozen=True)
class HalvesCriteria:
    """Difference of a number between the halves of recordings, from which a vehicle has changed (`against.halves`)."""

    sure: float = 0.05
    """[probability] of such a difference of any number by chance. The usual 5 %. Chosen, not measured."""
    large: float = 0.25
    """[logarithm] of a number, from which it is another vehicle's: a quarter more or less. A well one differs from day
    to day too. Chosen, not measured."""
    fewest: int = 2
    """[parts] of each half that tell the number: fewer have no scatter. Known of the variance."""


@dataclass(frozen=True)
class SameVehicleCriteria:
    """Signs that two sets of recordings are of different vehicles (`against.same_vehicle`, `showing.other_vehicle`)."""

    command_quantile: float = 0.95
    """[probability] of commands that are compared by size, so that single pulses do not count. Chosen, not measured."""
    command_ratio: float = 5.0
    """[1] quotient of the sizes of commands on both sides, from which they are not of one use of one vehicle: laws that
    were learned at one fifth of the thrust say little. Chosen, not measured."""
    declared_ratio: float = 1.25
    """[1] quotient of the lengths of a hull, or of masses, in the scenarios of recordings, from which these are of two
    vehicles. One that carries something is the same still. Chosen, not measured."""
    number_ratio: float = 4.0 / 3.0
    """[1] factor by which a number of the vehicle has to differ with its whole 95 % interval to speak for another one.
    Measured: of two made boats one with twice the mass and drag, and three times the inertia and thrust, is 1.5 off in
    thrust and inertia, relative to its mass, and one of half the mass 1.5 in inertia. Chosen below these."""
    kinds: int = 2
    """[kinds of numbers: thrust, drag, inertia, buoyancy, form of the hull] that have to differ so much at once: one
    cause changes numbers of one kind, but for a load and growth. Measured: none of 680 altered logs of real vehicles,
    in five draws, named two such numbers. That the form of a hull counts was taken from one pair of tankers."""
    use: float = 2.0
    """[1] factor of mass or inertia that a load makes, and of drag or thrust that growth on hull and propellers makes,
    at most: beyond it one vehicle would hardly be used. Chosen, not measured."""
    alike: float = 1.2
    """[1] quotient within which factors are one, as those of a load are: all forces are known relative to mass. Wider
    than intervals of fits, whose forms are not quite the vehicle's. Chosen, not measured."""


@dataclass(frozen=True)
class ComparisonCriteria:
    """Limits of what a comparison says (`diagnose_against`, `against.differences`)."""

    apart: float = 1.96
    """[standard deviations] from neutral, below which a number of a difference may be nothing: then a rival with fewer
    numbers, an offset for a drift, is named in its place. The usual 95 %. Chosen, not measured."""
    surer: float = 1.3143
    """[of the reach of 95 % intervals] within which a difference may be nothing, and is not named: that of 99 %, since
    the best of many is taken. Measured: in two draws of altered logs, of four differences between the two, delays
    aside, two were something else, of 32 beyond them four."""
    runaway: float = 1e6
    """[standard deviations of an innovation per unit of a number] from which a model does not follow recordings but
    runs away from them. Measured in six recordings of a hovercraft: at most 74 where the model follows, and 1e85 where
    a learned law runs away. Between them: chosen, not measured."""
    torn: float = 5.0
    """[standard deviations] of a learned number, by which one that is shared has to leave it for a joint fit to be
    torn. Chosen, not measured: halves of sound recordings differ by one or two."""
    missed: float = 0.05
    """[probability] of a difference of the size that is told as the least to be named, and is not named all the same.
    Known of Currie, Analytical Chemistry 40 (1968) 586: the detection limit of chemists."""
    louder: float = 2.0
    """[1] quotient of the nats of two candidates, not divided by their spreads, from which the readings speak louder
    for one of them. Chosen, not measured."""
    heard: float = 0.5
    """[of the threshold of a name] of nats, divided by its spread, from which such a candidate is a rival all the same:
    recordings that are alike differ in it too, but hardly by as much. Chosen, not measured."""
    instruments_apart: float = 8.0
    """[nats] by which an error of one instrument has to be ahead of that of another to have a name. Which of a camera
    and a speed log is right is told by the learned vehicle alone, whose forms are not quite its own: in a pool, the log
    was ahead by 3.02 where the camera was wrong. Chosen, not measured."""
    instruments_share: float = 0.02
    """[of its own nats] by which it has to be ahead too: what the forms of the learned vehicle are off by grows with
    the evidence. Of a tanker's 200,000 nats the log was ahead by 1,750, and by 150 from other starts, where the camera
    was wrong. Chosen, not measured."""
    least_shown: int = 3
    """[effects of the catalogue] that would have shown at medium size; with fewer, silence tells nothing. A recording
    need not show as much as for a diagnosis of a platform's file, since only changes are asked for. Chosen, not
    measured."""


@dataclass(frozen=True)
class ChangeCriteria:
    """Sizes of changes in the platform's own numbers (`against.numbers`)."""

    late_readings: float = 5.0
    """[readings] by which a stream is late in a bad case, where that is longer than what the catalogue has. Chosen, not
    measured."""


@dataclass(frozen=True)
class AxesOfVehicleCriteria:
    """Axes of judged poses that are told by the learned vehicle (`against.axes`)."""

    lead: float = 100.0
    """[nats] by which turned poses have to be likelier than as they are, and than otherwise turned ones. Mirrored ones
    of a tanker in the wind, put right, are so by 320; sound ones of it and of a hovercraft, turned, are behind by 1,900
    and more. Between them: chosen, not measured."""
    rounds: int = 12
    """[steps] of the noise, so that it may grow where the vehicle foretells badly. Chosen, not measured."""


AXES_OF_VEHICLE = AxesOfVehicleCriteria()
CHANGES = ChangeCriteria()
LEARNING = LearningCriteria()
ALIKE = AlikeCriteria()
HALVES = HalvesCriteria()
SAME_VEHICLE = SameVehicleCriteria()
COMPARISON = ComparisonCriteria()
