"""Thresholds of the frames: when streams contradict the axes, signs and units of the contract."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple


@dataclass(frozen=True)
class AgreementCriteria:
    """Limits from which the agreement of two streams is worth a conclusion (`frames.agreement`)."""

    fewest: int = 8
    """[independent readings] fewer conclude nothing. Chosen, not measured."""
    clear: float = 0.36
    """[1] squared correlation of the best explanation, below which nothing is concluded: a correlation of 0.6. Chosen,
    not measured."""
    most: float = 0.9
    """[1] quantile of the sizes from which extremes are judged. Chosen, not measured."""
    extreme: float = 2.0
    """[of that quantile] a size at which values are cut, so that a few faults do not decide. Chosen, not measured."""
    finest: float = 0.02
    """[1] of 1 - agreement: models of frames are no more exact than that. Chosen, not measured."""
    memory: float = 2.0
    """[coasting times] readings closer together are not independent: motion lasts. Chosen, not measured."""
    least_memory: float = 1.0
    """[s] the same for vehicles that coast for less than half a second. Chosen, not measured."""


@dataclass(frozen=True)
class AxesCriteria:
    """Evidence for exchanged axes or signs of a stream (`frames.inertial`, `velocity_axes`, `upright`)."""

    margin: float = 10.0
    """[nats] by which a correction has to fit better: odds of 22,000 to 1. Chosen, not measured."""
    tied: float = 1.0
    """[nats] corrections so close to the best count as equal; the simplest is taken. Chosen, not measured."""
    near_gravity: float = 0.2
    """[of gravity] by which a mean specific force may differ from gravity, by tilt and offset. Chosen, not measured."""


@dataclass(frozen=True)
class OrientationCriteria:
    """Prices of changes of the horizontal axes, against the relations that the changes mend (`frames.orientation`)."""

    price: float = 10.0
    """[nats] of one change. Chosen, not measured."""
    margin: float = 10.0
    """[nats] by which the changed streams fit better after the price is paid. Chosen, not measured."""
    least_step: float = 1e-9
    """[nats] by which one combination has to beat another, so that rounding does not decide. Chosen, not measured."""
    position: float = 1.05
    """[prices] of turned positions alone. Chosen, not measured: taken as rarer than a turned yaw."""
    yaw: float = 1.0
    """[prices] of a turned yaw of the poses alone. The unit of the prices."""
    compass: float = 0.95
    """[prices] of a turned compass. Chosen, not measured: taken as the most frequent change."""
    gyro: float = 1.0
    """[prices] of a gyroscope of the other sign. Chosen, not measured."""
    command: float = 1.3
    """[prices] of exchanged commands. Chosen, not measured: taken as rarer than changed streams."""
    pose: float = 1.0
    """[prices] of positions and yaw that are turned together. Chosen, not measured: one convention, one change."""
    both: float = 2.2
    """[prices] of positions and yaw that are turned differently. Chosen, not measured: more than two changes."""
    rank: float = 0.05
    """[prices] between the most and the least usual of the usual changes. Chosen, not measured."""
    unusual: float = 2.0
    """[ranks] that a change costs which is not in the list of usual ones. Chosen, not measured."""
    north_east_down: float = 0.5
    """[prices] less for swapped axes where z points down, as in north-east-down axes. Chosen, not measured."""


@dataclass(frozen=True)
class KinematicsCriteria:
    """Limits from which streams that are rates of one another contradict each other (`frames.kinematics`)."""

    fewest: int = 30
    """[readings, a second apart, or moments] fewer conclude nothing. Chosen, not measured."""
    smooth: float = 0.5
    """[1] correlation of a series with itself two moments later, from which it shows motion: the noise that is left
    halves shares at most, and `other` is more than that. Reckoned from that."""
    sure: float = 0.1
    """[1] standard error of the share of a motion that a stream reads, below which it is known. Chosen, not
    measured."""
    other: float = 0.7
    """[1] by which that share differs from 1: a stream of other axes reads nothing of it, or the opposite; none that is
    late, noisy or scaled by a third is so far off. Chosen, not measured."""
    latest: float = 1.0
    """[s] by which one of the streams may come late. Chosen, not measured."""
    exact: float = 0.95
    """[1] correlation from which two rates are one but for their units. Chosen, not measured."""
    explains: float = 0.9
    """[1] share of the motion that changed axes have to explain, to be believed by noise alone. Chosen, not
    measured."""
    better: float = 5.0
    """[1] quotient of what is left unexplained, of the axes as recorded over the changed ones, for the same.
    Chosen, not measured."""


@dataclass(frozen=True)
class BinCriteria:
    """Widths of the bins of time in which streams are compared (`frames.motion`)."""

    narrow: float = 0.15
    """[coasting times] motion changes little within a bin of this width. Chosen, not measured."""
    narrowest: float = 0.1
    """[s] no bin is narrower, so that it holds readings of usual sensors. Chosen, not measured."""
    widest: float = 2.0
    """[s] no bin is wider, however slow the sensors of a quick vehicle are. Chosen, not measured."""
    widest_coasting: float = 0.6
    """[coasting times] of a slow vehicle the same: the 2 s of a Lily. Chosen, not measured: with 2 s a mirrored axis of
    a made ship, which was read every six seconds and coasts for a minute, was not seen."""
    readings: float = 2.0
    """[readings] of the slowest stream that a bin holds. Chosen, not measured."""


@dataclass(frozen=True)
class RoughMotionCriteria:
    """Steps of the rough motion that is expected under the commands (`frames.expected`)."""

    longest_step: float = 0.1
    """[s] no step is longer, so that commands show. Chosen, not measured."""
    steps: float = 20.0
    """[steps] that make a coasting time: enough to tell signs, axes and powers of ten. Chosen, not measured."""


class LengthUnit(NamedTuple):
    """A unit of length, and the quotients of speeds that only this unit explains."""

    name: str
    metres: float
    quotients: tuple[float, float]


class PressureUnit(NamedTuple):
    """A unit of pressure, and the medians that only this unit explains."""

    name: str
    pascals: float
    medians: tuple[float, float]


@dataclass(frozen=True)
class UnitCriteria:
    """Ranges of numbers so large or small that they must be in another unit (`frames.units`)."""

    related: float = 0.7
    """[1] correlation of two streams, from which their quotient tells of units. Chosen, not measured."""
    fewest: int = 8
    """[independent readings] fewer tell nothing. Chosen, not measured."""
    degrees: tuple[float, float] = (25.0, 130.0)
    """[1] quotients of rates that only degrees explain (57.3); nearer to 1 may be physics. Chosen, not measured."""
    lengths: tuple[LengthUnit, ...] = (
        LengthUnit("millimetres", 0.001, (250.0, 4000.0)),
        LengthUnit("centimetres", 0.01, (30.0, 250.0)),
    )
    """[1] quotients of speeds that only a unit of length explains. Chosen, not measured."""
    pressures: tuple[PressureUnit, ...] = (
        PressureUnit("hectopascals (millibars)", 100.0, (700.0, 11000.0)),
        PressureUnit("kilopascals", 1000.0, (70.0, 700.0)),
        PressureUnit("bars", 1.0e5, (0.7, 12.0)),
    )
    """[that unit] medians from the surface, at sea level or in mountains, to 100 m of water. Reckoned from these."""
    pressure_slope: tuple[float, float] = (0.3, 3.0)
    """[of the water's weight] pressure per metre that poses show under the right unit. Chosen, not measured."""
    absolute: float = 70000.0
    """[Pa] less is no absolute pressure of the air where robots swim: 3000 m of height. Known of the atmosphere."""
    dense: float = 100.0
    """[kg/m^3] more is a liquid, in which pressure tells depth. Known of gases and liquids."""


AGREEMENT = AgreementCriteria()
AXES = AxesCriteria()
KINEMATICS = KinematicsCriteria()
ORIENTATION = OrientationCriteria()
UNITS = UnitCriteria()
BINS = BinCriteria()
ROUGH_MOTION = RoughMotionCriteria()
