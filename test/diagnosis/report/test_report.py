"""The page about a diagnosis: whole, self-contained, and sensible for every verdict."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import Path

import numpy as np
import pytest
from matplotlib.image import imread

from cocorosim_ros.diagnosis.findings import (
    ActuatorReport,
    Comparison,
    Diagnosis,
    Estimate,
    FoundEffect,
    Located,
    ResidualReading,
)
from cocorosim_ros.diagnosis.report.model_file import Origin
from cocorosim_ros.diagnosis.report.report import render_report
from cocorosim_ros.diagnosis.tracks.columns import NOISE_UNITS
from cocorosim_ros.scenario.parts.platform import load_platform
from cocorosim_ros.world.laws.law import Law
from cocorosim_ros.world.terms.regressors import REGRESSOR_CODE

Example = Callable[[str], Diagnosis]
SECTIONS = ["where", "what", "sure", "else", "fit", "numbers", "blind", "next", "remarks", "how"]
VOID = {"meta", "br", "img", "link", "hr", "input"}
MOST = 3_000_000  # bytes


class Page(HTMLParser):
    """Balance of tags, headings, pictures with their captions, links and all text of a page."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.open: list[str] = []
        self.sections: list[str] = []
        self.counts: dict[str, int] = {}
        self.words: list[str] = []
        self.links: list[str] = []
        self.feed(text)
        self.close()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        """Notes the tag."""
        self.counts[tag] = self.counts.get(tag, 0) + 1
        self.links += [value or "" for name, value in attrs if name in ("href", "src", "xlink:href")]
        self.sections += [value or "" for name, value in attrs if name == "id" and tag == "h2"]
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        """Notes the tag, which closes itself."""
        self.counts[tag] = self.counts.get(tag, 0) + 1

    def handle_endtag(self, tag: str) -> None:
        """Compares the tag with the one that is open."""
        assert self.open.pop() == tag

    def handle_data(self, data: str) -> None:
        """Collects text outside of styles."""
        if "style" not in self.open and "svg" not in self.open:
            self.words.append(data)

    @property
    def text(self) -> str:
        """The words of the page."""
        return " ".join(" ".join(self.words).split()).replace("\u00a0", " ")


def page(diagnosis: Diagnosis) -> tuple[str, Page]:
    """The page's text and content."""
    origin = Origin(load_platform("lily"), ("bags/tank_7",), ("lily_01",), 600.0)
    text = render_report(diagnosis, origin)
    return text, Page(text)


Pages = Callable[[str], tuple[str, Page]]
PLACES = (
    ("surge", "x (world_x)", Law.parse("unknown:world_x~x")),
    ("compass", "sin", None),
    ("heave", "pump_rate", Law.parse("unknown:heave~pump_rate")),
    ("surge", "1", Law.parse("unknown:surge~1")),
)


@pytest.fixture(scope="module")
def pages(example: Example) -> Pages:
    """A function of a verdict: its page, made once."""
    made: dict[str, tuple[str, Page]] = {}
    return lambda verdict: made.setdefault(verdict, made.get(verdict) or page(example(verdict)))


@pytest.mark.parametrize("verdict", ["consistent", "recalibrate", "mismatch", "nameless", "insufficient"])
def test_every_verdict_gives_a_whole_page(pages: Pages, example: Example, verdict: str) -> None:
    """All sections in their order, tags balanced, the sentence as title and heading, a caption for every picture."""
    text, content = pages(verdict)
    sentence = example(verdict).sentence
    assert content.sections == SECTIONS
    assert content.open == []
    first = re.search(r"\bnats?\b", content.text)
    assert first is not None and content.text[first.end() :].startswith(", each of which makes it 2.7 times as likely")
    assert text.count("2.7 times as likely") == 1
    assert f"<title>{sentence}</title>" in text
    assert f"<h1>{sentence}</h1>" in text
    assert content.counts.get("svg", 0) == content.counts.get("figcaption", 0) == content.counts.get("figure", 0)
    assert len(text.encode()) < MOST


@pytest.mark.parametrize("verdict", ["consistent", "recalibrate", "mismatch", "insufficient"])
def test_a_page_needs_nothing_else(pages: Pages, verdict: str) -> None:
    """No link leads out of the page, nothing is loaded; every link inside leads to something."""
    text, content = pages(verdict)
    assert all(link.startswith("#") for link in content.links)
    targets = set(re.findall(r'\bid="([^"]+)"', text))
    assert {link[1:] for link in content.links} <= targets
    assert set(re.findall(r"url\(#([^)]+)\)", text)) <= targets
    assert "<script" not in text
    assert "@import" not in text


