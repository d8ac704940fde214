"""Thresholds of the fits and of their tracks: when a fit has ended, what random force may be, where water ends."""

from __future__ import annotations

import math
from dataclasses import dataclass


@dataclass(frozen=True)
class ConvergenceCriteria:
    """Gains at which a fit has ended (`fitting.fit`, `fitting.leaps`)."""

    least_gain: float = 0.02
    """[nats] an iteration that gains less has converged. Chosen, not measured."""
    settled: float = 0.1
    """[nats] a turn of noise and laws that gains less ends the fit. Chosen, not measured."""
    worth: float = 1.0
    """[nats] a leap of the noise has to gain more. Chosen, not measured."""


@dataclass(frozen=True)
class RandomForceCriteria:
    """Bounds between which a force of the water is random (`fitting.recalibration`)."""

    most_correlation: float = 60.0
    """[s, of a Lily; see slowness] a push that lasts longer is a force that an effect has to explain. Measured:
    without the bound, one sealed recording took a constant torque and trim for a random force of 45 minutes; 33 others
    without random force, and 22 with nothing hidden, give the same with and without the bound, to 0.2 nats."""
    least_smoothness: float = 0.04
    """[1] one rate of the process is a hundred times the other. Chosen, not measured."""


@dataclass(frozen=True)
class RecalibrationCriteria:
    """Widths of priors, and when the first guess of the noise is wrong (`fitting.recalibration`)."""

    prior: float = 0.2
    """[1] standard deviation of the logarithm of a number that the platform gives without a range. Chosen, not
    measured."""
    range_widths: float = 4.0
    """[standard deviations of a prior] in the range that a platform's file gives. Chosen, not measured."""
    shut: float = 0.2
    """[share of the readings of a kind] beyond the gate, from which their noise is taken as wrong. Chosen, not
    measured."""
    doubt: float = math.log(20.0)
    """[logarithm] by which noise of inertial sensors is raised for a further start. Chosen, not measured."""
    coarse: float = math.log(10.0)
    """[logarithm] by which noise of readings beyond the gate is raised for a further start. Chosen, not measured."""
    at_random: float = math.log(10.0)
    """[logarithm] by which random forces are stronger and quicker for a further start. Chosen, not measured."""
    most_doublings: int = 12
    """[doublings] of the noise of readings beyond the gate: to 4000 times. Chosen, not measured."""
    most_rounds: int = 10
    """[turns of noise and unknowns] at most; a good start needs two or three. Chosen, not measured."""
    most_regriddings: int = 2
    """[fits] anew with steps of the filter that the found numbers ask for. Chosen, not measured."""
    alike_steps: float = 1.3
    """[1] quotient of two steps of the filter below which they are taken as equal. Chosen, not measured."""
    most_leaps: int = 4
    """[leaps] at most, each followed by a climb. Chosen, not measured."""


@dataclass(frozen=True)
class VehicleNeedsCriteria:
    """Needs of effects: a vehicle that does not meet them does not show these (`fitting.vehicle_needs`)."""

    tall: float = 0.1
    """[m] height of a hull whose bobbing the filter's steps just follow. Reckoned from its rate: such a one bobs at the
    surface by one radian in 0.1 s."""
    slender: float = 4.0
    """[1] length over width of a hull, from which it lifts at an angle of drift as a wing does. Chosen, not measured:
    ships have 5 to 7, torpedoes and gliders 6 to 10, frames of thrusters and round robots 1 to 2."""
    pushes: float = 1e-6
    """[of a unit of force] to the side; less is rounding in a direction. Reckoned from the digits of directions in
    files."""
    in_a_jet: float = 0.05
    """[share of a thrust] that a thruster loses at least in the jet of another one by the law of `wash_loss`, wherever
    azimuths turn both. Chosen, not measured: thrusts are hardly known to a twentieth."""
    air: float = 100.0
    """[kg/m^3] density of what a vehicle moves in, below which it is called air. Chosen, not measured."""
    turned: int = 73
    """[directions] of a thruster that an azimuth turns, in which this is asked. Chosen, not measured: every 5 degrees
    of a full turn, a small part of a jet's width."""


@dataclass(frozen=True)
class GrowingForceCriteria:
    """Random force that grows with speed or thrust (`fitting.growing_force`)."""

    usual: float = 1.0
    """[of the random force at rest] what is added to it at the highest speed or thrust, where the fit begins. Chosen,
    not measured."""
    prior: float = 1.5
    """[1] standard deviation of the logarithm of that. Chosen, not measured."""
    farthest: float = 4.0
    """[1] largest change of that logarithm: from 0.02 to 55 times. Chosen, not measured."""
    highest: float = 0.95
    """[quantile] of speed and thrust that is taken as the highest one. Chosen, not measured."""
    worth: float = 3.0
    """[nats] the growth of one robot's random force with one quantity has to gain. Chosen, not measured."""
    hopeful: float = 1.5
    """[nats] growth of one robot's random force with both quantities has to gain for growth with one to be tried.
    Below `worth`, since a number that is not needed costs its prior. Chosen, not measured."""
    rounds: int = 4
    """[steps] of the random forces' numbers, in which a growth has to show. Chosen, not measured: a made boat needs
    three."""
    trace: float = 1e-3
    """[of the full force] a random force below is none: exact recordings differ from the filter's steps by less, which
    grow with speed too. Chosen, not measured."""


