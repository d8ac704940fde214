"""Sound: when a message arrives, who hears it, what noise takes of it, and what its range says."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.scenario.parts.acoustic import Acoustic
from cocorosim_ros.world.links.acoustic_channel import (
    absorption,
    acoustic_channel,
    loss_probability,
    signal_to_noise,
    transmission_loss,
)
from cocorosim_ros.world.links.sound import SoundLink
from cocorosim_ros.world.seeding.corruption_at_work import Swarms
from cocorosim_ros.world.state.radio import MESSAGE_LENGTH, MESSAGE_SIZE, empty_inbox
from cocorosim_ros.world.state.sound import RANGE, SOUND_SIZE, VARIANCE

TICK = 100_000_000  # ns
LOUD = {"source_level": 250.0}  # nothing is lost to noise


class Water:
    """Robots that stay where they are, in some runs of the same places."""

    def __init__(self, places: Any, runs: range = range(1), tick_ns: int = TICK, **acoustic: Any) -> None:
        place = np.asarray(places, dtype=float)
        robots = len(place)
        self.channel = acoustic_channel(Acoustic(**{"range": 10_000.0, **LOUD, **acoustic}), tick_ns)
        self.state = np.zeros((len(runs), robots, 11))
        self.state[..., :3] = place
        self.inbox = empty_inbox(len(runs), robots, max(1, robots - 1), SOUND_SIZE)
        everybody = np.ones(robots, dtype=bool)
        names = tuple(f"r{robot}" for robot in range(robots))
        self.link = SoundLink(self.channel, everybody, everybody, Swarms(7, names, runs), self.inbox)

    def carry(self, tick: int, speakers: tuple[int, ...] = ()) -> list[list[int]]:
        """Whom each robot of the first run hears at the next tick, if these say their number at this one."""
        said = np.zeros((*self.inbox.heard.shape, MESSAGE_SIZE))
        for speaker in speakers:
            said[:, speaker, MESSAGE_LENGTH], said[:, speaker, 1] = 1.0, speaker
        self.link.carry(tick, self.state, said)
        heard = [self.inbox.sender[0, robot, :count].tolist() for robot, count in enumerate(self.inbox.heard[0])]
        for robot, senders in enumerate(heard):
            assert self.inbox.message[0, robot, : len(senders), 1].tolist() == senders
        return heard

    def course(self, speeches: dict[int, tuple[int, ...]], ticks: int) -> dict[int, list[list[int]]]:
        """By tick: whom each robot hears, at the ticks at which anybody hears something."""
        heard = {tick + 1: self.carry(tick, speeches.get(tick, ())) for tick in range(ticks)}
        return {tick: whom for tick, whom in heard.items() if any(whom)}

    @property
    def garbled(self) -> list[int]:
        """What each robot of the first run could not understand at the last tick."""
        return list(self.link.garbled[0].tolist())


def line(*places: float) -> list[tuple[float, float, float]]:
    """Robots along x [m]."""
    return [(place, 0.0, -5.0) for place in places]


@pytest.mark.parametrize(("distance", "tick"), [(1500.0, 11), (1500.001, 12), (1499.999, 11), (0.2, 2), (0.0, 1)])
def test_arrival_tick(distance: float, tick: int) -> None:
    """A message of 0.1 s over 1500 m ends after 1.1 s: at tick 11 of 0.1 s, and not a micrometre's time later."""
    water = Water(line(0.0, distance))
    assert water.course({0: (0,)}, 20) == {tick: [[], [0]]}


def test_the_age_tells_when_it_was_said() -> None:
    """Said at tick 3, heard at tick 14, with the range of 1500 m."""
    water = Water(line(0.0, 1500.0))
    for tick in range(14):
        water.carry(tick, (0,) if tick == 3 else ())
    assert (water.inbox.heard[0, 1], water.inbox.age[0, 1, 0]) == (1, 11)
    assert water.inbox.message[0, 1, 0, RANGE] == pytest.approx(1500.0, abs=1e-3)


def test_half_duplex() -> None:
    """Two that speak at once, 15 m apart, do not hear each other; one that is silent hears whoever it reaches first."""
    water = Water(line(0.0, 15.0, 200.0))
    assert water.course({0: (0, 1)}, 10) == {}
    assert Water(line(0.0, 15.0)).course({0: (0,)}, 10) == {2: [[], [0]]}


