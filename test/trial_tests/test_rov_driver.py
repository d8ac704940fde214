"""The driver of the second vehicle's trial: drawn by its prior, diagnosed with its platform file, scored, on a page."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

Tool = Callable[[str], Path]
SHORT = ("--duration", "40")


@pytest.fixture
def made(tool: Tool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> tuple[Path, Path]:
    """Folders of trial and pages of four short recordings, by a tool that names nothing and knows the ROV's file."""
    from trial import parts, prove

    out, pages = tmp_path / "out", tmp_path / "pages"
    run = {"augmented": 0.02, "recalibrated": 0.02, "seconds": 2.0, "against": "readings"}
    answer = json.dumps({"verdict": "consistent", "effects": [], "fit": {"held_out": {"position": run}}})
    runs = tool(
        f"test -f {out}/trial/rov/ledger.json || exit 1\n"
        'case "$*" in *test/trial/rov_platform.yaml*) ;; *) exit 1;; esac\n'
        f'mkdir -p "$out" && echo \'{answer}\' > "$out/diagnosis.json"'
    )
    (whole,) = parts.vehicle_parts("rov", 4)
    short = parts.Part("rov", 4, (*whole.words, *SHORT), whole.platform)
    monkeypatch.setattr(parts, "vehicle_parts", lambda vehicle, count: {("rov", 4): [short]}[vehicle, count])
    words = ["rov", "--count", "4", "--seed-word", "a word", "--jobs", "1", "--limit", "20", "--minutes", "5"]
    options = prove.parser().parse_args([*words, "--out", str(out), "--pages", str(pages)])
    assert options.run(options) == 0
    assert options.run(options) == 0  # gone on with: all is there already
    assert runs.read_text().split() == ["ran"] * 4
    return out, pages


def test_a_trial_of_the_rov_is_sealed_diagnosed_scored_and_told(made: tuple[Path, Path]) -> None:
    """Seed and hash of the ledger are on the page; what was hidden and not named is a failure, all else is none."""
    out, pages = made
    told = json.loads((pages / "trial_rov.json").read_text())
    text = (pages / "trial_rov.md").read_text()
    assert text.startswith("# The sealed trial of a second vehicle, an ROV\n")
    ledger = hashlib.sha256((out / "trial" / "rov" / "ledger.json").read_bytes()).hexdigest()
    assert told["source"]["ledgers"] == {"rov": ledger}
    assert told["source"]["seed_word"] == "a word"
    assert all(f"`{told['source'][key]}`" in text for key in ("seed", "commit", "command"))
    assert ledger in text
    envelopes = [json.loads(path.read_text()) for path in sorted((out / "trial" / "rov" / "envelopes").iterdir())]
    assert {truth["robots"][0] for truth in envelopes} == {"rov_01"}
    unnamed = [truth["recording"] for truth in envelopes if truth["effects"]]
    assert [line.split()[0] for line in told["failures"]] == [f"rov/{name}" for name in unnamed]
    assert all(f"- {line}" in text for line in told["failures"])
    assert told["table"]["rates"]["diagnosis written"]["hits"] == 4


def test_free_runs_of_the_rov_are_measured_by_the_model_that_knows_the_truth(made: tuple[Path, Path]) -> None:
    """The tool's 0.02 m over the oracle's error of as many seconds, readings' noise in both, where the water pushes."""
    out, pages = made
    told = json.loads((pages / "trial_rov.json").read_text())
    envelopes = [json.loads(path.read_text()) for path in (out / "trial" / "rov" / "envelopes").iterdir()]
    ratios = sorted(
        0.02 / truth["oracle"]["rov_01"]["2"]["position"]
        for truth in envelopes
        if truth["noise"] > 0.0 and truth["kind"] != "outside"
    )
    found = told["held_out"]["position: augmented / oracle"]
    assert found["of"] == len(ratios) > 0
    assert ratios[0] <= found["median"] <= ratios[-1]


def test_the_rovs_table_asks_at_its_own_levels_of_random_force() -> None:
    """18 of 20 at half a percent of thrust are too few; what another trial asks at 1 % is no row of it."""
    from trial.sealed_text import SHEETS, asked_table

    rates: dict[str, Any] = {
        f"exact, one medium effect, {noise}% noise": {
            "hits": hits,
            "of": 20,
            "rate": hits / 20,
            "low": 0.0,
            "high": 1.0,
        }
        for noise, hits in (("0.5", 18), ("1", 20), ("1.5", 19))
    }
    figures = {
        "table": {"rates": rates, "ambiguity_set_size": None},
        "intervals": {"coverage": {"of": 0}, "coverage_of_effects": {"of": 0}}, "held_out": {},
    }  # fmt: skip
    rows = asked_table(figures, SHEETS["trial_rov"].levels)[2:4]
    assert [(row.split(" | ")[0].strip("| "), row.split(" | ")[-1].strip("| ")) for row in rows] == [
        ("exact naming, one medium effect, random force 0.5 % of thrust", "no"), ("the same at 1.5 %", "yes"),
    ]  # fmt: skip


@pytest.mark.parametrize("vehicle", ["rov", "slender"])
def test_levels_on_the_page_are_those_of_the_vehicles_prior(vehicle: str) -> None:
    """Rows of the table ask for noise that the prior draws."""
    from concealer.figures import percent
    from concealer.six_degrees.recording import load
    from trial.sealed_text import SHEETS

    drawn = {percent(noise) for noise in load(vehicle)["noise"]}
    assert {f"{level}%" for level in SHEETS[f"trial_{vehicle}"].levels} == drawn - {"0%"}


@pytest.mark.parametrize("vehicle", ["rov", "slender"])
def test_the_tool_is_loaded_with_the_vehicle_of_the_trial(tmp_path: Path, vehicle: str) -> None:
    """The warm-up is a recording of the vehicle with its file, and Lily's where no part is given."""
    from concealer.six_degrees.makes import MAKES
    from trial.parts import platform_of, vehicle_parts
    from trial.sealed import short_diagnosis

    task = short_diagnosis(tmp_path / vehicle, vehicle_parts(vehicle, 1)[0])
    truth = json.loads((tmp_path / vehicle / "warm_up" / "envelopes" / "r0000.json").read_text())
    assert (truth["robots"], truth["kind"], truth["duration"]) == ([MAKES[vehicle].robot], "nothing", 30.0)
    assert task.words[-4:-2] == ["--platform", str(platform_of(vehicle))]
    assert short_diagnosis(tmp_path / "lily").platform == "lily"