@dataclass(frozen=True)
class ColouredReadingsCriteria:
    """Errors of readings that are not white (`fitting.coloured_readings`)."""

    correlated: float = 0.2
    """[1] correlation of an innovation with the one before of its kind, from which on colour is tried: readings then
    count 1.5 times too often. Chosen, not measured."""
    material: float = 0.5
    """[of what the filter expects] mean square of innovations; below it readings are more exact than any noise. Chosen,
    not measured: of noise that is fitted it is 1."""
    most_correlated: float = 1.0 - 1e-6
    """[1] correlation that is taken for a memory: more is rounding. Chosen, not measured."""
    fewest: int = 30
    """[readings] with one before, for a correlation. Chosen, not measured."""
    prior: float = 1.5
    """[1] standard deviation of the logarithm of a memory, around the one that the correlation gives. Chosen, not
    measured."""
    farthest: float = 4.0
    """[1] largest change of that logarithm. Chosen, not measured."""
    worth: float = 10.0
    """[nats] that the colour of one number of noise has to gain. Chosen, not measured."""
    most: float = 0.5
    """[of a robot's instruments] have to show colour if it is to be taken into the first fit. Chosen, not measured."""
    instruments: int = 3
    """[instruments] at least that have to do so: one fault does not concern so many. Chosen, not measured."""
    shaken: float = 3.0
    """[of all actuators at their limits] beyond which a random force is incredible, so that lasting errors are tried.
    Known of two vehicles: 5.7 of a ship whose places err alike for seconds, 2.1 at most of a hovercraft."""
    quick: float = 3.0
    """[readings] for which errors last at first, where white ones would need a random force beyond all actuators.
    Chosen, not measured."""
    rounds: int = 2
    """[steps] of memory and noise of a kind, in which its colour has to show. Chosen, not measured: where errors last
    for five readings it gains hundreds of nats in the first."""
    walk_rounds: int = 6
    """[steps] of a wander of places and the white errors beside it, which start from errors with a memory. Chosen, not
    measured: a walk of 10 mm in a second beside 2 mm needs five."""


@dataclass(frozen=True)
class OwnCurveCriteria:
    """Curves of thrusters that differ from the platform's (`tracks.own_curves`)."""

    commands: int = 81
    """[commands] of the table of a curve: a square law between two of them errs by 0.06 % of full thrust at most.
    Reckoned from its second derivative, 2, times an eighth of the square of their distance."""


@dataclass(frozen=True)
class DragFormCriteria:
    """The comparison of forms of the drag that a platform's file does not say (`fitting.drag_forms`)."""

    clear: float = 10.0
    """[nats] by which a form has to be ahead of the total speed. Chosen, not measured."""
    prior: float = 1.0
    """[1] standard deviation of the logarithm of a ratio between two axes. Chosen, not measured: hulls have
    ratios of 1 to 10."""
    most_ratio: float = 50.0
    """[1] largest ratio between two axes, and one over the smallest. Chosen, not measured:
    beyond that of a flat plate edge on."""
    steps: int = 4
    """[1] Gauss-Newton steps before and after the noise is fitted. Chosen, not measured."""
    worth_noise: float = 0.3
    """[1] share of the nats it needs that a form has to gain before its noise is fitted. Reckoned from errors whose
    variance is ten times too large for the right form: held, they leave (1 - 1/10) / ln 10 = 0.39 of its nats."""


@dataclass(frozen=True)
class SurroundingsCriteria:
    """Assumptions on the tank, which no recording shows (`tracks.surroundings`)."""

    shore: float = 0.1
    """[m] between the farthest place of any robot and the wall. Chosen, not measured."""
    lowest: float = 0.02
    """[1] quantile of the heights that counts as the lowest place, its counterpart as the highest, so that a few faulty
    readings do not. Chosen, not measured."""
    alike: float = 1.25
    """[1] quotient of two sides of a tank, below which they are taken as equal. Chosen, not measured."""


