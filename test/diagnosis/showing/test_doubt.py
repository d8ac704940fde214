"""Effects that get no name: those whose size may as well be nothing, in the mean over all parts of the recordings."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES
from cocorosim_ros.diagnosis.criteria.naming import NAMING
from cocorosim_ros.diagnosis.criteria.showing import ESTIMATES
from cocorosim_ros.diagnosis.fitting.candidate import Candidate
from cocorosim_ros.diagnosis.fitting.held_out import HeldOutGain
from cocorosim_ros.diagnosis.foretelling.gains import Gain
from cocorosim_ros.diagnosis.naming.named_effect import NamedEffect, Naming, Refused
from cocorosim_ros.diagnosis.showing import doubt
from cocorosim_ros.diagnosis.showing.doubt import Clear, beyond_doubt, doubtful_robots, refused_effects, rests_of_found
from cocorosim_ros.diagnosis.showing.form_width import Heterogeneity
from cocorosim_ros.diagnosis.showing.withdrawn import Withdrawn

ROBOTS, TRACKS = ("a", "b"), ((0, 2), (1,))


def candidate(identifier: str, topic: str | None = None) -> Candidate:
    """An entry of the catalogue for two robots."""
    return Candidate(next(each for each in ENTRIES if (each.id, each.topic) == (identifier, topic)), ROBOTS, TRACKS)


def effect(of: Candidate, nats: float, mean: float | None = None) -> NamedEffect:
    """A named effect, by which free runs gain so much; None for an error of readings."""
    told = None if mean is None else Gain(mean, 0.1, 8)
    return NamedEffect(of, nats, (), HeldOutGain(np.zeros(1), 0.5), told)


def test_one_clear_amplitude_keeps_an_effect() -> None:
    """Of three of a robot one suffices, and it does so for its own robot; a current is that of all robots."""
    drag, current = candidate("linear_drag"), candidate("steady_current")
    fit: Any = SimpleNamespace(unknowns=(*drag.amplitudes(), *current.amplitudes()))
    count = len(drag.entry.amplitudes)
    clear = np.zeros(len(fit.unknowns), dtype=bool)
    assert doubtful_robots(effect(drag, 20.0), fit, clear) == ROBOTS
    assert doubtful_robots(effect(current, 20.0), fit, clear) == ROBOTS
    clear[[count - 1, 2 * count]] = True  # the last of a, the first of the current
    assert doubtful_robots(effect(drag, 20.0), fit, clear) == ("b",)
    assert doubtful_robots(effect(current, 20.0), fit, clear) == ()


def test_a_clear_form_is_no_size() -> None:
    """However sure the place of a tether is, without a stiffness there is none."""
    tether = candidate("tether")
    shapes = tuple(
        replace(
            tether.amplitudes()[0], column=each.column, owner=replace(tether.amplitudes()[0].owner, parameter=each.name)
        )
        for each in tether.entry.shapes
    )
    fit: Any = SimpleNamespace(unknowns=(*tether.amplitudes(), *shapes))
    clear = np.array([False] * len(tether.amplitudes()) + [True] * len(shapes))
    assert shapes and doubtful_robots(effect(tether, 20.0), fit, clear) == ROBOTS


def test_numbers_are_asked_with_the_scatter_of_parts(monkeypatch: pytest.MonkeyPatch) -> None:
    """By hand: numbers that readings tell to 0.03, that scatter by 0.4 from part to part and by 0.2 in the mean.

    1 is more than nothing in any part; 0.7 may be nothing in a part, but not in the mean; 0.3 in both; without scatter
    0.3 in neither. An effect by which unseen data do not clearly gain is asked for parts alone.
    """
    differing = Heterogeneity(np.array([0.16, 0.16, 0.16, 0.0]), np.array([0.04, 0.04, 0.04, 0.0]))
    monkeypatch.setattr(doubt, "variances_between_parts", lambda fit: differing)
    monkeypatch.setattr(doubt, "covariance", lambda fit: np.diag(np.full(4, 0.03**2)))
    fit: Any = SimpleNamespace(q=np.array([-1.0, 0.7, 0.3, 0.3]))
    clear = doubt._clear(fit)
    guess = effect(candidate("linear_drag"), 200.0)
    foretold = replace(guess, held_out=HeldOutGain(np.zeros(1), 0.5 * ESTIMATES.held_out_p))
    assert clear.of(guess).tolist() == [True, False, False, True]
    assert clear.of(foretold).tolist() == [True, True, False, True]


@pytest.mark.parametrize("lasting", ["a", None])
def test_a_delay_among_errors_that_last_has_to_be_in_all_parts(
    monkeypatch: pytest.MonkeyPatch, lasting: str | None
) -> None:
    """Though its mean is clear, and held-out parts gain: it is taken back, and says nothing of what is missing.

    Where errors are white it stays. By hand: 0.7 is known to 0.03, scatters by 0.4 between parts and 0.2 in the mean.
    """
    late = candidate("sensor_latency", "velocity")
    unknowns = tuple(late.amplitudes())
    count = len(unknowns)
    differing = Heterogeneity(np.full(count, 0.16), np.full(count, 0.04))
    monkeypatch.setattr(doubt, "variances_between_parts", lambda fit: differing)
    monkeypatch.setattr(doubt, "covariance", lambda fit: np.diag(np.full(count, 0.03**2)))
    memory = SimpleNamespace(column="memory.velocity", owner=SimpleNamespace(robots=(lasting,)))
    stream = SimpleNamespace(time=0.02 * np.arange(50))
    tracks = (SimpleNamespace(log=SimpleNamespace(streams={"velocity": stream})),) * 3
    fit: Any = SimpleNamespace(
        unknowns=unknowns, q=np.full(count, 0.7), noise=(memory,) if lasting else (), tracks=tracks
    )
    named = replace(effect(late, 137.0), held_out=HeldOutGain(np.zeros(1), 0.1 * ESTIMATES.held_out_p))

    def withdrawn(naming: Any, weakest: Any, robots: Any) -> Any:
        return Withdrawn(replace(naming, named=()), weakest, _told(weakest))

    monkeypatch.setattr(doubt, "withdrawn", withdrawn)
    left, passed = beyond_doubt(Naming(fit, fit, (named,), (), ()))
    assert len(left.named) == (lasting is None)
    assert [each.stands for each in passed] == ([False] if lasting else [])


def _told(effect: NamedEffect) -> Any:
    return (effect.candidate.entry.id,)


def test_the_weakest_goes_first_and_the_rest_is_asked_again(monkeypatch: pytest.MonkeyPatch) -> None:
    """Two that stand in for each other are nothing each; once the weaker is gone, the other is clear and stays."""
    drag, bias = candidate("linear_drag"), candidate("torque_bias")
    monkeypatch.setattr(doubt, "_clear", lambda fit: Clear(*np.full((2, 9), fit != "both")))
    monkeypatch.setattr(doubt, "doubtful_robots", lambda each, fit, clear: () if clear[0] else ROBOTS)
    gone: list[str] = []

    def withdrawn(naming: Any, weakest: Any, robots: Any) -> Any:
        gone.append(weakest.candidate.entry.id)
        left = tuple(each for each in naming.named if each is not weakest)
        weaker = replace(weakest, nats=weakest.nats - 5.0)
        return Withdrawn(replace(naming, fit="one", named=left), weaker, _told(weakest))

    monkeypatch.setattr(doubt, "withdrawn", withdrawn)
    both: Any = "both"
    naming, passed = beyond_doubt(Naming(both, both, (effect(drag, 40.0, 0.1), effect(bias, 12.0, 0.1)), (), ()))
    assert gone == ["torque_bias"] and [each.candidate.entry.id for each in naming.named] == ["linear_drag"]
    assert [(each.found, each.stands) for each in passed] == [("torque_bias", False)]  # 7 nats do not suffice


@pytest.mark.parametrize(
    ("nats", "mean", "stands"),
    [(1.1, None, True), (0.9, None, False), (1.1, 0.01, True), (1.1, -0.01, False), (1.1, 0.0, False)],
)
def test_when_something_is_missing_all_the_same(nats: float, mean: float | None, stands: bool) -> None:
    """Where the evidence suffices without a name, and free runs, if there are any, gain by the effect."""
    gone = effect(candidate("torque_bias"), nats * NAMING.threshold, mean)
    assert doubt.stands_without_name(gone) is stands
    assert len(doubt._of_free_runs(gone.foretold)) == (mean is not None and mean <= 0.0)


@pytest.mark.parametrize(
    ("nats", "p", "mean", "told"),
    [
        (1.1, 0.01, 0.05, 1),
        (1.1, 0.01, -0.05, 1),
        (1.1, 0.01, -0.15, 1),  # one and a half times the spread of the mean may be chance
        (1.1, 0.01, -0.5, 0),
        (0.9, 0.01, 0.05, 0),
        (1.1, 0.2, 0.05, 0),
    ],
)
def test_what_free_runs_refuse_a_name(
    nats: float, p: float, mean: float, told: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It is told where it has thrice the evidence, held-out readings bear it out and free runs do not clearly lose."""
    monkeypatch.setattr(doubt, "fitted", lambda fit: ())
    monkeypatch.setattr(doubt, "found_effects", lambda fit, named, numbers: [each.candidate.entry.id for each in named])
    strong = replace(
        effect(candidate("linear_drag"), nats * NAMING.nameless, mean), held_out=HeldOutGain(np.zeros(1), p)
    )
    weak = replace(strong, candidate=candidate("torque_bias"), nats=0.5 * NAMING.nameless)
    fit: Any = "fit"
    naming = Naming(fit, fit, (), (), (), refused=(Refused(fit, weak), Refused(fit, strong)))
    passed = refused_effects(naming)
    assert [(each.found, each.stands) for each in passed] == [("linear_drag", True)] * told
    assert refused_effects(replace(naming, named=(strong, weak))) == ()
    assert rests_of_found(naming) == ()
    found_before = replace(naming, known=(replace(effect(candidate("added_mass"), 90.0), found_before=True),))
    assert refused_effects(found_before) == ()
    rests = rests_of_found(found_before)
    assert len(rests) == told and all(f"{strong.nats:.0f} nats" in each and "'linear_drag'" in each for each in rests)