def test_sending_may_begin_where_hearing_ends() -> None:
    """30 m are 20 ms: a message of 80 ms has passed at tick 1, and who speaks then has heard it; at 31 m it has not."""
    assert Water(line(0.0, 30.0), duration_ns=80_000_000).course({0: (0,), 1: (1,)}, 5)[1] == [[], [0]]
    late = Water(line(0.0, 31.0), duration_ns=80_000_000).course({0: (0,), 1: (1,)}, 5)
    assert [0] not in [whom[1] for whom in late.values()]


@pytest.mark.parametrize(("apart", "heard"), [(150.0, [0, 1]), (149.999, [])])
def test_messages_that_overlap_are_lost(apart: float, heard: list[int]) -> None:
    """Two senders whose ways differ by 150 m reach the third 0.1 s apart: messages of 0.1 s just fit."""
    water = Water([(0.0, 0.0, -5.0), (-apart, 0.0, -5.0), (300.0, 0.0, -5.0)])
    course = water.course({0: (0, 1)}, 10)
    assert sorted(who for whom in course.values() for who in whom[2]) == heard


def test_what_collides_is_counted() -> None:
    """A robot in the middle of two speakers notices two sounds that it cannot understand."""
    water = Water(line(-150.0, 0.0, 150.0))
    water.carry(0, (0, 2))
    assert water.garbled == [0, 0, 0]
    water.carry(1)
    assert (water.garbled, water.inbox.heard[0].tolist()) == ([0, 2, 0], [0, 0, 0])


def test_beyond_the_range_nothing_is_heard_and_nothing_disturbs() -> None:
    """At exactly 100 m a message is heard, though one from 101 m arrives with it."""
    water = Water(line(-100.0, 0.0, 101.0), range=100.0)
    assert water.course({0: (0, 2)}, 10) == {2: [[], [0], []]}


def test_slots_are_taken_in_turn() -> None:
    """All three wish to speak always; slots of two ticks give the word to 0, 1, 2, 0, ... at every second tick."""
    water = Water(line(0.0, 10.0, 20.0), slot_ns=2 * TICK)
    speakers = []
    for tick in range(12):
        heard = water.carry(tick, (0, 1, 2))
        speakers.append({who for whom in heard for who in whom})
    assert speakers == [set(), {0}, set(), {1}, set(), {2}, set(), {0}, set(), {1}, set(), {2}]


def test_who_is_still_sending_says_nothing_more() -> None:
    """Messages of 0.25 s on ticks of 0.1 s: of a robot that speaks always, every third message goes out."""
    water = Water(line(0.0, 15.0), duration_ns=250_000_000)
    heard = water.course({tick: (0,) for tick in range(10)}, 13)
    assert list(heard) == [3, 6, 9, 12]


def test_loss_grows_with_range_as_the_formula_says() -> None:
    """Of 4000 runs, as many messages get lost as bits of frequency shift keying at that ratio of signal to noise do."""
    settings = {"source_level": 126.0, "salinity": 0.0, "frequency": 25_000.0, "spreading": 2.0}
    for distance in (56.0, 63.0, 70.0):
        water = Water(line(0.0, distance), runs=range(4000), **settings)
        for tick in range(3):
            water.carry(tick, (0,) if tick == 0 else ())
            if tick == 1:
                lost = 1.0 - water.inbox.heard[:, 1].mean()
        absorbed = 0.00049e-3 * 25.0**2 * math.exp(-10.0 / 27.0) * distance
        ratio = 10 ** (0.1 * (126.0 - 20.0 * math.log10(distance) - absorbed - 50.0 - 10.0 * math.log10(4000.0)))
        expected = 1.0 - (1.0 - 0.5 * math.exp(-ratio * 4000.0 / 1000.0 / 2.0)) ** 100
        assert 0.02 < expected < 0.98
        assert lost == pytest.approx(expected, abs=4.5 * math.sqrt(expected * (1 - expected) / 4000))


def test_ranges_scatter_as_their_variance_says() -> None:
    """Unbiased, with the standard deviation c / (pi B) sqrt(3 / (2 B T ratio)) and that of the clocks."""
    water = Water(line(0.0, 60.0), runs=range(4000), source_level=140.0, timing_error=1e-5, duration_ns=50_000_000)
    water.carry(0, (0,))
    assert (water.inbox.heard[:, 1] == 1).all()
    rows = water.inbox.message[:, 1, 0]
    ratio = signal_to_noise(water.channel, 60.0)
    by_noise = 1500.0 / (math.pi * 4000.0) * math.sqrt(3.0 / (2.0 * 4000.0 * 0.05 * ratio))
    expected = math.hypot(by_noise, 1500.0 * 1e-5)
    np.testing.assert_allclose(rows[:, VARIANCE], expected**2, rtol=1e-12)
    assert rows[:, RANGE].mean() == pytest.approx(60.0, abs=5.0 * expected / math.sqrt(4000))
    assert rows[:, RANGE].std() == pytest.approx(expected, rel=0.06)


