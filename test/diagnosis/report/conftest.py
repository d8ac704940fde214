"""Diagnoses made by hand, one of each verdict: numbers that a Lily could have, residuals that follow their law."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from cocorosim_ros.diagnosis.findings import (
    Concentration,
    Diagnosis,
    Estimate,
    FoundEffect,
    FreeRun,
    HeldOut,
    Located,
    PassedOver,
    Recalibrated,
    ResidualForce,
    Rival,
    ScreenedEffect,
)
from cocorosim_ros.diagnosis.showing.doubt import SIZE_MAY_BE_NOTHING
from cocorosim_ros.world.laws.law import Law
from cocorosim_ros.world.terms.course import Course

DURATION = 600.0  # s
MUNK = -0.016  # N m per m^2/s^2: moment per u*v
LILY = ("lily_01",)


def swimming(robot: str, seed: int, coefficient: float) -> ResidualForce:
    """A robot in curves of changing radius, with the yaw moment coefficient * u * v missing."""
    rng = np.random.default_rng(seed)
    time = np.linspace(0.0, DURATION, 3001)
    u = 0.05 + 0.02 * np.sin(2 * np.pi * time / 47.0)
    r = 0.35 * np.sin(2 * np.pi * time / 31.0) + 0.1
    v = 0.25 * u * r / 0.35
    w = 0.006 * np.sin(2 * np.pi * time / 60.0)
    step = time[1] - time[0]
    yaw = np.cumsum(r) * step
    place = np.stack(
        [
            np.cumsum(u * np.cos(yaw) - v * np.sin(yaw)) * step,
            np.cumsum(u * np.sin(yaw) + v * np.cos(yaw)) * step,
            -0.6 + np.cumsum(w) * step,
            yaw,
        ],
        axis=1,
    )
    scale = np.array([2e-5, 2e-5, 4e-5, 8e-7])
    force = rng.normal(size=(len(time), 4)) * scale
    force[:, 3] += coefficient * u * v
    still = np.zeros((len(time), 3))
    thrust = np.stack([u**2 * 1.7778, 0 * u, 0 * u, r * abs(r) * 1.14e-4], axis=1)
    wide = np.full(3, -5.0), np.array([5.0, 5.0, 0.0])
    course = Course(
        time, np.hstack([place, np.stack([u, v, w, r], axis=1)]), thrust, still, still, np.array([False, False, True]),
        wide, np.zeros((1, 0, 5)), -1,
    )  # fmt: skip
    return ResidualForce(robot, force, np.tile(scale, (len(time), 1)), course)


def free_run(robot: str, start: float) -> FreeRun:
    """Twenty seconds of a circle, and models that leave it ever more slowly."""
    time = start + np.linspace(0.0, 20.0, 101)
    angle = 0.2 * (time - start)

    def run(bend: float) -> np.ndarray:
        radius = 0.3 + bend * (time - start) / 20.0
        return np.stack([radius * np.sin(angle), radius * (1 - np.cos(angle)), -0.6 + 0 * angle, angle], axis=1)

    return FreeRun(robot, time, run(0.0), run(0.12), run(0.06), run(0.01))


def screened(leader: str, nats: float) -> tuple[ScreenedEffect, ...]:
    """Twenty entries of the catalogue; the leader stands out."""
    ids = [
        "linear_drag", "anisotropic_drag", "added_mass", "steady_current", "sheared_current", "tidal_current",
        "tether", "wall_effect", "thruster_lag", "thruster_deadband", "thruster_asymmetry", "torque_bias",
        "reverse_loss", "advance_loss", "battery_sag", "thruster_misalignment", "buoyancy_trim", "pump_lag",
        "compass_distortion", "camera_scale",
    ]  # fmt: skip
    detectable = {
        "thruster_deadband": {"width": 0.11},
        "reverse_loss": {"loss": math.nan},
        "camera_scale": {"scale": 0.2},
    }
    return tuple(
        ScreenedEffect(name, nats if name == leader else 3.0 / (1 + index), detectable.get(name, {"size": 0.01}))
        for index, name in enumerate(ids)
    )


DRAG = Recalibrated("drag", 1.7778, Estimate(1.853, 1.831, 1.875, "kg/m"), LILY)
INERTIA = Recalibrated("inertia", 4.05e-4, Estimate(4.11e-4, 3.98e-4, 4.25e-4, "kg m^2"), LILY)
ADDED_MASS = FoundEffect(
    id="added_mass",
    name="added mass with its Munk moment",
    equation="N = -(m_v - m_u) * u * v",
    robots=LILY,
    tier="confirmed",
    parameters={
        "sway_minus_surge": Estimate(0.0443, 0.0431, 0.0455, "kg"),
        "yaw": Estimate(6.1e-5, 5.2e-5, 7.0e-5, "kg m^2"),
    },
    nats=563.2,
    ambiguous_with=(Rival("anisotropic_drag", 2.1),),
    held_out_nats=211.0,
)


def mismatch() -> Diagnosis:
    """A robot whose added mass the platform file lacks."""
    before = swimming("lily_01", 1, MUNK)
    return Diagnosis(
        verdict="mismatch",
        sentence=(
            "lily_01 has added mass that the platform lacks: sideways 44 g more than ahead, which turns it across its "
            "own drift by up to 22 \u00b5N m."
        ),
        recalibrated=(DRAG,),
        mismatch=(
            Located(
                LILY,
                "yaw",
                "u*v",
                Concentration("turning", 0.9),
                (12.0, 588.0),
                22e-6,
                "N m",
                47.3,
                Law.parse("unknown:yaw~u*v"),
            ),
            Located(
                LILY,
                "surge",
                "v*r",
                Concentration("turning", 0.8),
                (12.0, 588.0),
                0.4e-3,
                "N",
                6.2,
                Law.parse("unknown:surge~v*r"),
            ),
        ),
        effects=(ADDED_MASS,),
        not_shown=("thruster_deadband", "reverse_loss", "camera_scale"),
        manoeuvres=("zig_zag",),
        fit={
            "position": HeldOut(
                0.0315, 0.0202, 0.0111, 0.0108, "m", {"nominal": (0.027, 0.036), "augmented": (0.0097, 0.0126)}
            ),
            "heading": HeldOut(0.182, 0.131, 0.074, math.nan, "rad"),
            "depth": HeldOut(0.004, 0.004, 0.004, 0.0038, "m"),
        },
        all_recalibrated=(DRAG, INERTIA),
        screened=screened("added_mass", 560.0),
        residual_before=(before,),
        residual_after=(swimming("lily_01", 2, 0.0),),
        free_runs=(free_run("lily_01", 420.0), free_run("lily_01", 480.0), free_run("lily_01", 540.0)),
        remarks=("The topic /lily_01/imu is missing.", "3 poses came twice and were dropped."),
        noise={"random force": Estimate(9.5e-5, 8.8e-5, 1.02e-4, "N"), "camera": Estimate(0.002, 0.0019, 0.0021, "m")},
    )


GYRO = FoundEffect(
    id="gyro_scale",
    name="gyroscope that shows too much or too little",
    equation="reading = scale * r",
    robots=LILY,
    tier="suspected",
    parameters={"scale": Estimate(1.02, 0.97, 1.07, "1")},
    nats=52.3,
    topic="imu",
)


def nameless() -> Diagnosis:
    """A robot that lacks something whose size may as well be nothing."""
    found = mismatch()
    passed = PassedOver(GYRO, stands=True, because=("Its size may as well be nothing.",), shortly=SIZE_MAY_BE_NOTHING)
    sentence = "Something is missing, most like a gyroscope that shows too little, but its size may as well be nothing."
    return replace(found, sentence=sentence, effects=(), passed_over=(passed,))


def recalibrate() -> Diagnosis:
    """A robot with 4 % more drag, nothing else."""
    found = mismatch()
    return replace(
        found,
        verdict="recalibrate",
        sentence="Nothing is missing: lily_01 has 4 % more drag than the platform says.",
        mismatch=(),
        effects=(),
        manoeuvres=(),
        screened=screened("none", 0.0),
        residual_before=(swimming("lily_01", 3, 0.0),),
        residual_after=(),
        remarks=(),
    )


def consistent() -> Diagnosis:
    """A robot that is as its platform says."""
    return replace(
        recalibrate(),
        verdict="consistent",
        sentence="The recording agrees with the platform lily; nothing is missing and no number has moved.",
        recalibrated=(),
    )


def insufficient() -> Diagnosis:
    """A recording of a robot that did not move."""
    return Diagnosis(
        verdict="insufficient",
        sentence="lily_01 never moves, so this recording says nothing about its physics.",
        recalibrated=(),
        mismatch=(),
        effects=(),
        not_shown=("added_mass", "linear_drag"),
        manoeuvres=("coast_down",),
        fit={},
        remarks=("The commands of lily_01 are zero throughout.",),
    )


EXAMPLES: dict[str, Callable[[], Diagnosis]] = {
    "mismatch": mismatch,
    "nameless": nameless,
    "recalibrate": recalibrate,
    "consistent": consistent,
    "insufficient": insufficient,
}


@pytest.fixture(scope="session")
def example() -> Callable[[str], Diagnosis]:
    """A function of a verdict: a diagnosis that came to it."""
    made: dict[str, Diagnosis] = {}

    def of(verdict: str) -> Diagnosis:
        if verdict not in made:
            made[verdict] = EXAMPLES[verdict]()
        return made[verdict]

    return of
