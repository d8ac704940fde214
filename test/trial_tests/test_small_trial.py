"""A handful of sealed recordings: the tool names what is large and says nothing where nothing is missing."""

from __future__ import annotations

import json
import os
from typing import Any

import pytest

LARGE = ("thruster_lag", "anisotropic_drag", "compass_distortion", "steady_current")
NOISE = ("--noise", "0.01", "--robots", "1")


@pytest.fixture(scope="module")
def cases(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    """Cases by what was hidden, of recordings of ten minutes at 1 % of random force."""
    from concealer.score import opened
    from trial import sealed
    from trial.examiner import Terms
    from trial.parts import Part

    out, jobs = tmp_path_factory.mktemp("small_trial"), min(2, os.cpu_count() or 1)
    wanted = [Part(name, 1, (*NOISE, "--effects", name, "--size", "0.8")) for name in LARGE]
    wanted += [Part(kind, 1, (*NOISE, "--kind", kind)) for kind in ("nothing", "recalibration")]
    folders = [sealed.conceal(out, part, 20, 1) for part in wanted]
    todo = [task for folder in folders for task in sealed.tasks(out, folder)]
    ends = sealed.diagnose(todo, Terms(jobs, limit=240.0, keep_reports=True))
    assert [end for end in ends if end.status != 0] == []
    return {folder.name: opened(folder, out / "diagnoses" / folder.name)[0] for folder in folders}


@pytest.mark.timeout(600)
@pytest.mark.parametrize("name", LARGE)
def test_a_large_effect_is_named(cases: dict[str, Any], name: str) -> None:
    """It is the first named effect, or within 3 nats of it."""
    assert cases[name].verdict == "mismatch"
    assert cases[name].truth_in_set()


@pytest.mark.parametrize("kind", ["nothing", "recalibration"])
def test_no_effect_is_named_where_structure_is_intact(cases: dict[str, Any], kind: str) -> None:
    """No effect, no claim of a mismatch."""
    assert not cases[kind].false_alarm(), json.dumps(cases[kind].effects)[:500]