def test_a_run_is_the_same_alone_and_in_a_batch() -> None:
    """Run 2 by itself and among four: the same losses and ranges, to the last bit."""
    places = [*line(0.0, 40.0, 70.0), (0.0, 50.0, -2.0)]
    batch, alone = (Water(places, runs=runs, source_level=116.0) for runs in (range(4), range(2, 3)))
    lost = 0
    for tick in range(40):
        for water in (batch, alone):
            water.carry(tick, (tick // 2 % 4,) if tick % 2 == 0 else ())
        assert np.array_equal(batch.inbox.heard[2:3], alone.inbox.heard)
        for robot, count in enumerate(alone.inbox.heard[0]):
            assert np.array_equal(batch.inbox.message[2, robot, :count], alone.inbox.message[0, robot, :count])
        lost += int(alone.link.garbled.sum())
    assert lost > 0


def francois_garrison(f: float, temperature: float, salinity: float, acidity: float, depth: float) -> float:
    """Absorption [dB/km] at f [kHz] by Francois and Garrison, J. Acoust. Soc. Am. 72 (1982), up to 20 degC."""
    kelvin, speed = temperature + 273.0, 1412.0 + 3.21 * temperature + 1.19 * salinity + 0.0167 * depth
    f1 = 2.8 * math.sqrt(salinity / 35.0) * 10 ** (4.0 - 1245.0 / kelvin)
    f2 = 8.17 * 10 ** (8.0 - 1990.0 / kelvin) / (1.0 + 0.0018 * (salinity - 35.0))
    boric = 8.86 / speed * 10 ** (0.78 * acidity - 5.0) * f1 * f * f / (f * f + f1 * f1)
    sulphate = 21.44 * salinity / speed * (1.0 + 0.025 * temperature)
    sulphate *= (1.0 - 1.37e-4 * depth + 6.2e-9 * depth**2) * f2 * f * f / (f * f + f2 * f2)
    water = 4.937e-4 - 2.59e-5 * temperature + 9.11e-7 * temperature**2 - 1.5e-8 * temperature**3
    return boric + sulphate + water * (1.0 - 3.83e-5 * depth + 4.9e-10 * depth**2) * f * f


@pytest.mark.parametrize("temperature", [0.0, 4.0, 10.0, 18.0])
@pytest.mark.parametrize("khz", [0.5, 5.0, 12.0, 25.0, 50.0, 100.0, 500.0])
def test_absorption_by_another_law(khz: float, temperature: float) -> None:
    """That of Francois and Garrison, which ours simplifies, to the tenth that its authors state; 30 and 35 g/kg."""
    for salinity, depth in ((35.0, 0.0), (35.0, 1000.0), (30.0, 50.0)):
        ours = 1000.0 * absorption(khz * 1e3, temperature, salinity, 8.0, depth)
        assert ours == pytest.approx(francois_garrison(khz, temperature, salinity, 8.0, depth), rel=0.1)


def test_absorption_of_fresh_water() -> None:
    """Pinkerton (1949): alpha / f^2 = 25.3e-15 Np s^2/m in pure water of 20 degC."""
    assert absorption(1e6, 20.0, 0.0, 8.0, 0.0) == pytest.approx(25.3e-15 * 1e12 * 20.0 / math.log(10.0), rel=0.1)


def test_spreading() -> None:
    """20 dB for every tenfold distance in open water, 10 dB between surface and floor; none within a metre."""
    assert transmission_loss(100.0, 2.0, 0.0) == pytest.approx(40.0, rel=1e-14)
    assert transmission_loss(100.0, 1.0, 0.0) == pytest.approx(20.0, rel=1e-14)
    assert transmission_loss(100.0, 2.0, 0.01) == pytest.approx(41.0, rel=1e-14)
    assert transmission_loss(0.3, 2.0, 0.0) == 0.0


def test_without_signal_half_of_all_bits_are_wrong() -> None:
    """A ratio of zero: a message of one bit gets lost every second time; of a strong signal nothing does."""
    bit = acoustic_channel(Acoustic(range=10.0, bit_rate=10.0), TICK)
    assert bit.bits == 1
    assert loss_probability(bit, 0.0) == 0.5
    assert loss_probability(bit, 1e6) == 0.0
