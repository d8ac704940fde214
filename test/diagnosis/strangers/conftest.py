"""What is asked of every vehicle of others: that it is found once, and suspected at most where a stop speaks."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import pytest

DATA = Path(__file__).resolve().parents[4] / "shared" / "data"
Told = Callable[[str, Sequence[Path]], tuple[Any, Any]]
FoundOnce = Callable[..., tuple[Any, Any]]


@pytest.fixture
def data() -> Path:
    """The folder of the recordings of others."""
    if not DATA.is_dir():
        pytest.skip("the recordings of others are not on this machine")
    return DATA


@pytest.fixture
def told(tmp_path: Path) -> Told:
    """Diagnose recordings, and again with the model that was found: function of (platform, bags)."""
    from cocorosim_ros.diagnosis.diagnose import diagnose
    from cocorosim_ros.diagnosis.evidence.gather import gather_evidence
    from cocorosim_ros.library.diagnosis_result import DiagnosisResult
    from cocorosim_ros.scenario.parts.platform import load_platform

    def twice(platform: str, bags: Sequence[Path]) -> tuple[Any, Any]:
        evidence = gather_evidence(bags, load_platform(platform))
        first = DiagnosisResult(diagnose(evidence, lambda words, share: None), evidence)
        (tmp_path / "model.yaml").write_text(first.model_yaml, encoding="utf-8")
        same = gather_evidence(bags, load_platform(tmp_path / "model.yaml"))
        return first.diagnosis, diagnose(same, lambda words, share: None)

    return twice


@pytest.fixture
def found_once(told: Told) -> FoundOnce:
    """Diagnose recordings with a platform, and again with the found model: function of (platform, bags, stops, again).

    stops: words of the sentences, in the first diagnosis' warnings, for which nothing is more than suspected; () where
    nothing speaks against what is named. again: the verdict with the found model. Gives both diagnoses.
    """

    def found(platform: str, bags: Sequence[Path], stops: Sequence[str], again: str = "consistent") -> tuple[Any, Any]:
        first, second = told(platform, bags)
        assert first.effects or first.recalibrated
        sure = [each.id for each in first.effects if each.tier == "confirmed"]
        assert not (stops and sure), sure
        lacking = [words for words in stops if not any(words in each for each in first.warnings)]
        assert lacking == []
        assert (second.verdict, second.effects, second.recalibrated) == (again, (), ())
        return first, second

    return found
