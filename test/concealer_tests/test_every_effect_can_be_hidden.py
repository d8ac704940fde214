"""What a diagnosis can name, a concealer can hide: every effect of the catalogue has a form, or a reason for none."""

from __future__ import annotations

import numpy as np

WITHOUT = {
    "ground_log_scale": "no vehicle of the trials has a log of its speed over ground",
    "ground_log_misalignment": "no vehicle of the trials has a log of its speed over ground",
    "ground_log_lever": "no vehicle of the trials has a log of its speed over ground",
    "hull_lift": "no vehicle of the trials has a slender hull",
    "wash_loss": "no vehicle of the trials has a thruster in the jet of another",
}
"""Effects that are not hidden, and why."""


def test_every_effect_of_the_catalogue_has_a_form() -> None:
    """In the Lily or in the ROV; a reason stands only where there is none."""
    from concealer.catalogue_sensors import CATALOGUE
    from concealer.six_degrees.effects import EFFECTS

    from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES, IDS

    named = {entry.id for entry in ENTRIES}
    hidden = {*CATALOGUE, *EFFECTS}
    assert set(IDS) <= named
    assert named - hidden == set(WITHOUT)
    assert all(reason for reason in WITHOUT.values())


def test_every_form_has_a_size() -> None:
    """The registered priors say how large each is, so that a recording with it can be asked for."""
    from concealer import prior
    from concealer.catalogue_sensors import CATALOGUE
    from concealer.six_degrees.effects import EFFECTS
    from concealer.six_degrees.recording import load

    for numbers, forms in ((prior.load(), CATALOGUE), (load(), EFFECTS)):
        assert set(forms) <= set(prior.entries(numbers))
        assert all(prior.entries(numbers)[name]["large"] > 0.0 for name in forms)


def test_what_is_asked_for_alone_is_never_drawn() -> None:
    """Recordings that a seed drew before stay as they were."""
    from concealer import prior
    from concealer.six_degrees.recording import load

    for numbers in (prior.load(), load()):
        assert not set(numbers["asked_for"]) & {*numbers["effects"], *numbers["outside"]}


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
