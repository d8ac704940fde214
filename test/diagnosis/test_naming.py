"""What is hidden in a simulated recording is named, and nothing where nothing is."""

from __future__ import annotations

from typing import Any

import pytest

SECONDS = 150.0
# Effect, what is hidden of it, and the number that is checked.
HIDDEN = [
    ("thruster_lag", {"time_constant": 0.3}),
    ("torque_bias", {"torque": 1e-5}),
    ("pump_lag", {"time_constant": 0.5}),
    ("linear_drag", {"surge": 0.02, "sway": 0.02, "heave": 0.02, "yaw": 3e-5}),
]


# Together, without any random force: the first explains so much that the second must not pass for a rest of it.
TOGETHER: dict[str, dict[str, float]] = {
    "linear_drag": {"surge": 0.02, "sway": 0.02, "heave": 0.02, "yaw": 0.0},
    "tidal_current": {"x": -0.0008, "y": 0.0013, "period": 70.0, "phase": 1.0},
}


def diagnosed(
    swim: Any, hidden: dict[str, dict[str, float]], seed: int, seconds: float = SECONDS, disturbance: float = 0.005
) -> Any:
    """The diagnosis of a swim with these effects, by a base that lacks them, and the progress that was told."""
    from hidden_effects import hiding

    from cocorosim_ros.diagnosis.diagnose import diagnose
    from cocorosim_ros.scenario.parts.platform import load_platform

    plain = load_platform("lily")
    said: list[str] = []
    evidence = swim(hiding(plain, hidden), seconds, seed=seed, base=plain, disturbance=disturbance)
    return diagnose(evidence, lambda words, share: said.append(words)), said


@pytest.mark.parametrize(("effect", "numbers"), HIDDEN, ids=[effect for effect, _ in HIDDEN])
def test_what_is_hidden_is_named(swim: Any, effect: str, numbers: dict[str, float]) -> None:
    """Two and a half minutes name the effect and nothing else, with the truth within twice its interval."""
    diagnosis, said = diagnosed(swim, {effect: numbers}, seed=1)
    assert diagnosis.verdict == "mismatch"
    assert [part.id for part in diagnosis.effects] == [effect]
    for name, truth in numbers.items():
        found = diagnosis.effects[0].parameters[name]
        assert abs(found.value - truth) <= found.high - found.low
    assert diagnosis.fit["position"].augmented < diagnosis.fit["position"].recalibrated * 1.05
    assert said


CURVED: dict[str, dict[str, float]] = {
    "thrust_curve": {"exponent": 1.5},
    "linear_drag": {"surge": 0.02, "sway": 0.02, "heave": 0.02, "yaw": 3e-5},
}