@pytest.mark.parametrize("verdict", ["consistent", "recalibrate", "mismatch", "insufficient"])
def test_no_number_has_an_exponent_or_is_nan(pages: Pages, verdict: str) -> None:
    """Words and axes show plain numbers with SI prefixes."""
    text, content = pages(verdict)
    labels = " ".join(re.findall(r"<text[^>]*>([^<]*)</text>", text))
    assert not re.search(r"\d[eE][-+\u2212]?\d|\bnan\b|\binf\b|10\^", f"{content.text} {labels}")


def test_a_mismatch_is_told_with_numbers_and_rivals(pages: Pages) -> None:
    """Effect, typeset law, interval in handy units, rival, held-out errors, what cannot be seen, what to do."""
    text, content = pages("mismatch")
    for words in ("44.3 g", "43.1 to 45.5 g", "2.1 nats", "8.2 times less likely", "31.5 mm", "11.1 mm",
                  "thruster deadband: from about width 0.110", "zig-zag at three speeds", "3 poses came twice",
                  "1.853 kg/m", "22.0 \u00b5N m"):  # fmt: skip
        assert words in content.text, words
    assert "<i>N</i> = \u2212(<i>m</i><sub>v</sub>" in text
    # Over time, against two regressors, over the tank, by conditions, nats, free runs, parameters.
    assert content.counts["svg"] == 8


@pytest.mark.parametrize(
    ("verdict", "words"),
    [
        ("consistent", ["Nothing has to be done", "No effect of the catalogue", "Nowhere: what the fitted model"]),
        ("nameless", ["Without a name", "52.3", "may as well be nothing", "not in model.yaml", "Record again, longer"]),
        (
            "recalibrate",
            [
                "No effect of the catalogue explains anything, but numbers",
                "so there are no rivals",
                "diagnose the next recording",
            ],
        ),
        ("insufficient", ["holds too little information", "drive at three speeds", "zero throughout"]),
    ],
)
def test_empty_parts_say_why(pages: Pages, verdict: str, words: list[str]) -> None:
    """What is not there is explained."""
    for expected in words:
        assert expected in pages(verdict)[1].text


def test_words_of_others_are_no_markup(example: Example) -> None:
    """Names of files and topics cannot break the page."""
    text, content = page(replace(example("insufficient"), sentence="a < b & <script>c", remarks=("<b>x",)))
    assert "<script>c" not in text
    assert "a < b & <script>c" in content.text
    assert content.open == []


def test_odd_findings_still_give_a_page(example: Example) -> None:
    """Streams, laws along the world's axes, regressors nobody recorded, infinite and missing numbers, many robots."""
    found = example("mismatch")
    mixed = FoundEffect("frame_mixup", "axes", "", ("lily_01",), "confirmed", {}, math.inf, topic="pose",
                        correction="the position is in millimetres")  # fmt: skip
    unknown = FoundEffect(
        "unknown:world_x~x", "a law", "F_x = c x", ("lily_01",), "suspected",
        {"coefficient": Estimate(-3e-4, -4e-4, math.nan, "N/(m)")}, 12.0, law=PLACES[0][2],
    )  # fmt: skip
    places = tuple(
        Located(("lily_01",), equation, regressor, None, (0.0, math.nan), 1e-4, "N", math.nan, law)
        for equation, regressor, law in PLACES
    )
    time = np.linspace(0.0, 600.0, 500)
    reading = ResidualReading("lily_01", "compass", "rad", "yaw", time, time % 6.0, np.sin(time), np.full(500, np.nan))
    robots = tuple(replace(found.residual_before[0], robot=f"lily_{number:02d}") for number in range(1, 6))
    odd = replace(
        found, effects=(mixed, unknown), mismatch=places, readings=(reading,), residual_before=robots, residual_after=()
    )
    text, content = page(odd)
    assert content.open == []
    expected = ("the position is in millimetres", "world x", "/lily_01/compass", "2 more robots", "\u2212300 \u00b5N/m")
    for words in expected:
        assert words in content.text, words
    assert len(text.encode()) < MOST


def test_the_same_diagnosis_gives_the_same_page(example: Example) -> None:
    """Byte for byte."""
    assert page(example("insufficient"))[0] == page(example("insufficient"))[0]
    few = replace(example("mismatch"), residual_before=(), residual_after=(), free_runs=())
    assert page(few)[0] == page(few)[0]


