"""Files for pixi, Docker, editors and citations say what package.xml, setup.py and the documents say."""

from __future__ import annotations

import json
import re
import subprocess
import sys
import tomllib
from email import message_from_string
from email.message import Message
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import pytest
from ruamel.yaml import YAML

from cocorosim_ros.foundation.installation import DISTRIBUTION

ROOT = Path(__file__).parents[2]
PIXI = tomllib.loads((ROOT / "pixi.toml").read_text("utf-8"))
OWN = {"cocorosim_ros", "cocorosim_msgs"}


@pytest.fixture(scope="module")
def metadata(tmp_path_factory: pytest.TempPathFactory) -> Message:
    """The metadata that setuptools makes of setup.py."""
    folder = tmp_path_factory.mktemp("metadata")
    command = [sys.executable, "setup.py", "-q", "egg_info", "--egg-base", str(folder)]
    subprocess.run(command, cwd=ROOT, check=True, capture_output=True)
    return message_from_string((folder / "cocorosim.egg-info" / "PKG-INFO").read_text("utf-8"))


def test_pip_knows_it_by_the_name_that_is_told(metadata: Message) -> None:
    """Sentences such as `pip install "cocorosim[view]"` name the distribution that setup.py makes, and its extras."""
    assert metadata["Name"] == DISTRIBUTION == "cocorosim"
    extras = set(metadata.get_all("Provides-Extra", []))
    told = {path: re.findall(r"pip install \S*?(\w+)\[(\w+)\]", path.read_text("utf-8")) for path in speaking()}
    wrong = [(path, found) for path, names in told.items() for found in names if found[0] != DISTRIBUTION]
    assert wrong == []
    assert {extra for names in told.values() for _, extra in names} - extras == set()
    assert any(told.values())


def speaking() -> list[Path]:
    """Pages and sources that may tell how to install something."""
    return [*ROOT.glob("*.md"), *(ROOT / "docs").rglob("*.md"), *(ROOT / "cocorosim_ros").rglob("*.py")]


def requirements(metadata: Message) -> dict[str, str]:
    """Versions by name of what is always needed, as setup.py writes them."""
    always = [line for line in metadata.get_all("Requires-Dist", []) if "extra ==" not in line]
    found = (re.fullmatch(r"([\w.-]+)(.*)", line.replace(" ", "")) for line in always)
    return {match[1].lower(): match[2] or "*" for match in found if match}


def ros_packages(*manifests: str) -> set[str]:
    """The ROS packages that manifests need; keys of rosdep for Python are left out."""
    elements = [part for manifest in manifests for part in ElementTree.parse(ROOT / manifest).getroot()]
    named = {part.text for part in elements if part.tag in ("depend", "exec_depend", "buildtool_depend")}
    return {name for name in named if name and not name.startswith("python3-")} - OWN


def test_pixi_brings_what_is_needed(metadata: Message) -> None:
    """Every ROS package by its name at RoboStack, every Python package with its version, and what builds them."""
    given = dict(PIXI["dependencies"])
    ros = {f"ros-jazzy-{name.replace('_', '-')}" for name in ros_packages("package.xml", "msg_defs/package.xml")}
    assert {name for name in given if name.startswith("ros-")} == ros
    python = requirements(metadata)
    assert {name: version for name, version in given.items() if name in python} == python
    assert set(given) - ros - set(python) == {"python", "colcon-common-extensions", "compilers", "cmake", "ninja"}
    assert given["python"].startswith(metadata["Requires-Python"])


def test_pixi_builds_as_the_documents_do() -> None:
    """Its task is the colcon command of the page."""
    page = (ROOT / "docs/how_to/install.md").read_text("utf-8")
    assert f"python -m {PIXI['tasks']['build']}" in page
    assert PIXI["workspace"]["channels"] == ["robostack-jazzy", "conda-forge"]


def test_the_image_is_made_as_the_documents_say() -> None:
    """Each command for Jazzy stands in the Dockerfile, in that order; the sourcing of the result comes at its end."""
    chapter = (ROOT / "docs/how_to/install.md").read_text("utf-8").split("## On a ROS 2 Jazzy installation")[1]
    lines = re.findall(r"^    (.+)$", chapter.split("others. Then:")[0], re.MULTILINE)
    image = (ROOT / "Dockerfile").read_text("utf-8")
    places = [image.index(line) for line in lines[:-1]]
    assert places == sorted(places) and len(places) == 4
    assert image.rindex(lines[-1].removeprefix(". ")) > places[-1]
    instructions = {line.split()[0] for line in image.splitlines() if line and line[0].isupper()}
    assert instructions == {"FROM", "RUN", "WORKDIR", "COPY", "CMD"}
    assert "FROM ros:jazzy-ros-base" in image


def test_the_editor_finds_the_image() -> None:
    """devcontainer.json is JSON, and its paths lead to the Dockerfile and the tree."""
    folder = ROOT / ".devcontainer"
    build = json.loads((folder / "devcontainer.json").read_text("utf-8"))["build"]
    assert (folder / build["dockerfile"]).resolve() == ROOT / "Dockerfile"
    assert (folder / build["context"]).resolve() == ROOT