def test_an_early_wrong_name_is_thrown_out(swim: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    """A curve of the thrust passes for a dead band as long as the drag beside it is not known; then it has to go."""
    from cocorosim_ros.diagnosis.naming import naming

    taken: list[tuple[set[str], set[str]]] = []
    prune = naming.pruned

    def watched(stage: Any, *rest: Any, **more: Any) -> Any:
        left = prune(stage, *rest, **more)
        taken.append(tuple({each.candidate.entry.id for each in one.named} for one in (stage, left)))
        return left

    monkeypatch.setattr(naming, "pruned", watched)
    diagnosis, _ = diagnosed(swim, CURVED, seed=51)
    assert {"thruster_deadband"} in [before - after for before, after in taken]
    assert {part.id for part in diagnosis.effects} == set(CURVED)
    exponent = diagnosis.effects[0].parameters["exponent"]
    assert exponent.low < CURVED["thrust_curve"]["exponent"] < exponent.high


FIVE: dict[str, dict[str, float]] = {
    "linear_drag": {"surge": 0.02, "sway": 0.02, "heave": 0.02, "yaw": 0.0},
    "thruster_lag": {"time_constant": 0.6},
    "torque_bias": {"torque": 1.2e-5},
    "buoyancy_trim": {"force": -2e-3},
    "thruster_deadband": {"width": 0.12},
}


def test_five_effects_are_all_named(swim: Any) -> None:
    """There is no limit on how many are missing: what earns its place is named."""
    diagnosis, _ = diagnosed(swim, FIVE, seed=4, seconds=300.0)
    assert {part.id for part in diagnosis.effects} == set(FIVE)
    lag = next(part for part in diagnosis.effects if part.id == "thruster_lag").parameters["time_constant"]
    assert abs(lag.value - 0.6) <= lag.high - lag.low


def test_nothing_is_accused_where_nothing_is_hidden(swim: Any) -> None:
    """A recording of the very model is called consistent, or insufficient for some effects, never a mismatch."""
    diagnosis, _ = diagnosed(swim, {}, seed=2)
    assert diagnosis.verdict in ("consistent", "insufficient")
    assert diagnosis.effects == ()
    assert [course.robot for course in diagnosis.velocities] == ["lily_01"]
    assert all(run.velocity is not None for run in diagnosis.free_runs)


def test_a_pump_that_is_late_by_a_moment_is_not_accused(swim: Any) -> None:
    """Thirty-five milliseconds are those of a clock; neither the pump nor a law that says the same is named."""
    diagnosis, _ = diagnosed(swim, {"pump_lag": {"time_constant": 0.035}}, seed=3)
    assert diagnosis.effects == ()


@pytest.mark.parametrize("moment", [110.0, 116.5])
def test_a_payload_is_found_wherever_its_step_lies(swim: Any, moment: float) -> None:
    """Half a millinewton less weight in still water, between two of the moments that are tried first or at one."""
    diagnosis, _ = diagnosed(swim, {"payload_shift": {"force": 6e-4, "time": moment}}, 4, 300.0, disturbance=0.0)
    assert [part.id for part in diagnosis.effects] == ["payload_shift"]
    assert diagnosis.effects[0].parameters["time"].value == pytest.approx(moment, abs=2.0)


def test_an_effect_does_not_hide_behind_another_where_no_water_pushes(swim: Any) -> None:
    """Both are named, though the model without one of them is wrong by hundreds of standard deviations."""
    diagnosis, _ = diagnosed(swim, TOGETHER, 5, 300.0, disturbance=0.0)
    assert {part.id for part in diagnosis.effects} == set(TOGETHER)


def test_a_sensor_is_not_blamed_for_another_one(swim: Any) -> None:
    """A camera that shows lengths one per cent long is that, not a gauge, seldom read, that errs by depth."""
    from dataclasses import replace

    from cocorosim_ros.diagnosis.fitting.recalibration import base_fit
    from cocorosim_ros.diagnosis.naming.naming import name_effects
    from cocorosim_ros.scenario.parts.platform import load_platform

    evidence = swim(load_platform("lily"), SECONDS, seed=6)
    (recording,) = evidence.recordings
    (log,) = recording.robots
    pose, pressure = log.streams["pose"], log.streams["pressure"]
    changed = {
        "pose": replace(pose, value=pose.value * (1.01, 1.01, 1.01, 1.0)),
        "pressure": replace(pressure, time=pressure.time[::20], value=pressure.value[::20]),
    }
    log = replace(log, streams={**log.streams, **changed})
    base = base_fit(replace(evidence, recordings=(replace(recording, robots=(log,)),)))
    naming = name_effects(base, lambda words, share: None)
    assert [effect.candidate.entry.id for effect in naming.named] == ["camera_scale"]


def test_what_does_not_look_like_an_effect_is_no_rest_of_it(swim: Any) -> None:
    """A weak asymmetry beside a tide that explains a hundred times as much: both are named."""
    hidden = {
        "tidal_current": {"x": -0.004, "y": 0.007, "period": 60.0, "phase": 1.0},
        "thruster_asymmetry": {"difference": 0.02},
    }
    diagnosis, _ = diagnosed(swim, hidden, 9, 300.0, disturbance=0.01)
    assert {part.id for part in diagnosis.effects} == set(hidden)


def test_who_does_not_keep_its_promise_makes_room(monkeypatch: pytest.MonkeyPatch) -> None:
    """A slope at a kink promises more than anybody; the next ones are fitted too, the law as well, all but once."""
    from types import SimpleNamespace

    from cocorosim_ros.diagnosis.naming import naming

    def screened(name: str, nats: float, topic: str | None = None) -> Any:
        entry = SimpleNamespace(id=name, topic=topic, group="")
        return SimpleNamespace(candidate=SimpleNamespace(entry=entry), nats=nats)

    fitted: list[str] = []

    def begin(fit: Any, part: Any, scene: Any) -> Any:
        fitted.append(part.candidate.entry.id)
        return SimpleNamespace(gain=0.0 if part.candidate.entry.topic == "velocity" else part.nats)

    monkeypatch.setattr(naming, "begin", begin)
    kinked = [screened("sensor_latency", nats, "velocity") for nats in (327.0, 301.0, 237.0, 64.0)]
    honest = [screened("pump_lag", 57.0), screened("clock_skew", 10.5, "pressure"), screened("tether", 0.5)]
    law = screened("unknown:heave~pump_rate", 30.0)
    begun = naming._begun(None, None, [*kinked, *honest], [law])  # type: ignore[arg-type]
    assert fitted == ["sensor_latency"] * 4 + ["unknown:heave~pump_rate", "pump_lag", "clock_skew"]
    assert len(begun) == len(fitted)
