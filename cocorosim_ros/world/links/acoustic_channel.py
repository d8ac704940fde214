"""What water does to sound on its way: delay, loss, noise, and what both leave of a message and of its range.

Transmission loss: 10 k log10(d) + alpha d [dB], d [m] from 1 m on. alpha, the absorption: Ainslie and McColm (1998), "A
simplified formula for viscous and chemical absorption in sea water", J. Acoust. Soc. Am. 103(3), equation (1) with its
relaxation frequencies, which is Francois and Garrison (1982) within about 10 %. Ratio of signal to noise in the band of
width B: source level - loss - noise level - 10 log10(B): Stojanovic (2007), "On the relationship between capacity and
distance in an underwater acoustic communication channel", equation (1) and section 2.
Bits are lost as in noncoherent binary frequency shift keying, p = exp(-Eb / (2 N0)) / 2 (Proakis, Digital
Communications, 2001, section 5.4), Eb / N0 = ratio B / bit rate; a message is lost with any of its bits.
A one-way range is off by the least that an unbiased estimate of a delay can be: variance c^2 / (2 E / N0 F^2) with
E / N0 = ratio B T over a message of length T and F^2 = pi^2 B^2 / 3 of a flat band (Kay, Estimation Theory, 1993,
equation 3.40); to that comes the error of the clocks.
Assumes: one straight path, no echoes from walls, surface and floor, no Doppler shift.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from cocorosim_ros.foundation.compiling.kernel import kernel
from cocorosim_ros.scenario.parts.acoustic import Acoustic

NO_SLOTS = 0
_NS = 1e9  # in a second


class Channel(NamedTuple):
    """The numbers of the link, as compiled loops read them."""

    tick_ns: int
    duration_ns: int  # of every message
    slot_ticks: int  # each robot sends for so long; NO_SLOTS: whenever it speaks
    window: int  # ticks back from now of which a message can still be under way, or disturb one that is
    reach: float  # m
    speed: float  # m/s
    spreading: float
    absorption: float  # dB/m
    level: float  # ratio of signal to noise in the band at 1 m [dB]
    energy: float  # Eb / N0 over that ratio
    bits: int  # of a message
    sharpness: float  # m, standard deviation of a range at a ratio of 1
    clocks: float  # m, the part of it that does not depend on the ratio


def absorption(frequency: float, temperature: float, salinity: float, acidity: float, depth: float) -> float:
    """Absorption [dB/m] at a frequency [Hz], temperature [degC], salinity [g/kg], pH and depth [m], see above."""
    f, deep = frequency * 1e-3, depth * 1e-3  # kHz, km
    boric = 0.78 * math.sqrt(salinity / 35.0) * math.exp(temperature / 26.0)
    magnesium = 42.0 * math.exp(temperature / 17.0)
    by_boron = 0.106 * boric * f * f / (boric * boric + f * f) * math.exp((acidity - 8.0) / 0.56)
    by_magnesium = 0.52 * (1.0 + temperature / 43.0) * salinity / 35.0
    by_magnesium *= magnesium * f * f / (magnesium * magnesium + f * f) * math.exp(-deep / 6.0)
    by_water = 0.00049 * f * f * math.exp(-(temperature / 27.0 + deep / 17.0))
    return (by_boron + by_magnesium + by_water) * 1e-3


def acoustic_channel(acoustic: Acoustic, tick_ns: int, depth: float = 0.0) -> Channel:
    """The link of a scenario with this tick [ns], in water of this depth [m]."""
    duration = acoustic.duration_ns / _NS
    longest_ns = acoustic.range / acoustic.sound_speed * _NS + 2 * acoustic.duration_ns
    return Channel(
        tick_ns=tick_ns,
        duration_ns=acoustic.duration_ns,
        slot_ticks=NO_SLOTS if acoustic.slot_ns is None else acoustic.slot_ns // tick_ns,
        window=math.ceil(longest_ns / tick_ns) + 1,
        reach=acoustic.range,
        speed=acoustic.sound_speed,
        spreading=acoustic.spreading,
        absorption=absorption(acoustic.frequency, acoustic.temperature, acoustic.salinity, acoustic.acidity, depth),
        level=acoustic.source_level - acoustic.noise_level - 10.0 * math.log10(acoustic.bandwidth),
        energy=acoustic.bandwidth / acoustic.bit_rate,
        bits=max(1, round(duration * acoustic.bit_rate)),
        sharpness=acoustic.sound_speed
        / (math.pi * acoustic.bandwidth)
        * math.sqrt(3.0 / (2.0 * acoustic.bandwidth * duration)),
        clocks=acoustic.sound_speed * acoustic.timing_error,
    )


@kernel
def travel_ns(distance: float, speed: float) -> int:
    """How long sound takes over a distance [m] at a speed [m/s], in whole nanoseconds."""
    return math.floor(distance / speed * 1e9 + 0.5)


@kernel
def transmission_loss(distance: float, spreading: float, absorbed: float) -> float:
    """How much weaker sound is at a distance [m] than 1 m away [dB]; `absorbed` [dB/m]."""
    far = max(distance, 1.0)
    return 10.0 * spreading * math.log10(far) + absorbed * far


@kernel
def signal_to_noise(channel: Channel, distance: float) -> float:
    """Power of the signal over that of the noise in the band, at a distance [m]."""
    level: float = channel.level - transmission_loss(distance, channel.spreading, channel.absorption)
    ratio: float = 10.0 ** (0.1 * level)
    return ratio


@kernel
def loss_probability(channel: Channel, ratio: float) -> float:
    """How probably a message is lost at a ratio of signal to noise: any of its bits is wrong."""
    wrong = 0.5 * math.exp(-0.5 * channel.energy * ratio)
    return -math.expm1(channel.bits * math.log1p(-wrong))


@kernel
def range_variance(channel: Channel, ratio: float) -> float:
    """Variance of a range by one-way travel time [m^2] at a ratio of signal to noise."""
    variance: float = channel.sharpness**2 / ratio + channel.clocks**2
    return variance
