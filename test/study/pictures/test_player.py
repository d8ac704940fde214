"""The page that plays a recording: it holds what was recorded, and its script shows it at the right moment."""

from __future__ import annotations

import base64
import html
import json
import math
import re
import shutil
import subprocess
from collections.abc import Callable
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from matplotlib.image import imread

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.study.metrics import COLUMN, METRICS
from cocorosim_ros.study.pictures import player
from cocorosim_ros.study.pictures.facts import MetricSeries, ScenarioFacts
from cocorosim_ros.study.pictures.player import page_pieces
from cocorosim_ros.world.state.pose_track import PoseTrack

SECOND = 1_000_000_000
FACTS = ScenarioFacts(
    "two fish", 7, (-3.0, -3.0, -2.0), (3.0, 3.0, 0.0), ((1.0, 0.0, -1.0, 0.5),), ((-1.0, -1.0, -2.0, 0.0, 0.0, -1.0),)
)
NODE = shutil.which("node")
CURVES = ["polarisation", "angular_momentum", "shoal_speed", "separation", "lost", "shoals"]
STAGE = """
const held = {};
const nothing = () => undefined;
const pen = new Proxy({}, {get: () => nothing, set: () => true});
function make(text) {
  const children = [];
  return {textContent: text, style: {}, children, append: (child) => children.push(child), value: "30",
          classList: {toggle: nothing}, getContext: () => pen, setAttribute: nothing};
}
const root = {clientWidth: 1000, dataset: {}};
globalThis.document = {getElementById: (id) => held[id] ??= make(""), createElement: () => make(""),
                       documentElement: root};
globalThis.window = {innerHeight: 900, matchMedia: () => ({addEventListener: nothing})};
globalThis.getComputedStyle = () => ({getPropertyValue: () => "#123456"});
globalThis.location = {hash: "#t=1"};
globalThis.requestAnimationFrame = nothing;
held.recording = make(%s);
"""


def track(seconds: Any, position: Any, yaw: Any) -> PoseTrack:
    """Poses of one robot that starts 5 s after the epoch."""
    stamps = np.round((np.asarray(seconds) + 5.0) * SECOND).astype(np.int64)
    return PoseTrack(stamps, np.asarray(position, dtype=float).reshape(-1, 3), np.asarray(yaw, dtype=float))


@pytest.fixture
def two() -> dict[str, PoseTrack]:
    """One that swims east and turns through pi, and one of which nothing is known from 2 s to 10 s."""
    swimmer = track([0, 1, 2], [[0, 0, -1], [1, 0, -1], [2, 0.5, -1.5]], [3.0, -3.0, -3.0])
    diver = track([1, 2, 10, 11], [[0, 0, -1], [0, 0, -1.2], [0, 0, -1.8], [0, 0, -2]], [0, 0, math.nan, 0])
    return {"swimmer": swimmer, "diver": diver}


class _Scripts(HTMLParser):
    """The contents of all script elements, as a browser would cut them."""

    def __init__(self) -> None:
        super().__init__()
        self.found: list[str] = []
        self._inside = False

    def handle_starttag(self, tag: str, attrs: Any) -> None:
        self._inside = tag == "script"
        self.found += [""] * self._inside

    def handle_endtag(self, tag: str) -> None:
        self._inside = False

    def handle_data(self, data: str) -> None:
        if self._inside:
            self.found[-1] += data


def scripts(page: str) -> tuple[dict[str, Any], str]:
    """The recording in a page, and its script."""
    parser = _Scripts()
    parser.feed(page)
    data, code = parser.found
    return json.loads(data), code


def player_page(*given: Any) -> str:
    """The whole page."""
    return "".join(page_pieces(*given))


def floats(text: str) -> Any:
    """Little-endian float32 in base64."""
    return np.frombuffer(base64.b64decode(text), "<f4")


def test_it_holds_every_pose_at_its_time(two: dict[str, PoseTrack]) -> None:
    """Times count from the first pose of all; numbers are those of the tracks, as exact as float32 is."""
    held, _ = scripts(player_page(two, FACTS, ["It ends early."]))
    assert [robot["name"] for robot in held["robots"]] == ["diver", "swimmer"]
    assert held["seconds"] == 11.0
    for robot in held["robots"]:
        given = two[robot["name"]]
        np.testing.assert_allclose(floats(held["clocks"][robot["clock"]]), given.stamp_ns / SECOND - 5.0, rtol=1e-6)
        poses = floats(robot["poses"]).reshape(-1, 4)
        np.testing.assert_allclose(poses, np.column_stack([given.position, given.yaw]), rtol=1e-6)
    assert held["tank"] == [[-3, -3, -2], [3, 3, 0]]
    assert held["spheres"] == [[1, 0, -1, 0.5]]
    assert held["boxes"] == [[-1, -1, -2, 0, 0, -1]]
    assert held["findings"] == ["It ends early."]
    assert held["seed"] == 7


