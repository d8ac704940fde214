"""What the report says in words: verdicts, and what to look at on the robot for each effect of the catalogue."""

from __future__ import annotations

import math

from cocorosim_ros.diagnosis.findings import Diagnosis
from cocorosim_ros.world.effects import EFFECTS
from cocorosim_ros.world.sensors import KINDS

VERDICTS = {
    "consistent": (
        "Nothing is missing",
        "The recording is what the model of this platform expects, within its noise: no number of the platform has "
        "moved, and no effect of the catalogue explains anything.",
    ),
    "recalibrate": (
        "Recalibrate",
        "The physics is complete, but numbers of the platform differ from its file. With the fitted numbers of "
        "model.yaml the simulation follows the recording.",
    ),
    "mismatch": (
        "Physics is missing",
        "No choice of the platform's own numbers explains the recording; the effects below do.",
    ),
    "insufficient": (
        "This recording cannot tell",
        "The file can be read, but it does not hold the information that a diagnosis needs; nothing is said for or "
        "against the model.",
    ),
}
TIERS = {
    "confirmed": "confirmed: it also improves data that its fit did not see",
    "suspected": "suspected: the evidence is there, but data that its fit did not see are not improved beyond doubt",
}
CHANNELS = {"position": "position, horizontal"}

READING_WORDS = {
    "yaw": "the heading", "t": "time", "x": "place", "u": "speed ahead", "w": "speed of rising", "r": "rate of turning",
}  # fmt: skip

NOISES = {
    "random.force": "random force, horizontal",
    "random.heave_force": "random force, vertical",
    "random.moment": "random yaw moment",
    "random.correlation": "memory of the random forces",
    "random.smoothness": "smoothness of the random forces (0 rough, 1 smooth)",
    **{f"reading.{kind.noise or kind.name}": kind.noise_words for kind in KINDS.values() if kind.noise_words},
}

CHECKS = {
    **{name: effect.check for name, effect in EFFECTS.items() if effect.check},
    "compass_distortion": "Iron or currents near the compass: turn the robot slowly through full circles, both ways.",
    "pressure_offset": "Read the sensor at the surface.",
    "pressure_drift": "Read the sensor at the surface before and after; note the air pressure.",
    "sensor_latency": "Filters and buffers between this sensor and its stamp; flash a light on command.",
    "clock_skew": "Synchronise the clocks, or note one event in both recordings at the start and at the end.",
    "camera_scale": "Measure a known length in the camera's picture, at the depth where the robots swim.",
    "frame_mixup": "Axes, signs and units of the driver of this stream; correct them there or in `cocorosim convert`.",
    "imu_bias": "Let the robot lie still, level and turned over, and read the sensor.",
}
_UNITS = {  # of parameters that are no physics of the body
    "compass_distortion": {"offset": "rad", "sin": "rad", "cos": "rad"},
    "pressure_offset": {"offset": "Pa"},
    "pressure_drift": {"rate": "Pa/s"},
    "sensor_latency": {"latency": "s"},
    "clock_skew": {"skew": "s/s"},
    "camera_scale": {"scale": "1"},
    "imu_bias": {"gyro_z": "rad/s", "accel_x": "m/s^2", "accel_y": "m/s^2", "accel_z": "m/s^2"},
}


def effect_words(identifier: str) -> str:
    """An identifier of the catalogue, or of a law outside it, as words."""
    if identifier.startswith("unknown:"):
        equation, _, regressor = identifier.removeprefix("unknown:").partition("~")
        return f"unknown law of {equation.replace('_', ' ')} in proportion to {regressor.replace('*', chr(0xB7))}"
    return identifier.replace("_", " ")


def check_words(identifier: str) -> str:
    """What to look at on the robot or in the tank."""
    if identifier.startswith("unknown:"):
        return (
            "No entry of the catalogue has this law: look for what could act like it, and record again to see it twice."
        )
    return CHECKS.get(identifier, "")


def parameter_unit(effect: str, parameter: str) -> str:
    """The SI unit of a parameter of the catalogue, '1' if the catalogue does not know it."""
    if effect in EFFECTS:
        known = {each.name: each.unit for each in EFFECTS[effect].parameters}
        return known.get(parameter, "1")
    return _UNITS.get(effect, {}).get(parameter, "1")


def odds_words(nats: float) -> str:
    """How much less likely a rival is that many nats behind."""
    if not math.isfinite(nats):
        return "\u2013"
    factor = math.exp(min(nats, 20.0))
    return f"{factor:.2g} times less likely" if factor < 100 else "much less likely"


def nothing_missing_words(diagnosis: Diagnosis) -> str:
    """Why there is no effect in this diagnosis."""
    if diagnosis.verdict == "insufficient":
        return "Nothing could be tested, because the recording holds too little information."
    return "No effect of the catalogue, and no law outside it, explains what the fitted model leaves over."
