"""Laws of readings outside the catalogue: reading less truth in proportion to products and powers of regressors.

Which products, and how large an error is in a bad case, stands in the file of each sensor.
"""

from __future__ import annotations

from cocorosim_ros.diagnosis.catalogue.entry import Amplitude, Entry
from cocorosim_ros.diagnosis.catalogue.law_forms import given, typical_size
from cocorosim_ros.diagnosis.catalogue.law_words import law_words
from cocorosim_ros.world.laws.law import Law, Product
from cocorosim_ros.world.laws.readings import READING
from cocorosim_ros.world.sensors import KINDS
from cocorosim_ros.world.terms.search import Scene

SENSOR_LAWS_OF: dict[str, tuple[Product, ...]] = {
    kind.name: tuple(Product.parse(text) for text in kind.error_follows) for kind in KINDS.values()
}
"""Products to which the error of each reading may be proportional."""


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
    large = KINDS[reading.name].large_error / typical_size(product, scene)
    return Entry(
        law.text,
        law_words(law),
        f"{reading.name} = truth + c {product.text}",
        reading.topic,
        (Amplitude(f"{place}.coefficient", "coefficient", law.unit, large),),
        topic=reading.topic,
        fixed=given(place, law.codes),
        law=place,
        form=law,
    )
