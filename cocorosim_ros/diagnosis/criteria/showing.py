"""Thresholds of what is shown: intervals, places, free runs, and the verdict."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class VerdictCriteria:
    """Tests that take an effect back, or call for a recalibration of the platform (`diagnose`)."""

    worse: float = 1.1
    """[of the error without the effects] a model with them that errs more is taken back. Chosen, not measured."""
    sure: float = 0.01
    """[probability] of a shift of all numbers together where none has moved. Chosen, not measured."""
    nearly_exact: float = 3.0
    """[of what the filter's steps err by] errors of free runs below it are those of steps, if the recalibrated model
    errs as much or more. Chosen, not measured: beside a hole of 12 s in clean recordings it was 1.5."""


@dataclass(frozen=True)
class EstimateCriteria:
    """Tests of a number that has moved, and of an effect that is confirmed (`showing.estimates`)."""

    sure: float = 0.05
    """[probability] of any clear number among all recalibrated ones where none has moved. Chosen, not measured."""
    beyond_threshold: float = 4.0
    """[nats] of a confirmed effect above the threshold of naming. Chosen, not measured."""
    numerical: float = 1e-3
    """[of a number] its least standard deviation: the error of the filter's midpoint steps. Reckoned from that error,
    (h l)^2 / 6, for steps h of 0.1 s and a rate l of 0.77 / s, at which Lilys turn. In still water, readings alone
    would give narrower intervals than the steps of the filter are exact."""
    held_out_p: float = 0.05
    """[probability] of a held-out gain by chance, below which an effect may be confirmed. Chosen, not measured."""
    moved: float = 1e-6
    """[of what is large] an amplitude that no slope tells of has moved, and so was told by larger steps, as a dead band
    is. Chosen, not measured: rounding moves others by 1e-12."""


@dataclass(frozen=True)
class FormWidthCriteria:
    """Difference of a number between parts of the recordings that widens its interval (`showing.form_width`)."""

    parts: int = 8
    """[parts] of each division: enough for a variance, each still with an eighth of the readings. Chosen, not
    measured."""
    sure: float = 1e-3
    """[probability] of a difference by chance: of thirty numbers in four divisions, one in ten fits has one.
    Chosen, not measured."""
    thrusters: float = 0.01
    """[1] standard deviation of gains of sound thrusters of one vehicle, beside which that of another is told. Chosen,
    not measured: intervals of weak ones missed by 1.5 and 3 % where the others differed by 1 to 3 %."""
    fewest: float = 3.0
    """[parts] that tell of the number, by the sum of their weights squared over the sum of their squares. Chosen, not
    measured."""


@dataclass(frozen=True)
class RemainderCriteria:
    """Force that is left over although effects are named (`showing.remainder`)."""

    share: float = 0.5
    """[of an effect's nats] from which what is left over says that the effect stands for another law. Chosen, not
    measured: laws of another form than the catalogue's leave a tenth, those that only resemble one half and more."""


@dataclass(frozen=True)
class HardStopCriteria:
    """Signs of a fit that has gone wrong, under which nothing is more than suspected (`showing.hard_stops`)."""

    chance: float = 0.05
    """[1] by which one of the amplitudes of an effect that is not there is called clear, by all of them together.
    Chosen, not measured: as of the 95 % intervals that are told."""
    worse: float = 1.1
    """[of the error of the platform as given] a recalibrated model that errs more has collapsed. Chosen, not measured,
    as VERDICT.worse is."""
    beside_law: float = 0.1
    """[of the nats of a law outside the catalogue] below which an entry of the same force may be what that law leaves.
    Chosen, not measured: as for confused entries beside an effect."""
    untold_alone: float = 20.0
    """[nats] of an error that no other reading tells, where nothing is named: well above what a name needs, since other
    forms of the drag resemble it. Chosen, not measured."""
    pressed: float = 8.0
    """[nats] gained by less than none of an effect that the platform's file has: as many as a name needs. Chosen, not
    measured."""
    strayed: float = 3.0
    """[noise of the readings] by which a smoothed course may leave most of its readings: normal noise leaves it by one.
    Chosen, not measured."""
    lost: float = 100.0
    """[noise of the readings] by which a course leaves readings that it does not follow at all. Chosen; measured: right
    models of eight real vehicles leave theirs by 7 at most, and those of another vehicle by 1400 to 3200."""
    lost_angle: float = 0.3
    """[rad] beside that, of headings; positions by the length of the hull. Chosen, not measured."""
    pascals_per_metre: float = 9.8e3
    """[Pa/m] by which depths are told from pressures where only their size matters. Known of water, to a digit."""
    no_heading: float = 1.2
    """[rad] by which most headings are off where nothing of them is followed. Reckoned from the 2.1 of headings of
    which nothing is known: more than half of it."""
    most: float = 0.6826894921370859
    """[share of the readings] that normal noise leaves within one standard deviation. Known of the distribution."""
    correlated: float = 0.5
    """[1] correlation of an innovation with the next of its kind: half of what is foretold wrongly is foretold wrongly
    again. Chosen, not measured."""
    material: float = 0.5
    """[of what the filter expects] of the standard deviation of innovations; below it they harm no interval, however
    regular they are. Chosen, not measured: exact readings of exact simulations are at 0.2 and less."""
    scale: float = 2.0
    """[of what the filter expects] of the standard deviation of innovations, beyond which its intervals are none.
    Chosen, not measured."""
    fewest: int = 30
    """[readings] fewer show no correlation. Chosen, not measured."""


@dataclass(frozen=True)
class BeyondFloorCriteria:
    """Free runs that err far more than the noise floor (`showing.beyond_the_floor`)."""

    clear: float = 3.0
    """[of the least error of a model without the effects, most often the noise floor] error of the model with all
    effects, from which something is missing. Measured: of 35 made recordings of strangers' vehicles those with the
    right names reached 2.3 times it, most 1.3, one with a wrong name 3.3, and one with a weight outside of its range 20
    times."""


@dataclass(frozen=True)
class UnsteadyCriteria:
    """Numbers that differ from one part of the recordings to the next (`showing.unsteady_numbers`)."""

    material: float = 0.15
    """[of the number] standard deviation between parts that is worth a sentence: what wears or warms changes less.
    Chosen, not measured: of a thruster that lost half of its thrust halfway it was 0.32."""
    most: float = 1.0
    """[of the number] beyond which parts tell hardly anything of it. Chosen, not measured."""
    beside: float = 0.8
    """[of the greatest] below which others follow that number. Chosen, not measured."""


@dataclass(frozen=True)
class UnevenNoiseCriteria:
    """Random force that is not the same at all times; evidence alone then confirms nothing (`showing.uneven_noise`)."""

    clear: float = 5.0
    """[standard deviations] of the score, which neighbouring readings share: more than the usual 3. Chosen, not
    measured."""
    growth: float = 0.3
    """[of the variance] with each standard deviation of speed or thrust. Chosen, not measured."""
    fewest: int = 100
    """[readings] of a kind; fewer tell no variance. Chosen, not measured."""


@dataclass(frozen=True)
class LocationCriteria:
    """Limits from which a difference of model and recording stands out, in all or in a regime (`showing.location`)."""

    clear: float = 5.0
    """[standard deviations] from which a law stands out. Measured: no clean recording of the study passed 3.7."""
    most: int = 6
    """[differences] that are listed. Chosen, not measured."""
    concentrated: float = 0.7
    """[of the evidence] in one regime, for the regime to be named. Chosen, not measured."""
    everywhere: float = 0.9
    """[of the moments] a regime that holds so many is none. Chosen, not measured."""


@dataclass(frozen=True)
class FramingCriteria:
    """Stand-in for evidence without doubt (`showing.framing`)."""

    certain: float = 1e4
    """[nats] of a correction that is certain, in place of infinity, which files cannot hold. Chosen, not measured."""


@dataclass(frozen=True)
class RegimeCriteria:
    """Difference of the held-out parts from the fitted ones, from which it is said (`showing.regimes`)."""

    middle: tuple[float, float] = (0.25, 0.75)
    """[quantiles] of the fitted parts between which the median of the held-out ones has to lie. Chosen, not
    measured."""
    steady: float = 0.05
    """[of the largest value] a spread of these quantiles below is taken as that wide. Chosen, not measured."""


VERDICT = VerdictCriteria()
ESTIMATES = EstimateCriteria()
FORM_WIDTH = FormWidthCriteria()
HARD_STOPS = HardStopCriteria()
REMAINDER = RemainderCriteria()
BEYOND_FLOOR = BeyondFloorCriteria()
UNSTEADY = UnsteadyCriteria()
UNEVEN = UnevenNoiseCriteria()
LOCATION = LocationCriteria()
FRAMING = FramingCriteria()
REGIMES = RegimeCriteria()
