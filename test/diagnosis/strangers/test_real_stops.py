"""What must never be said again, on parts of the recordings that once had it said.

The whole sets take an hour: their page is docs/real.md.
"""

from __future__ import annotations

from pathlib import Path

from trial.recordings import MANEUVERING1, crossings

from cocorosim_ros.diagnosis.diagnose import diagnose
from cocorosim_ros.diagnosis.evidence.gather import gather_evidence
from cocorosim_ros.scenario.parts.platform import load_platform
from cocorosim_ros.scenario.reading.config_files import find_config
from cocorosim_ros.wire.conversion.conversion import convert
from cocorosim_ros.wire.conversion.map_file import load_map

from .conftest import Told

GLIDER_ROWS = 1400  # of the glider's first file: two dives, 27 minutes
OF_PRESSURE = ("pressure_gain", "pressure_offset", "pressure_drift")


def test_a_pressure_sensor_that_alone_shows_the_depth_has_no_law(data: Path, tmp_path: Path) -> None:
    """Three dives of a small AUV: of twelve, a law by which the gauge errs with the depth was confirmed.

    Whatever is named is suspected at most, with its reasons.
    """
    files = [data / "haizhe_auv" / "reference" / f"run_{dive:03d}.csv" for dive in range(3)]
    bags = [tmp_path / file.stem for file in files]
    for file, bag in zip(files, bags, strict=True):
        convert(load_map(find_config("maps", "haizhe_auv")), file, bag)
    first = diagnose(gather_evidence(bags, load_platform("haizhe_auv")), lambda words, share: None)
    names = [each.id for each in first.effects]
    assert not any(name in OF_PRESSURE or name.startswith("unknown:pressure") for name in names), names
    assert all(each.tier == "suspected" and each.because for each in first.effects)


def test_a_glider_whose_speed_nobody_measured_has_no_cause(data: Path, told: Told, tmp_path: Path) -> None:
    """Two dives: a trim of the buoyancy was confirmed on a fit that had collapsed, and then a hull that gives way."""
    lines = (data / "slocum_glider" / "glider_A.csv").read_text("utf-8").splitlines(keepends=True)
    (tmp_path / "glider_A.csv").write_text("".join(lines[:GLIDER_ROWS]), encoding="utf-8")
    convert(load_map(find_config("maps", "slocum_glider")), tmp_path / "glider_A.csv", tmp_path / "bag")
    first, second = told("slocum_glider", [tmp_path / "bag"])
    assert (first.verdict, first.effects, second.verdict, second.effects) == ("insufficient", (), "insufficient", ())


def test_a_fit_that_foretells_worse_names_nothing(data: Path, told: Told, tmp_path: Path) -> None:
    """A few minutes of a ferry: its fitted numbers turn it wrongly, are kept as the file has them, and that is said."""
    bag = crossings(data, tmp_path, *MANEUVERING1)[0]
    first, second = told("milliampere_ferry", [bag])
    assert (first.verdict, first.effects, second.verdict, second.effects) == ("insufficient", (), "insufficient", ())
    assert any("its fit has collapsed" in warning for warning in first.warnings)
