"""The page of a fleet: one sentence first, then what drifts, what is alike, what is common, and what is missing."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from cocorosim_ros.diagnosis.criteria.fleet import FLEET_PAGE
from cocorosim_ros.diagnosis.fleet.findings import fleet_findings
from cocorosim_ros.diagnosis.fleet.fleet_tree import fleet_tree
from cocorosim_ros.diagnosis.fleet.outcome import Outcome
from cocorosim_ros.diagnosis.fleet.page import FleetOrigin, render_fleet
from cocorosim_ros.diagnosis.fleet.rows import rows_of
from cocorosim_ros.diagnosis.fleet.sentence import fleet_sentence

Make = Callable[..., Any]
ORIGIN = FleetOrigin("bags/<2026>", "lily", ("A process <died>.",))
BROKEN = Outcome("week_09/broken", (), "week_09/broken is no <recording>; record again.")


def findings(outcomes: Any, missing: int = 0) -> Any:
    """Findings about a fleet."""
    return fleet_findings(rows_of(outcomes), missing)


@pytest.fixture(scope="module")
def losing(drawn_fleet: Make) -> Any:
    """Twelve robots in eight weeks, the first of which loses 2 % of its thrust a week, and a broken recording."""
    return findings([*drawn_fleet(np.random.default_rng(12), 12, 8, loss=0.02), BROKEN], 3)


def test_the_page_says_all_and_needs_nothing(losing: Any) -> None:
    """Every part is there, texts are escaped, and no other file or network is asked for."""
    page = render_fleet(losing, ORIGIN)
    assert f"<h1>{fleet_sentence(losing)}</h1>" in page
    assert "<b>Not finished:</b> 3 recordings are not diagnosed yet" in page
    for part in ("drift", "found", "alike", "common", "blind", "problems", "remarks", "how"):
        assert f'<h2 id="{part}">' in page and f'href="#{part}"' in page
    assert "week_09/broken is no &lt;recording&gt;; record again." in page and "A process &lt;died&gt;." in page
    assert re.search("made from 2023-11-1[4-6] to 2024-01", page) and "96 recordings are dated by the stamps" in page
    assert page.count('class="clear"') == 3  # among those that drift, among all of one number, among all tests
    assert page.count("<svg") == 2 and "tether" in page
    assert not re.search(r"(src|href)=\"(?!#)", page) and "prefers-color-scheme: dark" in page


def test_a_fault_that_grows_is_seen(outcome: Make) -> None:
    """One thruster that weakens is no number of the platform: the page lists it with its least and greatest value."""

    def weak(value: float, tier: str) -> dict[str, Any]:
        parameters = {"difference": {"value": value, "ci95": [value - 0.001, value + 0.001], "unit": "1"}}
        return {
            "id": "thruster_asymmetry",
            "robots": ["lily_01"],
            "tier": tier,
            "nats": 90.0,
            "parameters": parameters,
            "ambiguous_with": [],
        }

    rows = [outcome(f"w{week}", "lily_01", 7.0 * week, {"thrust_gain": (0.0, 0.01)},
                    [weak(-0.01 * week, "confirmed" if week > 2 else "suspected")] if week else [])
            for week in range(5)]  # fmt: skip
    page = " ".join(re.sub("<[^>]*>", " ", render_fleet(findings(rows), ORIGIN)).split())
    assert re.search(r"lily_01 4 of 5 2 difference .0\.04\d* to .0\.01", page), page


def test_headlines_are_short(drawn_fleet: Make, outcome: Make, losing: Any) -> None:
    """One sentence of 25 words at most, whatever was found."""
    rng = np.random.default_rng(13)
    many = drawn_fleet(rng, 2, 8, loss=0.05) + [
        outcome(f"w{week}/x", f"x{robot}", 7.0 * week + 0.1 * robot, {"drag": (0.03 * week, 0.001)})
        for robot in range(3) for week in range(6)
    ]  # fmt: skip
    cases = {
        r"One of 12 robots drifts: lily_01 loses (1\.9\d|2\.\d+).% of its thrust a week\.": losing,
        r"4 of 5 robots drift, most clearly \w+: it (gains|loses) .*": findings(many),
        r"No number of the platform drifts .* in any of 3 robots, in 15 diagnosed recordings\.": findings(
            drawn_fleet(rng, 3, 5)
        ),
        r"Drift cannot be told: no robot has 4 dated recordings or more among the 6 that were diagnosed\.": findings(
            drawn_fleet(rng, 3, 2)
        ),
        r"None of 1 recording could be diagnosed; the reasons stand below\.": findings([BROKEN]),
    }
    for pattern, found in cases.items():
        sentence = fleet_sentence(found)
        assert re.fullmatch(pattern, sentence), sentence
        assert len(sentence.split()) <= FLEET_PAGE.most_words


@pytest.mark.parametrize("outcomes", [[], [BROKEN]])
def test_a_page_about_nothing(outcomes: list[Outcome]) -> None:
    """A fleet of which nothing could be diagnosed has a page all the same."""
    page = render_fleet(findings(outcomes), ORIGIN)
    assert "no drift could be tested" in page and page.count("<svg") == 0


def test_the_same_for_programs(losing: Any) -> None:
    """Plain values without NaN: which drifts, groups with their members, problems."""
    tree = json.loads(json.dumps(fleet_tree(losing), allow_nan=False))
    (drift,) = [each for each in tree["drifts"] if each["drifts"]]
    assert (drift["robot"], drift["parameter"], drift["recordings"]) == ("lily_01", "thrust_gain", 8)
    low, high = drift["per_week"]["ci95"]
    assert low < -0.02 < high < 0.0
    assert sum(len(group["members"]) for group in tree["alike"]["groups"]) == 96
    assert tree["problems"] == [{"recording": "week_09/broken", "problem": BROKEN.problem}]
    assert (tree["missing"], tree["recordings"]) == (3, 97)


def test_it_opens_in_a_browser(losing: Any, browse: Callable[..., str], tmp_path: Path) -> None:
    """As it is written: the sentence is the title."""
    file = tmp_path / "fleet.html"
    file.write_text(render_fleet(losing, ORIGIN), "utf-8")
    shown = browse(file, picture=tmp_path / "page.png")
    assert "loses" in shown and (tmp_path / "page.png").stat().st_size > 20_000