def test_what_was_not_observed_is_not_drawn(example: Example) -> None:
    """A vehicle whose place nobody saw has no map and no path, but its heading and depth."""
    found = example("mismatch")
    fit = {name: each for name, each in found.fit.items() if name != "position"}
    text, content = page(replace(found, fit=fit))
    assert "Seen from above" not in content.text
    assert "measured path" not in content.text
    labels = re.findall(r"<text[^>]*>([^<]*)</text>", text)
    assert any("error of depth" in label for label in labels)
    assert not any("error of position" in label for label in labels)


@pytest.mark.parametrize(("recordings", "second"), [(5, "lily_01 in bags/2"), (7, "lily_01, 2 of its 5 recordings")])
def test_recordings_of_one_robot_are_told_apart(example: Example, recordings: int, second: str) -> None:
    """Its pictures carry the names of the recordings, or a number where some had no use; no robot is made up."""
    residuals = example("mismatch").residual_before * 5
    found = replace(example("mismatch"), residual_before=residuals, residual_after=())
    names = tuple(f"bags/{number}" for number in range(1, recordings + 1))
    text = render_report(found, Origin(load_platform("lily"), names, ("lily_01",), 600.0))
    titles = re.findall("<h3>(lily_01.*?)</h3>", text)
    assert titles[1] == second and len(set(titles)) == 3
    assert "about 2 more recordings too" in text and "more robots" not in text


def test_noise_is_called_by_words(example: Example) -> None:
    """Every number of noise that a fit knows has a name for readers."""
    noise = {name: Estimate(1e-3, 9e-4, 1.1e-3, unit) for name, unit in NOISE_UNITS.items()}
    _, content = page(replace(example("mismatch"), noise=noise))
    assert "random force, horizontal" in content.text and "a reading of pose, x and y" in content.text
    assert "random." not in content.text and "reading." not in content.text


def test_stretches_are_of_as_many_robots_as_possible(example: Example) -> None:
    """Five stretches of the first robot do not crowd out the other two."""
    run = example("mismatch").free_runs[0]
    robots = ["lily_01"] * 5 + ["lily_02", "lily_03"]
    found = replace(example("mismatch"), free_runs=tuple(replace(run, robot=name) for name in robots))
    labels = re.findall(r"<text[^>]*>([^<]*, from 420 s)</text>", page(found)[0])
    assert labels == [f"{name}, from 420 s" for name in ("lily_01", "lily_02", "lily_03")]


def test_what_errors_are_measured_against_is_said(example: Example) -> None:
    """Readings, or the course; moments without a reading leave gaps in the pictures and no warning."""
    plain = example("mismatch")
    run = plain.free_runs[0]
    measured = run.measured.copy()
    measured[::2, :2] = np.nan
    measured[:, 2] = np.nan
    fit = {**plain.fit, "depth": replace(plain.fit["depth"], against="course")}
    _, content = page(replace(plain, fit=fit, free_runs=(replace(run, measured=measured),)))
    assert "readings" in content.text and "course" in content.text


def with_findings(found: Diagnosis, *places: Located) -> Diagnosis:
    """The diagnosis with other findings, and without any other pictures."""
    return replace(found, mismatch=places, readings=(), free_runs=(), screened=(), all_recalibrated=())


def located(equation: str, regressor: str, law: Law | None) -> Located:
    """A finding of lily_01."""
    return Located(("lily_01",), equation, regressor, None, (0.0, 600.0), 1e-4, "N", 9.0, law, (0.1, 0.3))


@pytest.mark.parametrize("name", REGRESSOR_CODE)
def test_every_regressor_has_its_picture_or_its_sentence(example: Example, name: str) -> None:
    """One of both for each entry of the table: nothing is left out silently."""
    law = Law.parse(f"unknown:surge~{name}")
    _, content = page(with_findings(example("mismatch"), located("surge", name, law)))
    drawn = "The missing part of surge" in content.text
    said = f"There is no picture of surge against {name.replace('_', ' ')}" in content.text
    # The robot of the example is alone: it has no neighbours.
    assert (drawn, said) == (name != "neighbour_distance", name == "neighbour_distance")