def test_the_citation_is_that_of_the_package(metadata: Message) -> None:
    """What the Citation File Format 1.2.0 asks for; version, licence and maintainers are those of setup.py."""
    citation = YAML(typ="safe").load((ROOT / "CITATION.cff").read_text("utf-8"))
    assert citation["cff-version"] == "1.2.0" and citation["message"] and citation["title"]
    (author,) = citation["authors"]
    assert author == {"name": metadata["Maintainer"], "email": metadata["Maintainer-email"]}
    assert (citation["version"], citation["license"]) == (metadata["Version"], metadata["License"] or "Apache-2.0")
    (paper,) = citation["references"]
    assert paper["type"] == "conference-paper" and paper["title"] and paper["authors"]
    assert paper["authors"][0]["family-names"] == "Read" and paper["year"] == 2013


def test_the_paper_cites_what_it_lists() -> None:
    """Each key of the text is in paper.bib, and each of paper.bib in the text."""
    text = (ROOT / "docs/paper/paper.md").read_text("utf-8")
    entries = re.findall(r"^@\w+\{(\w+),", (ROOT / "docs/paper/paper.bib").read_text("utf-8"), re.MULTILINE)
    assert set(re.findall(r"@(\w+)", text)) == set(entries)
    head = YAML(typ="safe").load(text.split("---")[1])
    assert {"title", "tags", "authors", "affiliations", "date", "bibliography"} <= head.keys()
    assert (ROOT / "docs/paper" / head["bibliography"]).is_file()


def report(name: str) -> str:
    """The text of a report of a trial."""
    return (ROOT / "docs" / f"{name}.md").read_text("utf-8")


def counts(name: str, pattern: str) -> list[int]:
    """The numbers of the sentence of a report that a pattern finds."""
    found = re.search(pattern, report(name))
    assert found is not None, f"{name}.md has no '{pattern}'"
    return [int(number) for number in found.groups()]


@pytest.mark.parametrize("document", ["README.md", "docs/paper/paper.md"])
def test_figures_are_those_of_the_reports(document: str) -> None:
    """Each 'so many of so many' that is quoted of the trials follows from their reports."""
    said = re.findall(r"\b(\d+) of (\d+)\b", (ROOT / document).read_text("utf-8"))
    medium = [counts("trial", rf"exact, one medium effect, {noise}% noise \|[^|]*\| (\d+)/(\d+)") for noise in (1, 3)]
    rows = ("false alarm, nothing concealed", "outside the catalogue: flagged", "cannot tell: abstains")
    true = [counts("trial", rf"\| {row} \|[^|]*\| (\d+)/(\d+)") for row in rows]
    true.append([sum(part) for part in zip(*medium, strict=True)])
    tried, right = counts("tampered", r"(\d+) diagnoses: (\d+) right")
    true.append([right, tried])
    altered, named, without = counts("against", r"(\d+) altered: (\d+) right.* (\d+) no diagnosis")
    true.append([named, altered - without])
    assert {(str(right), str(of)) for right, of in true} <= set(said)


def test_claims_are_counted_as_in_their_report() -> None:
    """Reproduced, not reproduced, open: as `cocorosim claims` counts them."""
    pattern = r"In the accurate numerics: (\d+) reproduced, (\d+) not reproduced, (\d+) not decidable"
    yes, no, undecided = counts("claims", pattern)
    readme, paper = ((ROOT / name).read_text("utf-8") for name in ("README.md", "docs/paper/paper.md"))
    assert f"{yes} reproduced, {no} not, {undecided} open" in readme and f"{yes + no + undecided} comparisons" in readme
    assert f"| {yes} | {no} | {undecided} |" in paper


def believed() -> list[str]:
    """The numbered lines of README.md that say what may be believed."""
    part = (ROOT / "README.md").read_text("utf-8").split("## What may be believed\n")[1].split("\n## ")[0]
    return [line for line in part.splitlines() if re.match(r"\d+\. ", line)]


def figures(name: str) -> Any:
    """The figures of a trial."""
    return json.loads((ROOT / "docs" / f"{name}.json").read_text("utf-8"))


def hits(rate: dict[str, Any]) -> str:
    """A rate as `so many of so many`."""
    return f"{rate['hits']} of {rate['of']}"


def summed(rates: list[dict[str, Any]]) -> dict[str, Any]:
    """The rate of all that some rates count."""
    return {key: sum(rate[key] for rate in rates) for key in ("hits", "of")}


def false_alarms(rates: dict[str, Any]) -> dict[str, Any]:
    """The rate of false alarms where nothing is concealed, and where only numbers moved."""
    return summed([rates["false alarm, nothing concealed"], rates["false alarm, recalibration only"]])


def test_what_may_be_believed_is_said_in_ten_lines() -> None:
    """The commits that are told are those of the reports, each of them."""
    lines = believed()
    assert [line.split(".")[0] for line in lines] == [str(number) for number in range(1, 11)]
    newest = [figures(name)["source"]["commit"] for name in ("trial", "trial_families", "trial_rov", "trial_slender")]
    newest += [re.findall(r"at commit `(\w+)`", report(name))[-1] for name in ("against", "tampered", "real")]
    assert set(re.findall(r"`([0-9a-f]{7,})`", "\n".join(lines))) == {commit[:7] for commit in newest}