@dataclass(frozen=True)
class GridCriteria:
    """Steps of the filter's grid, and what one step may err by (`tracks.grid`)."""

    longest_step: float = 0.1
    """[s] of vehicles that coast for less than six seconds. Chosen, not measured."""
    steps_of_coasting: float = 60.0
    """[steps] that make the shortest coasting time of a slower vehicle: a midpoint step h errs by (h l)^2 / 6 of a
    motion that fades at the rate l, here 2e-4. Reckoned from that."""
    slowest_step: float = 1.0
    """[s] however slow the vehicle is. Chosen, not measured."""
    shortest_step: float = 0.01
    """[s] however agile the vehicle is; steps are multiples of it. Chosen, not measured."""
    yaw_error: float = 0.005
    """[rad] of a step under full acceleration. Chosen, not measured."""
    place_error: float = 0.001
    """[m] of a step under full acceleration. Chosen, not measured."""


@dataclass(frozen=True)
class StartCriteria:
    """The first state of a track, and how sure it is (`tracks.start`)."""

    window: float = 0.5
    """[s] in which the first readings are looked for. Chosen, not measured."""
    place: float = 0.05
    """[m] least standard deviation of the first place. Chosen, not measured."""
    of_noise: float = 3.0
    """[of the noise of the reading that shows it] the same: such a reading counts once more as itself. Chosen, not
    measured."""
    yaw: float = 0.2
    """[rad] standard deviation of the first yaw. Chosen, not measured."""
    speed_share: float = 0.5
    """[of the speed that full thrust gives in a metre] standard deviation of the first speeds. Chosen, not
    measured."""
    least_speed: float = 0.05
    """[m/s, of a Lily; slower vehicles have less] least standard deviation of the first speeds, for vehicles that
    hardly drive. Chosen, not measured."""
    least_turn: float = 0.3
    """[rad/s] the same of the first yaw rate. Chosen, not measured."""
    steps: int = 3
    """[turns] of secant steps for a start under errors of the instruments that showed it: one is exact for errors that
    are linear and of one number each, and the distortion of a compass is nearly so. Chosen, not measured."""
    secant: float = 1e-3
    """[m, rad] of these steps. Chosen, not measured."""


@dataclass(frozen=True)
class FullForceCriteria:
    """Likely ratios of full forces, in directions where a vehicle has no actuator (`tracks.vehicle_size`)."""

    across: float = 0.1
    """[of the full force in heave] a horizontal force, or one of the water in heave. Chosen, not measured."""
    arm: float = 0.02
    """[m] by which the full horizontal force turns a vehicle. Chosen, not measured."""


@dataclass(frozen=True)
class FirstNoiseCriteria:
    """The noise at which fits begin, and how far they may leave it (`fitting.base_model`)."""

    disturbance: float = 0.01
    """[of full thrust] rms of the random forces. Chosen, not measured."""
    correlation: float = 2.5
    """[s, of a Lily; see slowness] memory of the random forces. Chosen, not measured."""
    smoothness: float = 0.4
    """[1] of the random forces. Chosen, not measured."""
    force_prior: float = 3.0
    """[logarithm] standard deviation of the strength of a random force. Chosen, not measured."""
    correlation_prior: float = 0.7
    """[logarithm] standard deviation of the memory. Chosen, not measured."""
    smoothness_prior: float = 1.0
    """[logarithm] standard deviation of the smoothness. Chosen, not measured."""
    farthest: float = 7.0
    """[logarithm] by which random forces may leave the first guess. Chosen, not measured."""
    reading_prior: float = 0.7
    """[logarithm] standard deviation of the noise of a reading. Chosen, not measured."""
    finer_reading: float = 3.0
    """[logarithm] by which a reading may be finer than its differences say. Chosen, not measured."""
    coarser_reading: float = 5.0
    """[logarithm] by which a reading may be coarser than its differences say. Chosen, not measured."""
    farthest_number: float = 4.0
    """[logarithm] by which a number of the platform may leave its file. Chosen, not measured."""


