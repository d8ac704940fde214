"""CATALOGUE: the effects that a diagnosis knows. Their physics are the simulator's, under the same names.

How an effect of the motion is looked for stands in its own file in world/effects.
"""

from __future__ import annotations

import math

from cocorosim_ros.diagnosis.catalogue.entry import Amplitude, Entry, entry_of
from cocorosim_ros.world.effects import CATALOGUE_EFFECTS
from cocorosim_ros.world.effects.pump_lag import PUMP_TICK
from cocorosim_ros.world.terms.groups import COURSE, LATE
from cocorosim_ros.world.terms.search import DELAYS

__all__ = ["ENTRIES", "IDS", "PUMP_TICK"]

CLOCK_TICK = 0.01  # s, a tenth of the filter's step: delays below, and skews that make less of it on average, are none
TOPICS_THAT_LAG = ("pose", "compass", "pressure", "imu", "velocity")


def _plain(
    effect: str, names: dict[str, tuple[str, float]], step: float = 0.05, least: float = -math.inf, neutral: float = 0.0
) -> tuple[Amplitude, ...]:
    return tuple(
        Amplitude(f"{effect}.{name}", name, unit, large, step=step, least=least, neutral=neutral)
        for name, (unit, large) in names.items()
    )


_MOTION_ENTRIES = tuple(
    entry_of(name, effect, effect.search) for name, effect in CATALOGUE_EFFECTS.items() if effect.search is not None
)
_SENSOR_ENTRIES: tuple[Entry, ...] = (
    Entry(
        "compass_distortion",
        "distorted compass",
        "reading = yaw + offset + sin * sin(yaw) + cos * cos(yaw)",
        "compass",
        _plain("compass_distortion", {"offset": ("rad", 0.085), "sin": ("rad", 0.085), "cos": ("rad", 0.085)}),
        group=COURSE,
        topic="compass",
        manoeuvre="slow_turns",
    ),
    Entry(
        "pressure_offset",
        "pressure reading that is shifted",
        "reading = pressure + offset",
        "pressure",
        _plain("pressure_offset", {"offset": ("Pa", 500.0)}),
        group="pressure",
        topic="pressure",
        manoeuvre="surface_touch",
    ),
    Entry(
        "pressure_drift",
        "pressure reading that drifts",
        "reading = pressure + rate t",
        "pressure",
        (*_plain("pressure_drift", {"rate": ("Pa/s", 0.7)}), *_plain("pressure_offset", {"offset": ("Pa", 500.0)})),
        group="pressure",
        topic="pressure",
        manoeuvre="surface_touch",
    ),
    Entry(
        "imu_bias",
        "IMU that is off",
        "reading = rate or acceleration + bias",
        "imu",
        _plain(
            "imu_bias",
            {
                "gyro_z": ("rad/s", 0.02),
                "accel_x": ("m/s^2", 0.05),
                "accel_y": ("m/s^2", 0.05),
                "accel_z": ("m/s^2", 0.05),
            },
        ),
        topic="imu",
        manoeuvre="rest",
    ),
    Entry(
        "camera_scale",
        "camera lengths that are wrong by a factor",
        "reading = scale * place",
        "pose",
        _plain("camera_scale", {"scale": ("1", 0.05)}, neutral=1.0),
        topic="pose",
        manoeuvre="ruler",
    ),
    *(
        Entry(
            "sensor_latency",
            f"{topic} that comes late",
            "reading(t) = what was at t - latency",
            topic,
            (
                Amplitude(
                    f"sensor_latency.{topic}",
                    "latency",
                    "s",
                    0.15,
                    least=0.0,
                    negligible=(-CLOCK_TICK, CLOCK_TICK),
                    searched=DELAYS,
                ),
            ),
            group=LATE,
            topic=topic,
            manoeuvre="steps",
            of_pump=topic == "pressure",
        )
        for topic in TOPICS_THAT_LAG
    ),
    *(
        Entry(
            "clock_skew",
            f"clock of {topic} that runs wrong",
            "stamp = t0 + (1 + skew) (t - t0)",
            "clock",
            (Amplitude(f"clock_skew.{topic}", "skew", "s/s", 5e-4, adds_up=2.0 * CLOCK_TICK),),
            group=LATE,
            topic=topic,
            manoeuvre="repeat_at_end",
            of_pump=topic == "pressure",
        )
        for topic in TOPICS_THAT_LAG
    ),
)

ENTRIES: tuple[Entry, ...] = (*_MOTION_ENTRIES, *_SENSOR_ENTRIES)
IDS: tuple[str, ...] = tuple(dict.fromkeys(entry.id for entry in ENTRIES))
