"""The model that a diagnosis found, given as the platform, lets the same recordings be consistent."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from cocorosim_ros.world.terms.equations import EQUATION_CODE
from cocorosim_ros.world.terms.regressors import REGRESSOR_CODE

HIDDEN = {
    "several": {
        "linear_drag": {"surge": 0.02, "sway": 0.02, "heave": 0.02, "yaw": 3e-5},
        "torque_bias": {"torque": 1e-5},
        "tidal_current": {"x": -0.004, "y": 0.007, "period": 60.0, "phase": 1.0},
    },
    "one": {"thruster_lag": {"time_constant": 0.3}},
    "other_form": {"law_1": {"coefficient": -1e-5, "equation": 3.0, "power_1": 0.0, "round_1": 0.02, "regressor_1": 8}},
    "bent": {
        "anisotropic_drag": {"sway_ratio": 1.0, "heave_ratio": 3.0, "form": 1.0},
        "law_1": {
            "coefficient": 30.0, "equation": float(EQUATION_CODE["heave"]), "regressor_1": float(REGRESSOR_CODE["w"]),
            "power_1": 3.0, "signed_1": 1.0,
        },
    },
}  # fmt: skip
NAMED = {"bent": ["anisotropic_drag"]}
"""Where a law bends a named effect, that alone is named: the law is another form of it."""


@pytest.mark.parametrize("case", HIDDEN)
def test_the_found_model_finds_nothing(swim: Any, tmp_path: Path, case: str) -> None:
    """Something is found at first, nothing with the model that was found."""
    from cocorosim_ros.diagnosis.diagnose import diagnose
    from cocorosim_ros.library.diagnosis_result import DiagnosisResult
    from cocorosim_ros.scenario.parts.platform import load_platform
    from cocorosim_ros.scenario.reading.quantity import Quantity, dimension_of
    from cocorosim_ros.world.effects import EFFECTS

    plain = load_platform("lily")
    hidden = {
        effect: {
            part.name: Quantity(values[part.name], "1" if part.unit == "*" else part.unit,
                                dimension_of("1" if part.unit == "*" else part.unit))
            for part in EFFECTS[effect].parameters if part.name in values
        }
        for effect, values in HIDDEN[case].items()
    }  # fmt: skip
    evidence = swim(replace(plain, effect_quantities=hidden), 150.0, seed=51, base=plain)
    first = DiagnosisResult(diagnose(evidence, lambda words, share: None), evidence)
    names = [each.id for each in first.effects]
    assert names and names == NAMED.get(case, names)
    (tmp_path / "model.yaml").write_text(first.model_yaml, encoding="utf-8")
    model = load_platform(str(tmp_path / "model.yaml"))
    second = diagnose(replace(evidence, platform=model), lambda words, share: None)
    assert (second.verdict, second.effects, second.recalibrated) == ("consistent", (), ())
