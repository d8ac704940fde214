"""Findings of a diagnosis: the content of diagnosis.json, typed, and series that only the report shows."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Literal

from cocorosim_ros.world.state.state import SURGE, YAW, YAW_RATE, X

if TYPE_CHECKING:  # the compiler behind these would double the time to the help of `cocorosim diagnose`
    from cocorosim_ros.foundation.arrays import Floats
    from cocorosim_ros.world.laws.law import Law
    from cocorosim_ros.world.terms.course import Course

Verdict = Literal["consistent", "recalibrate", "mismatch", "insufficient"]
Tier = Literal["suspected", "confirmed"]
Against = Literal["readings", "course"]
"""Measure of errors: readings, or the recalibrated model's course where no reading shows the state."""
Regime = Literal["turning", "straight", "fast", "slow", "deep", "shallow", "climbing", "east", "west", "north", "south"]
"""Parts of a course by motion or by place: beyond or below the median of that course."""


@dataclass(frozen=True)
class Clock:
    """A recording, and the moment [ns], by its stamps, from which all times [s] about it count."""

    recording: str
    start_ns: int


NO_CLOCK = Clock("", 0)
"""Clock of a course that is of no recording."""


@dataclass(frozen=True)
class Estimate:
    """A number with its 95 % interval, which may reach further than it can by its meaning (between, as of a share).

    limits: between which a fit looks for it, as the range of the platform's file. at_limit: whether it stands at one.
    """

    value: float
    low: float
    high: float
    unit: str
    between: tuple[float, float] = field(default=(-math.inf, math.inf), compare=False)
    limits: tuple[float, float] = (-math.inf, math.inf)
    at_limit: bool = False

    def wider(self, times: float) -> Estimate:
        """Copy it with an interval that reaches so many times as far to either side."""
        return replace(self, low=self.value - times * (self.value - self.low),
                       high=self.value + times * (self.high - self.value))  # fmt: skip

    def holds(self, value: float) -> bool:
        """Tell whether a value lies in the interval."""
        return self.low <= value <= self.high


@dataclass(frozen=True)
class Recalibrated:
    """A parameter of the platform, as fitted to these robots."""

    parameter: str
    nominal: float
    estimate: Estimate
    robots: tuple[str, ...]


@dataclass(frozen=True)
class Concentration:
    """A regime that holds more of the evidence than of the time."""

    regime: Regime
    share: float  # of the evidence


@dataclass(frozen=True)
class Located:
    """A difference of simulation and recording: its equation, its regressor, its place and its time."""

    robots: tuple[str, ...]
    equation: str
    regressor: str
    where: Concentration | None  # None: throughout
    when: tuple[float, float]  # s
    size: float
    unit: str
    z: float
    law: Law | None = None  # that stands out, if it is one outside the catalogue
    swing: tuple[float, float] = (0.0, 0.0)  # rate [rad/s] and phase [rad] of a law that swings in time


@dataclass(frozen=True)
class Rival:
    """Another explanation, so many nats behind."""

    id: str
    nats_behind: float


@dataclass(frozen=True)
class FoundEffect:
    """An effect that the model lacked, its law and its numbers, by the identifiers of the contract."""

    id: str
    name: str
    equation: str
    robots: tuple[str, ...]
    tier: Tier
    parameters: Mapping[str, Estimate]
    nats: float
    ambiguous_with: tuple[Rival, ...] = ()
    topic: str | None = None
    correction: str | None = None  # of a frame mix-up, in words
    held_out_nats: float = float("nan")  # what it gains on data that its fit did not see
    settings: Mapping[str, float] = field(default_factory=dict)  # what the simulator's effect needs beside `parameters`
    simulated_as: str = ""  # the effect of the simulator behind a law outside the catalogue, if it has one
    law: Law | None = None  # which `id` names, if it is one outside the catalogue
    because: tuple[str, ...] = ()  # sentences: for which it is suspected, however strong the evidence


@dataclass(frozen=True)
class PassedOver:
    """An effect that evidence speaks for, but that gets no name; it is not in the found model.

    found: as it would have been named, with the nats by which the model is worse without it. stands: whether something
    is missing all the same. because: sentences, why it gets no name. shortly: the first of them in a few words.
    """

    found: FoundEffect
    stands: bool
    because: tuple[str, ...]
    shortly: str