def test_one_clock_is_held_once() -> None:
    """Robots of a simulation share their stamps, and the page shares them too."""
    times = np.arange(10.0)
    many = {f"fish_{number}": track(times, np.full((10, 3), number), times) for number in range(5)}
    held, _ = scripts(player_page(many, FACTS))
    assert len(held["clocks"]) == 1
    assert len({robot["colour"] for robot in held["robots"]}) == 5


def test_it_loads_nothing_and_names_cannot_break_out(two: dict[str, PoseTrack]) -> None:
    """No address is in the page; a name that looks like a tag is text."""
    name = "</script><img src=x onerror=alert(1)>"
    page = player_page({name: two["diver"]}, ScenarioFacts(name), [name])
    assert not re.search(r"(src|href)=[\"']|://", page)
    assert "<img" not in page
    held, _ = scripts(page)
    assert held["robots"][0]["name"] == held["name"] == name
    assert held["tank"] is None


def test_long_tracks_are_thinned_which_is_said(two: dict[str, PoseTrack], monkeypatch: pytest.MonkeyPatch) -> None:
    """Of 1000 poses where 100 are let through every tenth is left, and the last one."""
    monkeypatch.setattr(player, "MOST_POSES", 100)
    long = track(np.arange(1000.0), np.zeros((1000, 3)), np.zeros(1000))
    held, _ = scripts(player_page({"fish": long}, FACTS))
    assert floats(held["clocks"][0]).tolist() == [*range(0, 1000, 10), 999]
    assert held["findings"] == ["Of long tracks only every 10th pose is shown."]


def test_nothing_to_look_at() -> None:
    """A sentence."""
    with pytest.raises(CocorosimError, match="two fish has no poses"):
        player_page({"fish": track([], [], [])}, FACTS)


@pytest.mark.skipif(NODE is None, reason="node is not installed, so the page's script cannot be run")
def test_the_script_shows_each_robot_at_its_place(two: dict[str, PoseTrack]) -> None:
    """Half-way between poses it is half-way, over the short side of a turn; before its start and in gaps absent."""
    held, code = scripts(player_page(two, FACTS))
    asked = [("swimmer", 0.0), ("swimmer", 0.5), ("swimmer", 2.5), ("swimmer", 9.0)]
    asked += [("diver", 0.5), ("diver", 1.5), ("diver", 5.0), ("diver", 10.0)]
    question = f"console.log(JSON.stringify({json.dumps(asked)}.map(([name, t]) => "
    question += "poseAt(robots.find((robot) => robot.name === name), t))))"
    program = STAGE % json.dumps(json.dumps(held)) + code + question
    done = subprocess.run([str(NODE), "-e", program], capture_output=True, text=True, timeout=120, check=False)
    assert done.returncode == 0, done.stderr
    found = json.loads(done.stdout)
    half_turn = 3.0 + (2 * math.pi - 6.0) / 2
    expected = [[0, 0, -1, 3], [0.5, 0, -1, half_turn], [2, 0.5, -1.5, -3], None, None, [0, 0, -1.1, 0], None]
    for pose, wanted in zip(found[:-1], expected, strict=True):
        assert pose == (None if wanted is None else pytest.approx(wanted, abs=1e-6))
    assert found[-1][:3] == pytest.approx([0, 0, -1.8], abs=1e-6)
    assert found[-1][3] is None, "JSON's word for NaN: the heading is not known"


def series_of_10_moments() -> MetricSeries:
    """Metrics at 5 s, 6 s, ... 14 s: column c is 0.01 c at first and grows by 0.1 a moment; separation has a hole."""
    values = 0.01 * np.arange(len(METRICS)) + 0.1 * np.arange(10)[:, None]
    values[4, COLUMN["separation"]] = math.nan
    return MetricSeries((np.arange(10) + 5) * SECOND, values)