def test_beside_found_effects_a_mean_is_not_enough(monkeypatch: pytest.MonkeyPatch) -> None:
    """Numbers that differ from part to part may be what their forms leave; taken back, it is not missing either."""
    bias = candidate("torque_bias")
    named = replace(effect(bias, 60.0, 0.1), held_out=HeldOutGain(np.zeros(1), 0.01))
    fit: Any = SimpleNamespace(unknowns=tuple(bias.amplitudes()))
    one = np.ones(len(fit.unknowns), dtype=bool)
    monkeypatch.setattr(doubt, "_clear", lambda fit: Clear(~one, one))
    monkeypatch.setattr(
        doubt,
        "withdrawn",
        lambda naming, each, robots: Withdrawn(replace(naming, named=()), each, _told(each)),
    )
    alone = Naming(fit, fit, (named,), (), ())
    declared = replace(alone, known=(effect(candidate("linear_drag"), 90.0),))
    assert beyond_doubt(alone) == (alone, ()) and beyond_doubt(declared) == (declared, ())
    _, passed = beyond_doubt(
        replace(alone, known=(replace(effect(candidate("linear_drag"), 90.0), found_before=True),))
    )
    assert [(each.found, each.stands) for each in passed] == [("torque_bias", False)]


def test_a_diagnosis_without_a_name(swim: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    """A torque that is taken back is said to be missing, with numbers and nats; model and free runs are without it."""
    import json

    from cocorosim_ros.diagnosis.diagnose import diagnose
    from cocorosim_ros.diagnosis.report.json_file import diagnosis_json
    from cocorosim_ros.library.diagnosis_result import DiagnosisResult
    from cocorosim_ros.scenario.parts.platform import load_platform
    from cocorosim_ros.scenario.reading.quantity import Quantity, dimension_of

    plain = load_platform("lily")
    torque = {"torque_bias": {"torque": Quantity(2e-5, "N m", dimension_of("N m"))}}
    evidence = swim(replace(plain, effect_quantities=torque), 100.0, seed=7, base=plain)
    monkeypatch.setattr(doubt, "_clear", lambda fit: Clear(*np.zeros((2, len(fit.unknowns)), dtype=bool)))
    found = diagnose(evidence, lambda words, share: None)
    assert found.verdict == "mismatch" and found.effects == ()
    assert found.sentence.startswith("Something is missing, most like ")
    assert [each.found.id for each in found.passed_over] == ["torque_bias"]
    (passed,) = found.passed_over
    assert passed.stands and passed.found.nats > NAMING.threshold and passed.because == (doubt.MAY_BE_NOTHING,)
    assert passed.found.parameters["torque"].value == pytest.approx(2e-5, rel=0.2)
    assert "torque_bias" not in DiagnosisResult(found, evidence).model_yaml
    row = found.fit["heading"]
    assert row.augmented == pytest.approx(row.recalibrated, rel=0.2)
    tree = json.loads(diagnosis_json(found))
    assert tree["effects"] == [] and tree["passed_over"][0]["missing"] is True
