"""Laws of readings outside the catalogue: reading less truth in proportion to products and powers of regressors.

What an entry of the catalogue says already is left out: a stream that is late is off by its own rate of change, a
distorted compass by the sine and cosine of the heading.
"""

from __future__ import annotations

from cocorosim_ros.diagnosis.catalogue.entry import Amplitude, Entry, Scene
from cocorosim_ros.diagnosis.catalogue.law_forms import Factor, Law, amount, given, product, single, square
from cocorosim_ros.world.sensors.law import READINGS_OF_LAWS


def _plain(*names: str) -> tuple[Law, ...]:
    return tuple(single(name) for name in names)


_MOTORS = (*_plain("thrust", "yaw_command"), amount("thrust"))
_PUMP = _plain("pump", "pump_rate")
_PLACE = _plain("x", "y", "z")
_SPREAD = Law("|x|^2*x", Factor("x", 3.0)), Law("|y|^2*y", Factor("y", 3.0))  # of lenses, along x and y
_LEVER = Law("|r|*r", Factor("r", 2.0))
_ACCELERATED = (*_MOTORS, *_plain("z", "t", "u", "r"), square("r"), square("u"))

# By reading.
SENSOR_LAWS_OF: dict[str, tuple[Law, ...]] = {
    "compass": (
        *_MOTORS, *_PUMP, *_PLACE, *_plain("t", "u", "v", "w", "speed"), amount("r"), _LEVER,
        Law("|thrust|*sin_yaw", Factor("thrust", 1.0, False), Factor("sin_yaw")),
        Law("|thrust|*cos_yaw", Factor("thrust", 1.0, False), Factor("cos_yaw")),
        product("sin_yaw", "cos_yaw"), square("cos_yaw"),
    ),
    "pressure": (
        *_MOTORS, *_PUMP, *_PLACE, *_plain("u", "v", "r", "speed"), square("u"), square("speed"), square("z"),
        square("r"), amount("w"), Law("|w|*w", Factor("w", 2.0)), square("t"),
    ),
    "gyro_z": (
        *_MOTORS, *_PUMP, *_plain("r", "t", "z", "u", "v", "speed", "sin_yaw", "cos_yaw"), amount("r"), _LEVER,
    ),
    "accel_x": _ACCELERATED,
    "accel_y": _ACCELERATED,
    "accel_z": _ACCELERATED,
    "pose_x": (*_plain("y", "z", "sin_yaw", "cos_yaw"), square("x"), square("y"), product("x", "y"), _SPREAD[0]),
    "pose_y": (*_plain("x", "z", "sin_yaw", "cos_yaw"), square("x"), square("y"), product("x", "y"), _SPREAD[1]),
    "pose_z": (*_plain("x", "y", "z"), square("x"), square("y"), square("z")),
    "pose_yaw": _plain("x", "y", "z", "t"),
    "velocity_u": (*_plain("u", "t"), amount("thrust"), _LEVER, Law("|u|*u", Factor("u", 2.0))),
    "velocity_v": _plain("v", "r", "t"),
    "velocity_w": _plain("w", "t"),
}  # fmt: skip
# By reading: topic, size of a bad case, its unit.
_SHOWN: dict[str, tuple[str, float, str]] = {
    "compass": ("compass", 0.05, "rad"),
    "pressure": ("pressure", 200.0, "Pa"),
    "gyro_z": ("imu", 0.02, "rad/s"),
    **{f"accel_{axis}": ("imu", 0.03, "m/s^2") for axis in "xyz"},
    **{f"pose_{axis}": ("pose", 0.03, "m") for axis in "xyz"},
    "pose_yaw": ("pose", 0.05, "rad"),
    **{f"velocity_{axis}": ("velocity", 0.005, "m/s") for axis in "uvw"},
}


def sensor_law_entries(scene: Scene, place: str) -> list[Entry]:
    """All laws of readings, each at this place of SENSOR_LAWS.

    None of poses where nothing but the water moved the robots: a place that is read too short then only makes the water
    look calmer, and laws of poses by place take that for a merit.
    """
    return [
        _entry(place, reading, law, scene)
        for reading, laws in SENSOR_LAWS_OF.items()
        for law in laws
        if law.size(scene) > 0.0 and (scene.driven or not reading.startswith("pose"))
    ]


def _entry(place: str, reading: str, law: Law, scene: Scene) -> Entry:
    topic, size, unit = _SHOWN[reading]
    large = size / law.size(scene)
    words = f"{topic}" if len([each for each, *_ in _SHOWN.values() if each == topic]) == 1 else f"{topic} ({reading})"
    return Entry(
        f"unknown:{topic}~{law.regressor}",
        f"a law outside the catalogue: {words} in error in proportion to {law.regressor}",
        f"{reading} = truth + c {law.regressor}",
        topic,
        (Amplitude(f"{place}.coefficient", "coefficient", law.unit(unit), large),),
        topic=topic,
        fixed=given(place, {"reading": float(READINGS_OF_LAWS.index(reading)), **law.codes}),
        law=place,
    )
