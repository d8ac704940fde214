"""The numbers of a model in one row: those of the simulator's physics, of sensors, stamps and random forces."""

from __future__ import annotations

import numpy as np

from cocorosim_ros.diagnosis.filter.layout import KINDS_OF_STREAM, NEUTRAL_SENSORS, SENSOR_COLUMNS
from cocorosim_ros.foundation.arrays import Floats, Integers
from cocorosim_ros.world.sensors import KINDS
from cocorosim_ros.world.sensors.law import SENSOR_LAWS
from cocorosim_ros.world.vehicle_model.columns import numbered, stretch_of
from cocorosim_ros.world.vehicle_model.hooks import bits
from cocorosim_ros.world.vehicle_model.vehicles import EFFECT_BIT, GAINS, PARAMETER_COLUMNS, neutral_row

# Logarithms of numbers in N, N, N m, s and 1.
WATER_NOISE = ("random.force", "random.heave_force", "random.moment", "random.correlation", "random.smoothness")
# Logarithm of how far the place that an instrument shows wanders in the root of a second [m/s^0.5].
WANDER = "random.place"
# Logarithms of how many times as strong as at rest what the random force gains at the highest speed or thrust is.
WATER_GROWTH = ("random.with_speed", "random.with_thrust")
WATER_RANDOM = (*WATER_NOISE, *WATER_GROWTH)
NO_GROWTH = WHITE = float(np.log(np.finfo(float).tiny))  # logarithms of next to nothing
# Kinds of readings of equal quality share one number: log of the standard deviation of a single reading.
READING_NOISE_OF_KIND = tuple(kind.noise or kind.name for kind in KINDS.values())
READING_NOISE = tuple(dict.fromkeys(f"reading.{name}" for name in READING_NOISE_OF_KIND))
# Logarithms of correlation times of errors of readings, one for each number above; next to nothing: they are white.
READING_MEMORY = tuple(f"memory.{column.partition('.')[2]}" for column in READING_NOISE)
NOISE_WORDS = {
    name: kind.noise_words for name, kind in zip(READING_NOISE_OF_KIND, KINDS.values(), strict=True) if kind.noise_words
}
# Units of the noise itself; a row holds logarithms.
NOISE_UNITS = {
    "random.force": "N", "random.heave_force": "N", "random.moment": "N m", "random.correlation": "s",
    "random.smoothness": "1", WANDER: "m/s^0.5",
    **dict.fromkeys(WATER_GROWTH, "1"), **dict.fromkeys(READING_MEMORY, "s"),
    **{f"reading.{name}": kind.unit for name, kind in zip(READING_NOISE_OF_KIND, KINDS.values(), strict=True)},
}  # fmt: skip
LATENCY = tuple(f"sensor_latency.{stream}" for stream in KINDS_OF_STREAM)
SKEW = tuple(f"clock_skew.{stream}" for stream in KINDS_OF_STREAM)
READING_LAWS = {f"{place}.{each.name}": each.neutral for place, numbers in SENSOR_LAWS.items() for each in numbers}

MOST_THRUSTERS = 8  # that have a gain and a curve of their own; more are looked at together alone
# Gains of the thrusters' maximum forces, of all and of single ones by number, and the delay of the commands [s].
ALL_THRUSTERS, COMMAND_DELAY = "own_gain.all", "command_delay.delay"
OWN_GAINS = (ALL_THRUSTERS, *(f"own_gain.{number}" for number in range(1, MOST_THRUSTERS + 1)))
OWN_SURGE_DRAG = "own_drag.surge"  # factor of the drag ahead alone, see tracks.surge_drag
# Exponents of the curves of single thrusters, see tracks.own_curves.
OWN_EXPONENTS = tuple(f"own_exponent.{number}" for number in range(1, MOST_THRUSTERS + 1))

COLUMN: dict[str, int] = numbered(
    [
        *PARAMETER_COLUMNS, *SENSOR_COLUMNS, *LATENCY, *SKEW, *WATER_NOISE, WANDER, *READING_NOISE, *READING_LAWS,
        *OWN_GAINS, *OWN_EXPONENTS, OWN_SURGE_DRAG, COMMAND_DELAY, *WATER_GROWTH, *READING_MEMORY,
    ]
)  # fmt: skip
"""Column of every number of a model, by name; physics come first, so that their columns are the simulator's."""
NAMES: tuple[str, ...] = tuple(COLUMN)
PHYSICS = stretch_of(COLUMN, list(PARAMETER_COLUMNS))
SENSORS = stretch_of(COLUMN, SENSOR_COLUMNS)
WATER = stretch_of(COLUMN, (*WATER_NOISE, WANDER))
READING_COLUMNS = np.array([COLUMN[f"reading.{name}"] for name in READING_NOISE_OF_KIND])
MEMORY_COLUMNS = np.array([COLUMN[f"memory.{name}"] for name in READING_NOISE_OF_KIND])
ALWAYS_ACTIVE = EFFECT_BIT["quadratic_drag"] | EFFECT_BIT["net_buoyancy"] | EFFECT_BIT["patch_force"]
BIT: Integers = np.array([EFFECT_BIT.get(name.partition(".")[0], 0) for name in NAMES], dtype=np.int64)
OF_TIME = frozenset((*LATENCY, *SKEW, COMMAND_DELAY))  # columns of errors of stamps, those of commands too
TIMING = stretch_of(COLUMN, (*LATENCY, *SKEW))
THRUSTERS = stretch_of(COLUMN, OWN_GAINS)
EXPONENTS = stretch_of(COLUMN, OWN_EXPONENTS)
DRAGS = stretch_of(COLUMN, (OWN_SURGE_DRAG,))
ACTUATING = np.flatnonzero(
    ((bits("command") | bits("thrust") | bits("response")) & BIT != 0)
    | np.isin(NAMES, (*GAINS, *OWN_GAINS, *OWN_EXPONENTS, COMMAND_DELAY))
)
MOVING_WATER = np.flatnonzero(bits("water") & BIT != 0)
NEUTRAL = np.zeros(len(NAMES))  # (columns,) values under which no effect, law or error acts
NEUTRAL[PHYSICS] = neutral_row()
NEUTRAL[SENSORS] = NEUTRAL_SENSORS
NEUTRAL[THRUSTERS] = 1.0
NEUTRAL[EXPONENTS] = 1.0
NEUTRAL[DRAGS] = 1.0
NEUTRAL[[COLUMN[column] for column in WATER_GROWTH]] = NO_GROWTH
NEUTRAL[MEMORY_COLUMNS] = WHITE
NEUTRAL[COLUMN[WANDER]] = WHITE
for _name, _value in READING_LAWS.items():
    NEUTRAL[COLUMN[_name]] = _value


def active_effects(row: Floats) -> int:
    """Bits of the effects of which a number in the row (columns,) is not neutral."""
    return int(np.bitwise_or.reduce(BIT[row != NEUTRAL]))
