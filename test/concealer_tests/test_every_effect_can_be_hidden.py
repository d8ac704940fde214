"""What a diagnosis can name, a concealer can hide: every effect of the catalogue has a form."""

from __future__ import annotations

from typing import Any

import numpy as np


def _priors() -> list[dict[str, Any]]:
    from concealer import prior
    from concealer.six_degrees.makes import MAKES
    from concealer.six_degrees.recording import load

    return [prior.load(), *(load(make) for make in MAKES)]


def test_every_effect_of_the_catalogue_has_a_form() -> None:
    """In Lily or in a vehicle with six degrees of freedom."""
    from concealer.catalogue_sensors import CATALOGUE
    from concealer.six_degrees.effects import EFFECTS

    from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES, IDS

    named = {entry.id for entry in ENTRIES}
    assert set(IDS) <= named
    assert named <= {*CATALOGUE, *EFFECTS}


def test_every_form_has_a_size() -> None:
    """The registered priors say how large each is, so that a recording with it can be asked for."""
    from concealer import prior
    from concealer.catalogue_sensors import CATALOGUE
    from concealer.six_degrees.effects import EFFECTS

    of_lily, *others = _priors()
    sized = {name for numbers in others for name in prior.entries(numbers)}
    assert set(CATALOGUE) <= set(prior.entries(of_lily))
    assert set(EFFECTS) == sized
    assert all(each["large"] > 0.0 for numbers in _priors() for each in prior.entries(numbers).values())


def test_what_is_asked_for_alone_is_never_drawn() -> None:
    """Recordings that a seed drew before stay as they were."""
    for numbers in _priors():
        assert not set(numbers.get("asked_for", {})) & {*numbers["effects"], *numbers["outside"]}


# What the seeds [60, 0], [60, 1], ... hid alone, and two or three together, before anything was hidden for the asking.
ALONE = (
    "tether", "sensor_latency", "motor_field", "tidal_current", "imu_bias", "compass_distortion", "linear_drag",
    "density_gradient",
)  # fmt: skip
TOGETHER = (
    ["battery_sag", "linear_drag"],
    ["compass_distortion", "pump_lag", "speed_log_scale"],
    ["thruster_misalignment", "tidal_current"],
)


def test_seeds_draw_what_they_drew() -> None:
    """Names of the version before: one more in the list of what is drawn moves all others."""
    from concealer import prior

    numbers = prior.load()
    for kind, names in (("single", [[name] for name in ALONE]), ("several", list(TOGETHER))):
        for seed, hidden in enumerate(names):
            assert prior.suspects(np.random.default_rng([60, seed]), numbers, kind, "rich") == hidden