def test_the_paper_s_metrics_are_curves(two: dict[str, PoseTrack]) -> None:
    """Six of them, on the clock of the poses, with unit and hole; a page without metrics has none."""
    held, _ = scripts(player_page(two, FACTS, (), series_of_10_moments()))
    assert sorted(curve["name"] for curve in held["curves"]) == sorted(CURVES)
    for curve in held["curves"]:
        expected = 0.01 * COLUMN[curve["name"]] + 0.1 * np.arange(10)
        if curve["name"] == "separation":
            expected[4] = math.nan
        np.testing.assert_allclose(floats(curve["time"]), np.arange(10.0), rtol=1e-6)
        for part in ("low", "mean", "high"):
            np.testing.assert_allclose(floats(curve[part]), expected, rtol=1e-6)
        assert curve["top"] >= np.nanmax(expected) or curve["name"] in ("polarisation", "angular_momentum")
    units = {curve["name"]: curve["unit"] for curve in held["curves"]}
    assert (units["separation"], units["shoal_speed"], units["shoals"]) == ("m", "m/s", "1")
    assert scripts(player_page(two, FACTS))[0]["curves"] == []


def test_long_series_are_grouped_and_lose_no_extreme(two: dict[str, PoseTrack]) -> None:
    """One moment of 100 000 at which the metric is high stays in the picture."""
    values = np.zeros((100_000, len(METRICS)))
    values[77_777] = 0.9
    held, _ = scripts(player_page(two, FACTS, (), MetricSeries(np.arange(100_000) * SECOND, values)))
    for curve in held["curves"]:
        assert len(floats(curve["time"])) <= 1200
        assert floats(curve["high"]).max() == pytest.approx(0.9)


def test_it_follows_the_reader_s_choice_of_dark_pages(two: dict[str, PoseTrack]) -> None:
    """Every colour that the light page defines is defined for the dark one, too."""
    page = player_page(two, FACTS)
    light, dark = re.findall(r":root \{(.*?)\}", page, re.DOTALL)
    assert "prefers-color-scheme: dark" in page
    assert set(re.findall(r"--[a-z]+", light)) == set(re.findall(r"--[a-z]+", dark))


def test_every_key_that_works_is_explained(two: dict[str, PoseTrack]) -> None:
    """The keys in the table of the script are those in the words of the page."""
    page = player_page(two, FACTS)
    table = page[page.index("const KEYS = {") : page.index("document.onkeydown")]
    keys = set(re.findall(r'^ *"?([^\s"]+?)"?: ', table, re.MULTILINE)) | set(re.findall(r', "?([^\s"]+?)"?: ', table))
    words = {"ArrowLeft": "←", "ArrowRight": "→", "ArrowUp": "↑", "ArrowDown": "↓", "Escape": "Esc"}
    explained = set(re.findall("<kbd>(.*?)</kbd>", page)) - {"space", "shift"}
    assert {words.get(key, key) for key in keys} - {"="} == explained


def test_a_label_without_room_leaves_its_unit_to_the_value(
    two: dict[str, PoseTrack], tmp_path: Path, browse: Callable[..., str]
) -> None:
    """On a narrow page label and value stand side by side: the unit, which the value has as well, gives way."""
    labels = "(curve) => [labelWithin(curve, 900), labelWithin(curve, 90)]"
    asked = f'JSON.stringify(curves.filter((curve) => curve.name === "shoal_speed").map({labels}))'
    page = tmp_path / "page.html"
    text = player_page(two, FACTS, (), series_of_10_moments())
    page.write_text(text.replace("</body>", f"<script>document.body.dataset.said = {asked};</script></body>"), "utf-8")
    said = re.search('data-said="(.*?)"', browse(page))
    assert said is not None
    assert json.loads(html.unescape(said[1])) == [["Shoal speed [m/s]", "Shoal speed"]]


def test_a_browser_runs_the_page_to_its_end(
    two: dict[str, PoseTrack], tmp_path: Path, browse: Callable[..., str]
) -> None:
    """Robots, six curves and the moment of the address are there when all scripts have run, and the page is drawn."""
    page = tmp_path / "page.html"
    page.write_text(player_page(two, FACTS, (), series_of_10_moments()), "utf-8")
    shown = browse(page, "#t=1.5", tmp_path / "page.png")
    assert 'data-shown="yes"' in shown
    assert "1.5 of 11.0 s" in shown
    assert len(re.findall('<canvas aria-label="[a-z_]+ over time"', shown)) == 6
    assert re.findall(r"<li [^>]*>(\w+)</li>", shown) == ["diver", "swimmer"]
    assert len(np.unique(imread(tmp_path / "page.png").reshape(-1, 4), axis=0)) > 10  # colours: it is not blank