def test_what_has_no_picture_has_a_sentence(example: Example) -> None:
    """Streams without an effect, effects of streams without a picture, findings and readings beyond the first few."""
    few = with_findings(example("mismatch"), located("compass", "sin", None))
    assert "There is no picture of compass against sin: it is of readings" in page(few)[1].text
    many = tuple(located("surge", name, Law.parse(f"unknown:surge~{name}")) for name in ("x", "y", "t", "v"))
    assert "Drawn are the 3 clearest of 4 findings" in page(with_findings(few, *many))[1].text
    late = FoundEffect("sensor_latency", "late", "", ("lily_01",), "confirmed", {}, 9.0, topic="velocity")
    assert "There is no picture of /lily_01/velocity for sensor latency" in page(replace(few, effects=(late,)))[1].text
    time = np.linspace(0.0, 600.0, 500)
    reading = ResidualReading("lily_01", "compass", "rad", "yaw", time, time % 6.0, np.sin(time), 0 * time, "rad")
    content = page(replace(few, readings=(reading,) * 5))[1]
    assert "Not drawn, to be brief: what /lily_01/compass show" in content.text
    assert "against the heading" in content.text
    assert "There is no picture of compass against sin" not in content.text


MEASURE = """<script>
const sizes = [...document.querySelectorAll("figure svg")].map((each) => each.getBoundingClientRect());
document.body.dataset.figures = sizes.filter((size) => size.width > 100 && size.height > 50).length;
document.body.dataset.wide = document.documentElement.scrollWidth > window.innerWidth;
</script>"""


def test_a_browser_shows_the_page(pages: Pages, tmp_path: Path, browse: Callable[..., str]) -> None:
    """The sentence, every section and every figure at a size to be read; nothing sticks out, and it is not blank."""
    text, content = pages("mismatch")
    (tmp_path / "report.html").write_text(text.replace("</body>", f"{MEASURE}</body>"), "utf-8")
    shown = browse((tmp_path / "report.html"), "", tmp_path / "report.png")
    assert f'data-figures="{content.counts["svg"]}"' in shown
    assert 'data-wide="false"' in shown
    assert [f'id="{section}"' in shown for section in SECTIONS] == [True] * len(SECTIONS)
    assert content.counts["svg"] > 3
    picture = imread(tmp_path / "report.png")
    assert picture.shape[:2] == (2000, 1280)
    assert len(np.unique(picture.reshape(-1, picture.shape[2]), axis=0)) > 10


def test_long_paths_break_on_a_narrow_page(pages: Pages, tmp_path: Path, browse: Callable[..., str]) -> None:
    """The facts below the headline stay within the page, whatever the platform's file is called."""
    text, _ = pages("mismatch")
    measure = """<script>document.body.style.width = "360px";
document.body.dataset.facts = document.querySelector("table.facts").getBoundingClientRect().width <= 360;</script>"""
    text = text.replace(", <code>cocorosim diagnose", f", {'a_folder/' * 30}<code>cocorosim diagnose", 1)
    (tmp_path / "report.html").write_text(text.replace("</body>", f"{measure}</body>"), "utf-8")
    assert 'data-facts="true"' in browse(tmp_path / "report.html")


def test_probabilities_stand_once_and_in_words(example: Example) -> None:
    """Whole percents that add up to 100, without underscores; where names are told, what is meant by the others."""
    for verdict in ("mismatch", "recalibrate", "consistent", "insufficient"):
        text = page(example(verdict))[1].text
        told = re.findall(r"How probable: (.*?)\. (?:Nothing|Learned from simulated)", text)
        assert len(told) == 1 and "_" not in told[0] and text.count("How probable") == 1
        sets = told[0].rpartition("; taken together ")[2]
        assert sum(map(int, re.findall(r"(\d+) %", sets))) == 100
        named = verdict == "mismatch"
        assert ("something else" in sets) == named == ("Nothing: the physics of the model is complete" in text)
        assert ("what is believed without it" in text) == (verdict == "insufficient")


def test_probabilities_of_a_comparison_are_of_the_difference(example: Example) -> None:
    """Nothing then means that the vehicles are alike."""
    text = page(replace(example("mismatch"), against=Comparison(("good",), (), ())))[1].text
    assert "Nothing: the vehicles are alike, but for numbers" in text


def test_what_actuators_report_has_a_section_of_its_own(example: Example, pages: Pages) -> None:
    """Before the remarks, where anything is reported; else the page is without it."""
    late = {"lateness": Estimate(0.66, 0.64, 0.69, "s"), "gain": Estimate(0.9, 0.88, 0.92, "1")}
    told = page(replace(example("consistent"), actuators=(ActuatorReport("boat", "rudder", "angle", late),)))[1]
    assert told.sections == [*SECTIONS[:-2], "actuators", *SECTIONS[-2:]]
    assert "rudder angle 660 ms (640 to 690 ms)" in told.text
    assert pages("consistent")[1].sections == SECTIONS
