"""Numbers that a diagnosis does not fit: named by their keys, of those that it would fit."""

from __future__ import annotations

from pathlib import Path

import pytest

from cocorosim_ros.diagnosis.fitting.base_model import RECALIBRATED
from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.parts.kept_numbers import FITTED_WITHOUT_RANGE
from cocorosim_ros.scenario.parts.platform import Platform, load_platform, platform_tree, read_platform
from cocorosim_ros.scenario.reading.entry import entry_of

INERTIA = "yaw_inertia: {value: 4e-4, unit: kg m^2, range: [1e-4, 1e-3], source: guess, confidence: estimate}\n"


def lily(folder: Path, kept: str, more: str = "") -> Platform:
    """A Lily with a list of numbers that are kept."""
    path = folder / "lily_here.yaml"
    path.write_text(f"based_on: lily\n{more}kept_as_given: {kept}\n", "utf-8")
    return load_platform(path)


def test_the_list_is_read_and_written(tmp_path: Path) -> None:
    """By the keys of the file; five numbers are fitted without a range in the file too."""
    platform = lily(tmp_path, "[yaw_drag, yaw_inertia]", INERTIA)
    assert platform.kept_as_given == ("yaw_drag", "yaw_inertia")
    assert read_platform(entry_of(platform_tree(platform), "written")).kept_as_given == platform.kept_as_given
    assert "kept_as_given" not in platform_tree(load_platform("lily"))
    assert {*FITTED_WITHOUT_RANGE, "yaw_inertia"} == set(RECALIBRATED)


@pytest.mark.parametrize(
    ("kept", "sentence"),
    [
        (
            "[yaw_inertia]",
            r"'kept_as_given\[0\]' has 'yaw_inertia', which no diagnosis fits; leave it out, or .*yaw_drag",
        ),
        ("[drag, drga]", r"'kept_as_given\[1\]' has 'drga', which no diagnosis fits; .* drag,"),
        ("[drag, drag]", r"'kept_as_given\[1\]' has 'drag', which stands in the list before; leave it out"),
        ("drag", "'kept_as_given' has 'drag' where a list is needed"),
        ("[[drag]]", r"'kept_as_given\[0\]' has \[drag\] where text is needed"),
    ],
)
def test_what_no_diagnosis_fits_is_refused(kept: str, sentence: str, tmp_path: Path) -> None:
    """A number without range is known by the file already, and one that is not there is a slip of the pen."""
    with pytest.raises(CocorosimError, match=sentence):
        lily(tmp_path, kept)