@dataclass(frozen=True)
class StepCriteria:
    """Steps of the climbs to the most likely numbers (`fitting.climbing`, `leaps`, `starts`, `solving`)."""

    largest_noise_step: float = 1.0
    """[logarithm] of a noise in one step: farther away the curvature says little. Chosen, not measured."""
    noise_difference: float = 0.02
    """[logarithm] of a noise for its slopes: far above rounding, and small beside 1. Chosen, not measured."""
    beside_noise: float = 1e-4
    """[standard deviations; logarithm of a noise] for slopes of numbers and noise together: small, since a reading that
    is believed before the step alone bends all behind it. Measured: of a hovercraft, with 0.01 one was, and a common
    factor seemed known to a tenth; 0.001 and less give its width."""
    dampings: tuple[float, ...] = (0.0, 0.3, 3.0, 30.0, 300.0)
    """[of the curvature of each noise] that are tried one after the other. Chosen, not measured."""
    leaps: tuple[float, ...] = (-2.0, -1.0, 1.0, 2.0)
    """[logarithm] changes of a noise that may land on a higher summit. Chosen, not measured."""
    cautious: float = 0.3
    """[of the promised amplitudes] a second start, where the slope promises too much. Chosen, not measured."""
    level: float = 1e-5
    """[of what a search's grid spans in nats] by which two points are equally high. Chosen, not measured: from one
    command to the next a likelihood of thousands of nats is level to a hundredth of a nat."""
    softest: float = 1000.0
    """[of the noise of a reading] as which readings count at first where a scale's summit is looked for. Chosen, not
    measured: of poses that are exact to a tenth of a millimetre and a tenth too long 300 is enough, and 30 is not."""
    softer: tuple[float, ...] = (1.0, 2.0 / 3.0, 1.0 / 3.0)
    """[of the logarithm of that] by which readings count less in one climb after the other. Chosen, not measured."""
    soft_rounds: int = 3
    """[steps] of each such climb, whose likelihood is nearly a parabola. Chosen, not measured."""
    of_phase: float = 0.1
    """[rad] by which a step of a period may move the phase at the end of a recording, for slopes. Chosen, not measured:
    a sine is a straight line over so much."""
    beyond_grid: float = 0.1
    """[logarithm] by which a shape may exceed the largest value of its grid. Chosen, not measured."""
    no_information: float = 1e-10
    """[of the mean eigenvalue] of a scaled information matrix: a direction with less is rounding. Chosen, not
    measured."""
    at_bound: float = 1e-3
    """[of q] nearer to its bound a number stands at it: steps are cut there exactly. Chosen, not measured."""
    start: float = 0.01
    """[of what a track's start may be off] for slopes by it: far above rounding, and small beside 1. Chosen, not
    measured."""
    least_push: float = 1e-9
    """[of an unknown's unit] by which a bound is tried: far below any step. Chosen, not measured."""


@dataclass(frozen=True)
class PolishingCriteria:
    """Last steps by exact slopes (`fitting.polishing`)."""

    worth: float = 0.3
    """[nats] that a step has to promise, and to gain. Chosen; measured: with 1 nat a Lily's fit ended 8 nats below its
    summit."""
    most_steps: int = 30
    """[steps] at most, each of one pass for every number. Chosen, not measured: a glider's fit took 10, a tanker's
    45."""
    difference: float = 0.02
    """[standard deviations] of a number for its slope. Chosen, not measured."""
    least_curvature: float = 1e-6
    """[1] of a number of which the recordings tell nothing. Chosen, not measured."""
    least_width: float = 1e-6
    """[of q] that is taken as the width of a number, which rounding hides below that. Chosen, not measured."""
    largest_step: float = 1.0
    """[of q] in one step: farther away the curvature says little. Chosen, not measured."""


@dataclass(frozen=True)
class HeldOutCriteria:
    """Blocks of the recordings that tell whether an addition foretells (`fitting.held_out`)."""

    blocks: int = 10
    """[blocks] of each recording: enough for a signed-rank test at 5 %. Chosen, not measured."""
    curved: float = 20.0
    """[nats] by which a block may be foretold worse than it is fitted, for a step by slopes to be trusted. Chosen, not
    measured: that of a hovercraft, whose other 29 blocks differ by 10 at most, differed by 566."""


@dataclass(frozen=True)
class ActingAnglesCriteria:
    """Comparison of reported angles with those ordered (`fitting.acting_angles`)."""

    delays: tuple[float, ...] = (0.1, 0.2, 0.4, 0.8, 1.6)
    """[s] that either is given: of servos, of telemetry, of receivers. Chosen, not measured: poses of a ferry come 0.5
    to 0.8 s behind the angles of its pods, be they reported or ordered."""
    clear: float = 20.0
    """[nats] by which reported angles have to be ahead. Measured: 703 of a boat whose outboard turns by 150 deg/s; of a
    ferry whose reports are smoothed 15 in one half of its recordings and -88 in the other."""


ACTING_ANGLES = ActingAnglesCriteria()
OWN_CURVES = OwnCurveCriteria()
DRAG_FORMS = DragFormCriteria()
GROWING_FORCE = GrowingForceCriteria()
COLOURED = ColouredReadingsCriteria()
VEHICLE_NEEDS = VehicleNeedsCriteria()
CONVERGENCE = ConvergenceCriteria()
RANDOMNESS = RandomForceCriteria()
RECALIBRATION = RecalibrationCriteria()
SURROUNDINGS = SurroundingsCriteria()
GRID = GridCriteria()
START = StartCriteria()
FULL_FORCES = FullForceCriteria()
FIRST_NOISE = FirstNoiseCriteria()
STEPS = StepCriteria()
POLISHING = PolishingCriteria()
HELD_OUT = HeldOutCriteria()
