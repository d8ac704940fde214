"""Laws of readings outside the catalogue: reading less truth in proportion to products and powers of regressors.

Errors that the catalogue has already are left out: a stream that is late is off by its own rate of change, a distorted
compass by the sine and cosine of the heading.
"""

from __future__ import annotations

from cocorosim_ros.diagnosis.catalogue.entry import Amplitude, Entry
from cocorosim_ros.diagnosis.catalogue.law_forms import (
    amount,
    both,
    given,
    signed_power,
    single,
    square,
    typical_size,
)
from cocorosim_ros.diagnosis.criteria.catalogue import BAD_READING
from cocorosim_ros.world.laws.law import Factor, Law, Product
from cocorosim_ros.world.laws.readings import READING, readings_of
from cocorosim_ros.world.terms.search import Scene


def _plain(*names: str) -> tuple[Product, ...]:
    """Products of one regressor each."""
    return tuple(single(name) for name in names)


_MOTORS = (*_plain("thrust", "yaw_command"), amount("thrust"))
_PUMP = _plain("pump", "pump_rate")
_PLACE = _plain("x", "y", "z")
_SPREAD = signed_power("x", 3.0), signed_power("y", 3.0)  # distortion of a camera's lens, along x and y
_LEVER = signed_power("r", 2.0)
_ACCELERATED = (*_MOTORS, *_plain("z", "t", "u", "r"), square("r"), square("u"))

# By reading: the products to which its error may be proportional.
SENSOR_LAWS_OF: dict[str, tuple[Product, ...]] = {
    "compass": (
        *_MOTORS, *_PUMP, *_PLACE, *_plain("t", "u", "v", "w", "speed"), amount("r"), _LEVER,
        Product(Factor("thrust", 1.0, False), Factor("sin_yaw")),
        Product(Factor("thrust", 1.0, False), Factor("cos_yaw")),
        both("sin_yaw", "cos_yaw"), square("cos_yaw"),
    ),
    "pressure": (
        *_MOTORS, *_PUMP, *_PLACE, *_plain("u", "v", "r", "speed"), square("u"), square("speed"), square("z"),
        square("r"), amount("w"), signed_power("w", 2.0), square("t"),
    ),
    "gyro_z": (
        *_MOTORS, *_PUMP, *_plain("r", "t", "z", "u", "v", "speed", "sin_yaw", "cos_yaw"), amount("r"), _LEVER,
    ),
    "accel_x": _ACCELERATED,
    "accel_y": _ACCELERATED,
    "accel_z": _ACCELERATED,
    "pose_x": (*_plain("y", "z", "sin_yaw", "cos_yaw"), square("x"), square("y"), both("x", "y"), _SPREAD[0]),
    "pose_y": (*_plain("x", "z", "sin_yaw", "cos_yaw"), square("x"), square("y"), both("x", "y"), _SPREAD[1]),
    "pose_z": (*_plain("x", "y", "z"), square("x"), square("y"), square("z")),
    "pose_yaw": _plain("x", "y", "z", "t"),
    "velocity_u": (*_plain("u", "t"), amount("thrust"), _LEVER, signed_power("u", 2.0)),
    "velocity_v": _plain("v", "r", "t"),
    "velocity_w": _plain("w", "t"),
}  # fmt: skip


def sensor_law_entries(scene: Scene, place: str) -> list[Entry]:
    """Make entries of all laws of readings whose regressors occur in the scene, each at `place` of SENSOR_LAWS.

    Laws of poses are left out where nothing but the water moved the robots. There, distances that are read too short
    make the water look calmer, a calmer water is more likely, and so a law of poses by place would gain nats for it.
    """
    return [
        _entry(place, Law(reading, product), scene)
        for reading, products in SENSOR_LAWS_OF.items()
        for product in products
        if typical_size(product, scene) > 0.0 and (scene.driven or READING[reading].topic != "pose")
    ]


def _entry(place: str, law: Law, scene: Scene) -> Entry:
    """Make the entry of one law; its large coefficient is that of a typical error as in a bad case."""
    reading, product = READING[law.of], law.product
    large = BAD_READING[reading.name] / typical_size(product, scene)
    words = reading.topic if len(readings_of(reading.topic)) == 1 else f"{reading.topic} ({reading.name})"
    return Entry(
        law.text,
        f"a law outside the catalogue: {words} in error in proportion to {product.text}",
        f"{reading.name} = truth + c {product.text}",
        reading.topic,
        (Amplitude(f"{place}.coefficient", "coefficient", law.unit, large),),
        topic=reading.topic,
        fixed=given(place, law.codes),
        law=place,
        form=law,
    )