def test_intervals_of_effects_are_told_beside_all_intervals() -> None:
    """In the sealed trial as shares, in that of families as counts, with names and free runs of the latter."""
    whole, families = figures("trial"), figures("trial_families")
    text = "\n".join(believed())
    covers = [100 * whole["intervals"][name]["rate"] for name in ("coverage", "coverage_of_effects")]
    assert f"{covers[0]:.1f} % of the time (must 92), those of effects alone {covers[1]:.1f} %" in text
    counted = [hits(families["intervals"][name]) for name in ("coverage", "coverage_of_effects")]
    assert f"{counted[0]} times, those of effects alone {counted[1]}" in text
    rates = families["table"]["rates"]
    medium = [rates[f"exact, one medium effect, {noise}% noise"] for noise in (0, 1, 3)]
    named = rates["names told as confirmed that are right, in all recordings"]
    for rate in (summed(medium), false_alarms(rates), named, rates["outside the catalogue: flagged"]):
        assert hits(rate) in text
    assert f"free runs err {families['held_out']['position: augmented / oracle']['median']:.2f} times" in text


def test_figures_of_the_second_vehicle_are_those_of_its_page() -> None:
    """Names, false alarms of both kinds, swinging forces and intervals."""
    rov, text = figures("trial_rov"), believed()[-1].partition(". [40 of a slender AUV]")[0]
    rates = rov["table"]["rates"]
    assert f"right {hits(rates['names told as confirmed that are right, in all recordings'])}, false alarm" in text
    assert f"false alarm {hits(false_alarms(rates))}," in text
    assert f"swinging forces flagged {hits(rates['outside the catalogue: flagged'])}" in text
    counted = [hits(rov["intervals"][name]) for name in ("coverage", "coverage_of_effects")]
    assert f"intervals hold {counted[0]}, those of effects alone {counted[1]}" in text


def test_figures_of_the_third_vehicle_are_those_of_its_page() -> None:
    """One effect, confirmed names, false alarms of both kinds and intervals."""
    slender, text = figures("trial_slender"), believed()[-1].partition(". [40 of a slender AUV]")[2]
    rates = slender["table"]["rates"]
    assert f"one effect {hits(rates['exact, one effect, all sizes'])}," in text
    assert f"*confirmed* {hits(rates['names told as confirmed that are right, in all recordings'])}," in text
    assert f"false alarm {hits(false_alarms(rates))} " in text
    assert f"intervals {hits(slender['intervals']['coverage'])}." in text


def test_figures_of_real_recordings_are_those_of_their_page() -> None:
    """Kept on the other half, errors on unseen recordings, the found model once more, and the hidden wind."""
    text = "\n".join(believed())
    pattern = r"{} effects, both directions: (\d+) of (\d+) keep the sign, (\d+) the size"
    sure, guessed = (counts("real", pattern.format(tier)) for tier in ("confirmed", "suspected"))
    assert f"of {sure[1]} *confirmed* effects {sure[0]} keep their sign and {sure[2]} the size" in text
    assert f"of {guessed[1]} *suspected* ones {guessed[0]} and {guessed[2]}" in text
    rows = re.findall(r"^\| \S+ \| (position|depth|heading) \[.* \| ([\d.]+) \|$", report("real"), re.MULTILINE)
    straight = [float(ratio) for channel, ratio in rows if channel != "heading"]
    turned = [float(ratio) for channel, ratio in rows if channel == "heading"]
    assert f"err {min(straight)} to {max(straight)} times as much as the platform's own in position and depth" in text
    worse = sum(ratio > 1.0 for ratio in turned)
    more = (ROOT / "docs/explanation/what_may_be_believed.md").read_text("utf-8")
    assert f"Of {guessed[1]} suspected effects" in more
    assert f"{guessed[0]} keep their sign and {guessed[2]} the size too" in more
    assert all(f"{ratio:.2f}" in more for ratio in turned if ratio > 1.0)
    assert f"heading in {worse} of {len(turned)} groups, up to {max(turned)} times" in text
    good, of = counts("real", r"the model found in them: `consistent` \| all \| all \| (\d+) of (\d+)")
    again = re.findall(r"^\| (?!recordings)\S+ \| (\w+)[^|]* \| \w+[^|]* \|$", report("real"), re.MULTILINE)
    found = again.count("mismatch") + again.count("recalibrate")
    assert len(again) == of and again.count("consistent") == good
    assert f"nothing more in {good} of {of} groups and something in {found}" in text
    (beside,) = counts("real", r"(\d+) deg beside it")
    assert f"{beside} degrees off the anemometer" in text
    altered, silent = counts("against", r"(\d+) controls.* (\d+) name something")
    assert f"silent {altered - silent} of {altered} times" in text
    (blind,) = counts("against", r"(\d+) cannot be seen")
    assert f"{blind} said to be out of sight" in text
