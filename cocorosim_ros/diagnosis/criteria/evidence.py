"""Thresholds of the evidence: what counts as a reading, one clock, an unbroken track, and enough of all of these."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class ExcitationCriteria:
    """Limits at which an actuator counts as varied, reversed, off or near zero (`streams.excitation`)."""

    step: float = 0.1
    """[of the maximum] a change of the command that is sudden enough to start a motion. Chosen, not measured."""
    tiny: float = 5e-3
    """[of the maximum] smaller commands are off, smaller changes none; slow ramps still count. Chosen, not measured."""
    near_zero: float = 0.1
    """[of the maximum] a command in the range where dead bands and dry friction act. Chosen, not measured."""
    look_back: float = 5.0
    """[s] for which an actuator counts as varied after a change, since motions last. Chosen, not measured."""


@dataclass(frozen=True)
class NoiseCriteria:
    """Limits within which differences of readings show noise, not motion, gaps or slow sensors (`streams.noise`)."""

    widest_span: float = 1.6
    """[of the median window] a wider window crosses a gap, over which motion shows. Chosen, not measured."""
    motion_shows: float = 0.93
    """[of the lower order's estimate] a higher order below it means that motion was left in. Chosen, not measured."""
    quiet_quantile: float = 0.25
    """[1] quantile of the blocks' scales that is taken as quiet. Chosen, not measured."""
    stretches: int = 24
    """[stretches] of the time at most, among which the quiet ones are sought. Chosen, not measured."""
    uneven: float = 0.7
    """[of the whole's scale] even noise never makes the quiet quarter so small by chance. Chosen, not measured."""
    fewest: int = 30
    """[residuals] fewer give no standard deviation to one digit. Chosen, not measured."""
    repeated: float = 0.2
    """[share of readings] equal to the one before: the sensor is slower than its messages. Chosen, not measured."""
    rounding: float = 1e-9
    """[of the largest reading] smaller steps come from binary fractions, not the sensor. Chosen, not measured."""
    whole: float = 1e-3
    """[steps] by which a multiple of the step may miss a whole number. Chosen, not measured."""
    most_levels: float = 0.5
    """[of the readings] more different values than that are no coarse steps. Chosen, not measured."""
    finest_of_turn: float = 2e-7
    """[turns] smaller steps of angles come from the digits in which quaternions are written. Reckoned from those of
    single precision, 6e-8."""
    ends_of_turns: float = 0.05
    """[share of the steps between levels of angles] that are at the ends of turns, and no whole steps. Chosen, not
    measured: steps of two degrees have one of 180 there."""
    dithered: float = 0.58
    """[steps] below this standard deviation readings in steps follow what moves them too little or too much. Known of
    quantisation (Widrow and Kollár 2008): errors of rounding hardly depend on what is rounded if that spreads by half a
    step, with which its rounded values spread by 0.58."""


@dataclass(frozen=True)
class FilledInCriteria:
    """Signs of readings that were interpolated between others, or repeated (`streams.filled_in`)."""

    fewest: int = 30
    """[readings] fewer show no pattern. Chosen, not measured."""
    on_the_line: float = 1.01
    """[smallest step between two levels of the readings] by which rounding may put a reading off the line between its
    neighbours: half a step for itself, half for these two. Reckoned from that."""
    exact: float = 1e-9
    """[of the range of the readings] the same where nothing is rounded: binary fractions. Chosen, not measured."""
    least: float = 0.3
    """[share of the readings] on the line. Chosen, not measured: the positions of a ship, interpolated to every second
    reading, had 0.44."""
    turns: float = 0.1
    """[share of the readings] at which what is on the line begins or ends: a motion without noise is on it for many
    readings in a row. Twenty readings made of one measured are still found. Chosen, not measured."""
    steps: float = 4.0
    """[that tolerance] by which the others have to miss the line: a coarse instrument misses it by a few steps. Chosen,
    not measured."""


@dataclass(frozen=True)
class OutlierCriteria:
    """Limits beyond which a reading is a fault of the sensor and not motion (`streams.outliers`)."""

    fewest: int = 20
    """[readings] fewer do not show what is usual: four neighbourhoods of five. Chosen, not measured."""
    far: float = 12.0
    """[of noise, or of the usual deviation] no normal noise reaches it. Chosen, not measured."""
    most: float = 0.95
    """[1] quantile of the steps between readings that still is motion. Chosen, not measured."""
    steps: float = 3.0
    """[of that quantile] a step by which motion alone may differ. Chosen, not measured."""
    rare: float = 0.05
    """[share of the readings] a deviation that is more frequent is usual for the sensor. Chosen, not measured."""
    longest_leap: float = 0.5
    """[s] within which a heading has to leap back; no robot turns there and back so fast. Chosen, not measured."""
    no_motion: float = 1.5
    """[rad] between two readings of a heading, which is a leap at any rate at which it can be followed. Chosen, not
    measured: just less than a quarter turn."""
    mostly_calm: float = 0.8
    """[share of the steps] below it, for a heading that can be followed. Chosen, not measured."""
    most_away: float = 0.2
    """[share of the readings] a heading that is away more often is no fault of a tracker. Chosen, not measured."""


@dataclass(frozen=True)
class TurningCriteria:
    """Tests of an angle's unit, and of a gyroscope that may bridge the angle's gaps (`streams.turning`)."""

    beyond_a_turn: float = 0.1
    """[rad] by which an angle in radians, however it is wrapped, may exceed 2 pi. Chosen, not measured."""
    continuous: float = 0.2
    """[s] between readings of a gyroscope that can still be integrated. Chosen, not measured."""
    fewest: int = 10
    """[turns of a second] that heading and gyroscope must share to be compared. Chosen, not measured."""
    follows: float = 0.9
    """[1] correlation from which the gyroscope may bridge gaps of the heading. Chosen, not measured."""
    long: float = 0.5
    """[s] without a reading, after which the shortest way may not be the way turned. Chosen, not measured."""


@dataclass(frozen=True)
class ClockCriteria:
    """Limits beyond which stamps count from another zero, or run at another rate than the log times (`clocks`)."""

    far: float = 1.0
    """[s] no transport and no latency explains such an offset. Chosen, not measured."""
    notable: float = 0.2
    """[s] an offset that is reported and left to the diagnosis. Chosen, not measured."""
    few: int = 10
    """[messages] so few in a row with far stamps are faults of messages, no other clock. Chosen, not measured."""
    early: float = 0.1
    """[share of the messages] from which the offset is read, before a skew shows. Chosen, not measured."""
    prompt: float = 0.1
    """[1] quantile of the delays that belongs to messages that did not have to wait. Chosen, not measured."""
    shared: float = 0.9
    """[share of a stream's stamps] that are stamps of commands too, from which both were read from one clock: rows of
    one table. Chosen, not measured."""
    notable_skew: float = 2e-5
    """[s/s] by which cheap quartz is off. Known of quartz; chosen, not measured."""
    sure: float = 6.0
    """[standard deviations] of a skew that is reported, which chance never makes. Chosen, not measured."""
    skew_blocks: int = 20
    """[1] points of the line whose slope is the skew: enough to estimate its error. Chosen, not measured."""
    fewest_in_block: int = 10
    """[messages] of a point; fewer have no prompt tenth. Chosen, not measured."""
    shortest: float = 30.0
    """[s] a shorter recording shows no skew of `notable_skew`. Chosen, not measured."""
    same_delay: float = 1e-6
    """[s] log times that differ from the stamps by less are made from them. Chosen, not measured."""


@dataclass(frozen=True)
class SpacingCriteria:
    """Limits beyond which readings have a gap, or come unevenly (`cleaning`)."""

    gap_intervals: float = 5.0
    """[usual intervals] a gap is longer than that: a few lost readings are none. Chosen, not measured."""
    gap_seconds: float = 1.0
    """[s] a gap is longer than that too: fast streams may pause for a moment. Chosen, not measured."""
    even: float = 2.0
    """[usual intervals] between commands that come at a steady rate, nearly always. Chosen, not measured."""
    nearly_all: float = 0.95
    """[share of the intervals] of these commands that are no longer than that. Chosen, not measured."""
    many: float = 0.05
    """[share of the intervals] that are long, from which they are no gaps but belong to how a topic is written. Chosen,
    not measured."""
    bunched: float = 0.25
    """[share of the intervals] shorter than `BURSTS.at_once`, above which a topic has several writers. Chosen, not
    measured."""
    jitter: float = 0.2
    """[of the usual interval] of jitter from which a remark gives it; drivers make less. Chosen, not measured."""


@dataclass(frozen=True)
class BurstCriteria:
    """Signs of readings that were delivered in bursts (`bursts`), and of writers that write at once (`cleaning`)."""

    at_once: float = 0.1
    """[of the mean interval] no instrument takes two readings so close to each other. Chosen, not measured."""
    many: float = 0.05
    """[share of the intervals] that are so short, from which readings come in bursts. Chosen, not measured."""
    in_a_row: int = 20
    """[readings] over which the period is taken: long beside a burst. Chosen, not measured."""
    swiftest: float = 0.05
    """[1] quantile of the time that so many readings take: slower rows have lost readings. Chosen, not measured."""
    together: float = 0.5
    """[periods] readings that come closer to each other than that belong to a burst. Chosen, not measured."""
    lacking: float = 1.5
    """[periods] missing before a burst, from which times within it are not known: of one more than that, a lost
    reading, they err by a period at most. Chosen, not measured."""


@dataclass(frozen=True)
class JumpCriteria:
    """Limits of the distance that a robot can swim between two poses (`pose_jumps`)."""

    noises: float = 10.0
    """[standard deviations of a reading] between two poses of one moment; noise makes less. Chosen, not measured."""
    own_speeds: float = 3.0
    """[of the track's usual top speed] that no robot reaches, since currents add to thrust. Chosen, not measured."""
    platform_speeds: float = 2.0
    """[of the platform's full speed] that no robot reaches, even carried by water. Chosen, not measured."""
    usual_top: float = 0.95
    """[1] quantile of a track's speeds that is its usual top speed. Chosen, not measured."""
    over: float = 1.0
    """[s] over which a speed is taken, so that noise of poses does not count. Chosen, not measured."""
    spike: float = 1.0
    """[s] within which a track that leaps back has only been read wrongly. Chosen, not measured."""
    burst: float = 2.0
    """[usual steps] that two poses count as apart at least: stamps may lie closer. Chosen, not measured."""
    fewest: int = 10
    """[poses] fewer do not show a usual speed. Chosen, not measured."""
    most_told: int = 5
    """[leaps] of a track that a remark lists, so that it stays a sentence. Chosen, not measured."""


@dataclass(frozen=True)
class ExchangeCriteria:
    """Signs of two tracks that were exchanged with each other (`identities`)."""

    close: float = 0.3
    """[hulls] a leap that counts where a second one leaps to its place: robots that are mistaken for each other are
    close. Chosen, not measured."""
    together: float = 1.0
    """[s] within which both tracks have to leap, as a tracker may lose both for a moment. Chosen, not measured."""
    closer: float = 0.5
    """[of the shorter leap] a track has to end nearer to the other's place than that. Chosen, not measured."""
    full_speeds: float = 2.0
    """[of the platform's full speed] of a robot during the exchange, carried by water too. Chosen, not measured."""


@dataclass(frozen=True)
class SpeedCriteria:
    """Limits beyond which a velocity stream and the track contradict each other (`consistency`)."""

    related: float = 0.7
    """[1] correlation below which the two tell nothing of each other. Chosen, not measured."""
    fewest: int = 8
    """[independent readings] fewer tell nothing. Chosen, not measured."""
    alike: tuple[float, float] = (0.85, 1.18)
    """[1] quotients beyond which a current, or a wrong scale, makes two speeds differ. Chosen, not measured."""
    drift: float = 0.1
    """[1] share of the speed above which a drift is told. Chosen, not measured."""
    explained: float = 0.5
    """[1] share of what is left without a drift, below which a drift is clear. Chosen, not measured."""
    one_heading: float = 0.8
    """[1] length of the mean of the headings, as unit vectors, beyond which a robot has headed one way. Chosen, not
    measured: 0.9 and more in the recordings of tauv_pool, where errors of the model look like a drift."""
    unseen: float = 0.25
    """[1] share of a drift below which a velocity shows the drift itself. Chosen, not measured."""


@dataclass(frozen=True)
class SufficiencyCriteria:
    """Least information that makes a robot, or all recordings together, worth a diagnosis (`abstention`)."""

    shortest: float = 6.0
    """[s] of commands and readings at once, of one recording: less holds no whole manoeuvre. Chosen, not measured."""
    time_constants: float = 4.0
    """[coasting times] of all recordings together: motions have to begin and to die out. Chosen, not measured."""
    least_in_all: float = 8.0
    """[s] the same for vehicles that coast for less than two seconds. Chosen, not measured."""
    fewest: int = 20
    """[readings] of one stream at least; fewer show no motion beside their noise. Chosen, not measured."""
    sparse: float = 10.0
    """[coasting times] between readings, median, of the quickest stream: a motion that was begun after one has died out
    long before the next. Chosen, not measured: gliders that report every 10 s coast for minutes."""
    sparse_seconds: float = 10.0
    """[s] the same for vehicles that coast for less than a second, such as boats with a satellite receiver. Chosen, not
    measured."""
    still: float = 5.0
    """[standard deviations of a mean over `over`] that noise alone never makes. Chosen, not measured."""
    over: float = 1.0
    """[s] over which readings are averaged before they are compared. Chosen, not measured."""
    range_quantiles: tuple[float, float] = (0.02, 0.98)
    """[1] between which means must spread, so that a few faulty readings are no motion. Chosen, not measured."""


@dataclass(frozen=True)
class TiltCriteria:
    """Roll and pitch as recorded, and when they are not used (`streams.attitude`, `levelling`)."""

    level: float = 1e-4
    """[rad] smaller roll and pitch are none. Chosen, not measured: its sine moves a reading by less than its noise."""
    length: float = 0.02
    """[1] by which a quaternion may differ from length 1. Chosen, not measured: five decimals of single precision."""
    fewest: int = 10
    """[readings] of roll and pitch, and of heights beside them, below which they tell nothing. Chosen, not measured."""
    rate_span: float = 0.2
    """[s] over which pitch is differenced. Chosen, not measured."""
    smoothed: float = 0.4
    """[s] of the parabola through neighbours of a roll or pitch. Chosen, not measured: a hull that swings within 1.5 s
    loses a hundredth."""
    fewest_smoothed: int = 5
    """[readings] in that time, below which they stay as they are. Chosen, not measured."""
    steadied: tuple[float, ...] = (6.4, 3.2, 1.6, 0.8, 0.4)
    """[s] of the parabola through neighbours of a velocity, the first that leaves noise alone. Chosen, not measured."""
    noise_alone: float = 1.05
    """[of the noise of single readings] that may be left over so: more, and it is motion. Chosen, not measured."""
    pause: float = 5.0
    """[of the usual time between velocities] beyond which no parabola reaches. Chosen, not measured."""
    climb_span: float = 1.0
    """[s] over which heights are differenced. Chosen, not measured."""
    climb_readings: float = 2.0
    """[readings] of the pressure over which depths are differenced where that is longer. Measured: of a made
    torpedo with two readings a second the fit is 37 nats worse over four of them, and 24 over three."""
    at_rest: float = 0.05
    """[m/s] of a speed ahead by which fins feel little. Chosen, not measured."""
    contradicted: float = 1.5
    """[1] quotient of squared misfits from which mirrored axes are believed. Chosen, not measured."""
    least_cosine: float = 0.2
    """[1] of a tilt beyond which the heading has no rate to speak of. Chosen, not measured."""
    said: float = 5.0
    """[deg] of a tilt from which it is said that no velocity tells how the water meets the hull. Chosen, not measured:
    its sine turns a twelfth of the speed."""


@dataclass(frozen=True)
class AfloatCriteria:
    """Signs of a vehicle that lies at the surface while its pumps lift it (`afloat`)."""

    lift: float = 0.5
    """[of the pumps' full lift] that would make it rise at once. Chosen, not measured."""
    top: float = 0.01
    """[1] quantile of the depths that counts as the surface, so that a few faulty readings do not. Chosen, not
    measured."""
    shortest: float = 30.0
    """[s] in which such a lift would take any hull through a layer of its own length. Chosen, not measured: a glider of
    1.8 m takes 15 s, a Lily 1 s."""


EXCITATION = ExcitationCriteria()
AFLOAT = AfloatCriteria()
FILLED_IN = FilledInCriteria()
NOISE = NoiseCriteria()
OUTLIERS = OutlierCriteria()
TURNING = TurningCriteria()
CLOCKS = ClockCriteria()
SPACING = SpacingCriteria()
BURSTS = BurstCriteria()
JUMPS = JumpCriteria()
EXCHANGES = ExchangeCriteria()
SPEEDS = SpeedCriteria()
TILT = TiltCriteria()
SUFFICIENCY = SufficiencyCriteria()
