"""What makes free runs worse is taken back, and only if it clearly does."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from cocorosim_ros.diagnosis import diagnose
from cocorosim_ros.diagnosis.catalogue.catalogue import ENTRIES
from cocorosim_ros.diagnosis.findings import FoundEffect, HeldOut
from cocorosim_ros.diagnosis.foretelling.gains import Gain
from cocorosim_ros.diagnosis.naming.named_effect import Refused
from cocorosim_ros.diagnosis.showing import harm
from cocorosim_ros.diagnosis.showing.harm import _is_worse


@pytest.mark.parametrize(("spread", "taken_back"), [(0.0, False), (0.001, True)])
def test_one_free_run_takes_no_name_back(spread: float, taken_back: bool) -> None:
    """Of several runs an error that is clearly greater takes it back; of a single one the interval is a point."""
    errors = {"nominal": 0.03, "recalibrated": 0.015, "augmented": 0.03}
    intervals = {name: (error - spread, error + spread) for name, error in errors.items()}
    row = HeldOut(**errors, noise_floor=0.015, unit="rad", intervals=intervals)
    assert _is_worse("heading", row) == taken_back


@pytest.mark.parametrize(
    ("effect", "mean", "taken_back"),
    [("pose_lever", -0.3, True), ("pose_lever", -0.05, False), ("pressure_offset", -0.3, False), ("wind", -0.3, True)],
)
def test_a_loss_in_all_takes_back_what_free_runs_have(effect: str, mean: float, taken_back: bool) -> None:
    """Effects of motion and an antenna off the centre, if the loss is clear; not an offset, which moves nothing."""
    entry = next(each for each in ENTRIES if each.id == effect)
    named: Any = SimpleNamespace(named=[SimpleNamespace(candidate=SimpleNamespace(entry=entry))])
    intervals = {name: (0.1, 0.2) for name in ("nominal", "recalibrated", "augmented")}
    row = HeldOut(0.15, 0.15, 0.15, 0.1, "m", intervals)
    free: Any = SimpleNamespace(table={"position": row}, gain=Gain(mean, 0.1, 9))
    assert harm._is_harmed(named, free) is taken_back


def naming(count: int) -> Any:
    """A naming of so many effects, whose fit is their number."""
    return SimpleNamespace(named=("lag", "curve", "lever")[:count], fit=count)


@pytest.mark.parametrize(("most", "left"), [(3, 3), (2, 2), (1, 1), (-1, 0)])
def test_effects_are_taken_back_until_unseen_data_are_foretold_well(
    monkeypatch: pytest.MonkeyPatch, most: int, left: int
) -> None:
    """The least first, and no more than needed; all of them where nothing helps."""
    errors = {"unit": "m", "intervals": {}, "noise_floor": 0.0, "nominal": 1.0, "recalibrated": 1.0}

    def free_runs(_unseen: Any, count: int) -> Any:
        return SimpleNamespace(table={"position": HeldOut(**errors, augmented=count)})

    monkeypatch.setattr(harm, "without_least", lambda before: naming(len(before.named) - 1))
    monkeypatch.setattr(harm, "held_out_free_runs", free_runs)
    nothing: Any = None
    kept, runs = harm.fewer_until(
        lambda table: table["position"].augmented <= most, naming(3), nothing, free_runs(nothing, 3)
    )
    assert (len(kept.named), runs.table["position"].augmented) == (left, left)


@pytest.mark.parametrize("exact", [False, True])
def test_what_is_taken_back_is_told(monkeypatch: pytest.MonkeyPatch, exact: bool) -> None:
    """With its nats and the reason, as something that is not missing; of an exact fit rounding alone was judged."""
    lever, lag = (SimpleNamespace(candidate=SimpleNamespace(key=name)) for name in ("pose_lever", "thruster_lag"))
    before, after = (SimpleNamespace(named=named, fit=None, harmful=()) for named in ((lever, lag), (lag,)))

    def told(_fit: Any, gone: Any, _numbers: Any) -> list[FoundEffect]:
        return [FoundEffect(each.candidate.key, "", "", ("boat",), "confirmed", {}, 1770.0) for each in gone]

    monkeypatch.setattr(harm, "found_effects", told)
    monkeypatch.setattr(harm, "fitted", lambda fit: ())
    monkeypatch.setattr(diagnose, "that_helps", lambda naming, unseen: (after, SimpleNamespace(table={})))
    monkeypatch.setattr(diagnose, "without_other_forms", lambda naming: (naming, ()))
    monkeypatch.setattr(diagnose, "beyond_doubt", lambda naming: (naming, ()))
    monkeypatch.setattr(diagnose, "told_at_last", lambda naming, forms: ())
    monkeypatch.setattr(diagnose, "is_exact", lambda table: exact)
    given: Any = before
    _, _, passed = diagnose._beyond_doubt(given, given)
    assert [each.found.id for each in passed] == ([] if exact else ["pose_lever"])
    assert all(not each.stands and each.because == (harm.FORETOLD_WORSE,) for each in passed)


def test_what_is_taken_back_beside_others_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    """Each once, though the search may have taken it back twice, with the fit that last had it."""
    sag = SimpleNamespace(candidate=SimpleNamespace(key="battery_sag"))
    naming: Any = SimpleNamespace(harmful=(Refused("first", sag), Refused("last", sag)))  # type: ignore[arg-type]

    def told(fit: Any, gone: Any, _numbers: Any) -> list[FoundEffect]:
        return [FoundEffect(each.candidate.key, fit, "", ("rov",), "confirmed", {}, 232.0) for each in gone]

    monkeypatch.setattr(harm, "found_effects", told)
    monkeypatch.setattr(harm, "fitted", lambda fit: ())
    (passed,) = harm.harmful_to_others(naming)
    assert (passed.found.id, passed.stands) == ("battery_sag", False)
    assert passed.because == (harm.WORSE_BESIDE_OTHERS,)
    assert "last" in vars(passed.found).values()


@pytest.mark.parametrize("exact", [False, True])
def test_what_rounding_alone_took_back_beside_others_is_not_told(monkeypatch: pytest.MonkeyPatch, exact: bool) -> None:
    """As of what is taken back at last: of an exact fit free runs differ by rounding."""
    naming: Any = SimpleNamespace(named=(), fit=None)
    monkeypatch.setattr(diagnose, "harmful_to_others", lambda naming: ("beside others",))
    monkeypatch.setattr(diagnose, "that_helps", lambda naming, unseen: (naming, SimpleNamespace(table={})))
    monkeypatch.setattr(diagnose, "without_other_forms", lambda naming: (naming, ()))
    monkeypatch.setattr(diagnose, "beyond_doubt", lambda naming: (naming, ()))
    monkeypatch.setattr(diagnose, "told_at_last", lambda naming, forms: ())
    monkeypatch.setattr(diagnose, "is_exact", lambda table: exact)
    assert diagnose._beyond_doubt(naming, naming)[2] == (() if exact else ("beside others",))