@dataclass(frozen=True)
class HeldOut:
    """Root mean square error of free runs on data that no fit saw, of one channel, or of a stream's readings.

    noise_floor: of a model with a force without a name, which does not depend on the augmented one and may err more;
    of a stream, what noise of the readings and of the course makes.
    """

    nominal: float
    recalibrated: float
    augmented: float
    noise_floor: float
    unit: str
    intervals: Mapping[str, tuple[float, float]] = field(default_factory=dict)  # 95 %, of nominal, recalibrated, ...
    seconds: float | None = None  # that a free run lasts; streams have none
    against: Against = "readings"


@dataclass(frozen=True)
class ScreenedEffect:
    """One entry of the catalogue, or law outside it, as it was screened: what it could explain at first, and show."""

    id: str
    nats: float  # gained by it alone over the recalibrated model
    detectable: Mapping[str, float]  # per parameter the smallest value that these recordings would show
    seen_from: float = 0.0  # [of a bad case] size of all its amplitudes from which it would show


@dataclass(frozen=True)
class NotLookedFor:
    """An effect that was not looked for, since the platform's file does not give the numbers that it needs, by key."""

    id: str
    name: str
    numbers: tuple[str, ...]


@dataclass(frozen=True)
class ResidualForce:
    """Force that the model lacks along a course, from the smoother.

    force and spread (n, 4): X, Y, Z [N], N [N m] in body axes and their standard deviations. course: what the force may
    depend on, at the same n moments.
    """

    robot: str
    force: Floats
    spread: Floats
    course: Course
    clock: Clock = NO_CLOCK

    @property
    def time(self) -> Floats:
        """(n,) [s]."""
        return self.course.time

    @property
    def place(self) -> Floats:
        """(n, 4) x, y, z [m], yaw [rad]."""
        return self.course.state[:, X : YAW + 1]

    @property
    def velocity(self) -> Floats:
        """(n, 4) u, v, w [m/s], r [rad/s]."""
        return self.course.state[:, SURGE : YAW_RATE + 1]


@dataclass(frozen=True)
class ResidualReading:
    """Deviation of a stream's readings from those that the model expects, over time; (n,) each.

    against: what the deviation is drawn over, such as the yaw [rad] for a compass, named `regressor`.
    """

    robot: str
    topic: str
    unit: str
    regressor: str
    time: Floats
    against: Floats
    before: Floats  # of the recalibrated model
    after: Floats  # of the model with the effects
    against_unit: str = "1"


@dataclass(frozen=True)
class BodyVelocity:
    """Velocities (n, 4) u, v, w [m/s] and r [rad/s] along and about the robot's own axes, tilted as recorded."""

    through_water: Floats
    over_ground: Floats


@dataclass(frozen=True)
class CourseVelocity:
    """Velocity along the smoothed course of the model with the effects, at (n,) moments [s] of a whole recording."""

    robot: str
    time: Floats
    velocity: BodyVelocity
    clock: Clock = NO_CLOCK


@dataclass(frozen=True)
class FreeRun:
    """One stretch of held-out data and the free runs of the models through it; (n,) and (n, 4) x, y, z, yaw.

    measured: what the errors are measured against, NaN at moments without a reading. velocity: of the augmented model.
    """

    robot: str
    time: Floats
    measured: Floats
    nominal: Floats
    recalibrated: Floats
    augmented: Floats
    clock: Clock = NO_CLOCK
    velocity: BodyVelocity | None = None


@dataclass(frozen=True)
class GatheredEvidence:
    """Evidence for the model with the effects over the recalibrated one, from the readings up to each moment; (n,)."""

    robot: str
    time: Floats  # s
    nats: Floats
    clock: Clock = NO_CLOCK


@dataclass(frozen=True)
class ActuatorReport:
    """One quantity (of QUANTITIES) that an actuator reports, and how it follows its commands, by recordings alone.

    numbers: gain (1 between shares or angles, else the report at full command), delay, time_constant of a lag of first
    order, lateness (both), rate_limit of an angle that shows one; none where they are not told, and because says why.
    before: those of the recordings that these are compared with. of_amount: whether the amount of the command is meant.
    """

    robot: str
    actuator: str
    quantity: str
    numbers: Mapping[str, Estimate] = field(default_factory=dict)
    because: str = ""
    of_amount: bool = False
    before: Mapping[str, Estimate] = field(default_factory=dict)


@dataclass(frozen=True)
class Comparison:
    """The recordings of the same vehicle that a diagnosis compares with, and the control that they are alike.

    learned: effects of the catalogue, and laws, that the vehicle was given beside the platform's own numbers.
    control: what one half of these recordings differs in from the other, by the same comparison; () if in nothing.
    spreads: by difference, how often its evidence was divided because alike recordings differ too.
    before: the learned vehicle's numbers.
    taken_back: effects that were learned, but with which the model ran away from the recordings to be judged.
    seen_from: by effect (effect:topic where each stream may have it) and number the size from which a difference would
    have been named [unit of the number; share of a factor].
    in_doubt: effects and numbers with evidence enough, but without a name: free runs through unseen data gain nothing
    by them, or their size may as well be nothing.
    remarks: what was odd about these recordings, as sentences that begin with --against.
    unlike: robots whose numbers differ so much that they do not look like the same vehicle; nothing is named then.
    """

    recordings: tuple[str, ...]
    learned: tuple[str, ...]
    control: tuple[str, ...]
    spreads: Mapping[str, float] = field(default_factory=dict)
    before: tuple[Recalibrated, ...] = ()
    taken_back: tuple[str, ...] = ()
    seen_from: Mapping[str, Mapping[str, float]] = field(default_factory=dict)
    in_doubt: tuple[str, ...] = ()
    remarks: tuple[str, ...] = ()
    unlike: tuple[str, ...] = ()


@dataclass(frozen=True)
class Unrecorded:
    """Record of what recordings do not show, so that pages leave it out."""

    readings: tuple[str, ...] = ()  # kinds that never vary, such as a height that a map fixes
    absent: tuple[str, ...] = ()  # kinds without any number, of streams that are there, such as an acceleration
    depth: bool = False  # whether nothing shows a change of depth


@dataclass(frozen=True)
class Diagnosis:
    """All findings of a diagnosis."""

    verdict: Verdict
    sentence: str  # the headline
    recalibrated: tuple[Recalibrated, ...]
    mismatch: tuple[Located, ...]
    effects: tuple[FoundEffect, ...]
    not_shown: tuple[str, ...]
    manoeuvres: tuple[str, ...]  # that would show more, by the names of report.advice.MANOEUVRES
    fit: Mapping[str, HeldOut]
    all_recalibrated: tuple[Recalibrated, ...] = ()  # also those whose interval holds the nominal value
    screened: tuple[ScreenedEffect, ...] = ()
    residual_before: tuple[ResidualForce, ...] = ()  # of the recalibrated model
    residual_after: tuple[ResidualForce, ...] = ()  # of the model with the effects
    readings: tuple[ResidualReading, ...] = ()
    free_runs: tuple[FreeRun, ...] = ()
    gathered: tuple[GatheredEvidence, ...] = ()
    velocities: tuple[CourseVelocity, ...] = ()
    remarks: tuple[str, ...] = ()
    needed_nats: float = float("nan")  # evidence from which an effect is reported
    noise: Mapping[str, Estimate] = field(default_factory=dict)  # random force of the water, noise of the sensors
    drag_form: str = ""  # of quadratic drag, where the platform's file does not say it and one is clearly best
    step: float | None = None  # of the filter by which the numbers were found [s]; None where nothing was fitted
    warnings: tuple[str, ...] = ()  # sentences: why nothing is more than suspected, and on free runs in other regimes
    untold: tuple[str, ...] = ()  # sentences: errors that no other reading tells, differences that free runs doubt
    against: Comparison | None = None  # what was compared with, if it was not the platform's file
    passed_over: tuple[PassedOver, ...] = ()  # effects without a name, since there is doubt that they are there
    reasons: tuple[str, ...] = ()  # sentences: for which nothing could be tested
    unlike: tuple[str, ...] = ()  # quantities, such as the speed, by which free runs go through parts unlike the fitted
    beyond_floor: tuple[str, ...] = ()  # channels in which free runs lack what no name and no number stands for
    unrecorded: Unrecorded = Unrecorded()
    screened_laws: tuple[ScreenedEffect, ...] = ()  # outside the catalogue, as they were screened at first
    actuators: tuple[ActuatorReport, ...] = ()  # what these report of themselves
    not_looked_for: tuple[NotLookedFor, ...] = ()  # for want of numbers in the platform's file
    held: tuple[str, ...] = ()  # numbers kept as the platform's file gives them: fitted, they foretell worse
