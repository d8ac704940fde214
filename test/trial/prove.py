"""Proof that `cocorosim diagnose` keeps its word.

`prove.py sealed | families | rov | slender | tampered | real | against | fleet`; `prove.py weights` fits the weights of
its probabilities, `prove.py real-page` writes the page of `real` again.
"""

from __future__ import annotations

import argparse
import json
import math
import shlex
import sys
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any

FOLDER = str(Path(__file__).resolve().parents[1])
if FOLDER not in sys.path:
    sys.path.append(FOLDER)

from trial.examiner import Terms  # noqa: E402
from trial.parts import VEHICLES, Part  # noqa: E402


def terms_of(options: argparse.Namespace) -> Terms:
    """How the command line wants diagnoses to be run."""
    return Terms(options.jobs, options.limit, options.minutes, options.reports)


def _command(options: argparse.Namespace) -> str:
    """The command line; where the recordings lie is nobody else's concern."""
    words = ["FOLDER" if word == str(getattr(options, "data", "")) else shlex.quote(word) for word in sys.argv[1:]]
    return " ".join(["prove.py", *words])


def _sets(options: argparse.Namespace) -> list[str]:
    """Folders of the data sets that the command line asks for; all if none."""
    return options.sets.split(",") if options.sets else []


def _seeded(options: argparse.Namespace) -> dict[str, Any]:
    """Provenance of a trial, with the seed of a public word. Raises ValueError if there is none."""
    from trial.provenance import note, noted, seed_of

    source = noted(options.out, _command(options))
    if "seed" not in source:
        word = options.seed_word or source["commit"]
        if not word:
            raise ValueError("there is no commit to take the seed from; give a public word with --seed-word")
        source |= {"seed_word": word, "seed": seed_of(word)}
    note(options.out, source)
    return source


def _sealed(options: argparse.Namespace) -> int:
    from trial.parts import parts

    source = _seeded(options)
    return _trial(options, source, parts(options.count, options.parts.split(",") if options.parts else []), {})


def _families(options: argparse.Namespace) -> int:
    from concealer import families
    from trial.parts import families_parts
    from trial.provenance import note

    source = _seeded(options)
    table = families.table_of(source["seed_word"])
    source["families"] = families.digest(table)
    print(f"families: {source['families']}", flush=True)
    note(options.out, source)
    parts = families_parts(options.count, source["seed_word"])
    return _trial(options, source, parts, {"families_table": table}, "trial_families")


def _vehicle(options: argparse.Namespace) -> int:
    from trial.parts import vehicle_parts

    parts = vehicle_parts(options.vehicle, options.count)
    return _trial(options, _seeded(options), parts, {}, f"trial_{options.vehicle}")


def _trial(
    options: argparse.Namespace, source: dict[str, Any], parts: list[Part], facts: dict[str, Any], name: str = "trial"
) -> int:
    """Makes, seals, diagnoses, opens and scores parts of a trial, and writes the page of this name and its figures."""
    from trial import sealed
    from trial.provenance import note
    from trial.sealed_text import page

    folders = [sealed.conceal(options.out, part, source["seed"], options.jobs) for part in parts]
    source["ledgers"] = sealed.digests(folders)
    print(json.dumps(source["ledgers"]), flush=True)
    note(options.out, source)
    made = zip(parts, folders, strict=True)
    todo = sealed.shuffled_evenly([sealed.tasks(options.out, folder, part.platform) for part, folder in made])
    terms = terms_of(options)
    if options.warm:
        terms = replace(terms, warm_up=sealed.short_diagnosis(options.out, parts[0]))
    outcomes = sealed.diagnose(todo, terms)
    source["recordings"], source["tried"] = len(todo), len(outcomes)
    score = sealed.score(options.out, outcomes, options.window)
    text = page(score, source, outcomes, name)
    options.pages.mkdir(parents=True, exist_ok=True)
    (options.pages / f"{name}.md").write_text(text, encoding="utf-8")
    if score["figures"]["probabilities"]:
        from trial.reliability_picture import draw

        picture = "reliability.svg" if name == "trial" else f"reliability_{name}.svg"
        draw(score["figures"]["probabilities"], options.pages / picture)
    facts |= {"source": source, "outcomes": [asdict(o) for o in sorted(outcomes, key=lambda o: o.name)]}
    told = json.dumps(facts | score["figures"], indent=1) + "\n"
    (options.pages / f"{name}.json").write_text(told, encoding="utf-8")
    print(text)
    return 0


def _weights(options: argparse.Namespace) -> int:
    from trial.weights import prove

    return prove(options.out, options.pages)


def _tampered(options: argparse.Namespace) -> int:
    from trial.provenance import noted
    from trial.tampered import prove

    return prove(options.data, options.out, options.pages, terms_of(options), noted(options.out, _command(options)))


def _real(options: argparse.Namespace) -> int:
    from trial.provenance import noted
    from trial.real import prove

    source = noted(options.out, _command(options))
    return prove(options.data, options.out, options.pages, terms_of(options), source, _sets(options))


def _real_page(options: argparse.Namespace) -> int:
    from trial.real_page import write_page

    write_page(options.pages)
    return 0


def _against(options: argparse.Namespace) -> int:
    from trial.against import prove
    from trial.provenance import note, noted, seed_of

    source = noted(options.out, _command(options))
    word = source.setdefault("seed_word", options.seed_word or source["commit"])
    source |= {"seed": seed_of(word), "count": options.count, "sets": _sets(options)}
    note(options.out, source)
    return prove(options.data, options.out, options.pages, terms_of(options), source)


def _fleet(options: argparse.Namespace) -> int:
    from concealer.fleet import FleetPlan
    from trial.fleet import prove
    from trial.provenance import note, noted, seed_of

    source = noted(options.out, _command(options))
    word = source.setdefault("seed_word", options.seed_word or source["commit"])
    source |= {"seed": seed_of(word)}
    note(options.out, source)
    plan = FleetPlan(source["seed"], options.robots, options.weeks, options.loser, options.loss)
    return prove(plan, options.out, options.pages, options.jobs, source)


def parser() -> argparse.ArgumentParser:
    """The parser of the command line."""
    whole = argparse.ArgumentParser(prog="prove.py", description=__doc__)
    commands = whole.add_subparsers(required=True)
    common = argparse.ArgumentParser(add_help=False)
    common.add_argument("--out", type=Path, required=True, help="folder for recordings and diagnoses; resumed if there")
    common.add_argument("--pages", type=Path, required=True, help="folder for the tables")
    common.add_argument("--jobs", type=int, default=2)
    common.add_argument("--limit", type=float, default=120.0, help="time for one diagnosis [s]")
    common.add_argument("--minutes", type=float, default=math.inf, help="after which no diagnosis is begun")
    common.add_argument("--reports", action="store_true", help="keep report.html of every diagnosis")
    concealed = argparse.ArgumentParser(add_help=False)
    concealed.add_argument("--count", type=int, default=400, help="recordings of the main part")
    concealed.add_argument("--seed-word", default="", help="public word that gives the seed; the commit if left out")
    concealed.add_argument(
        "--warm", action="store_true", help="load the tool once for each job instead of once for each recording"
    )
    concealed.add_argument("--window", type=float, default=20.0, help="length of the tool's free runs [s]")
    one = commands.add_parser("sealed", parents=[common, concealed], help="concealed effects")
    one.add_argument("--parts", default="", help="main, nothing, recalibration, medium_1, medium_3; all if left out")
    one.set_defaults(run=_sealed)
    two = commands.add_parser("families", parents=[common, concealed], help="concealed effects in forms of families")
    two.set_defaults(run=_families)
    for name, words in VEHICLES.items():
        made = commands.add_parser(name, parents=[common, concealed], help=words)
        made.set_defaults(run=_vehicle, vehicle=name)
    for name, run, words in (("tampered", _tampered, "altered logs"), ("real", _real, "recordings as they are")):
        other = commands.add_parser(name, parents=[common], help=f"real recordings: {words}")
        other.add_argument("--data", type=Path, required=True, help="folder with the data sets, each in its own folder")
        other.add_argument("--sets", default="", help="real: folders of the data sets, by commas; all if left out")
        other.set_defaults(run=run)
    again = commands.add_parser("real-page", help="write real.md of real.json and against.json; nothing is diagnosed")
    again.add_argument("--pages", type=Path, required=True, help="folder of the figures, and for the page")
    again.set_defaults(run=_real_page)
    three = commands.add_parser("weights", help="fit the weights of probabilities to what `sealed` left in a folder")
    three.add_argument("--out", type=Path, required=True, help="folder of `sealed`")
    three.add_argument("--pages", type=Path, help="folder for the reliability diagram and the figures of the weights")
    three.set_defaults(run=_weights)
    four = commands.add_parser("against", parents=[common], help="altered logs against unaltered ones")
    four.add_argument("--data", type=Path, required=True, help="folder with the data sets, each in its own folder")
    four.add_argument("--count", type=int, default=200, help="altered logs, beside a control for each group")
    four.add_argument("--sets", default="", help="folders of the data sets, by commas; all if left out")
    four.add_argument("--seed-word", default="", help="public word that gives the seed; the commit if left out")
    four.set_defaults(run=_against)
    five = commands.add_parser("fleet", parents=[common], help="a fleet over weeks, one robot of which loses thrust")
    five.add_argument("--robots", type=int, default=50)
    five.add_argument("--weeks", type=int, default=10, help="recordings of each robot, one a week")
    five.add_argument("--loser", type=int, default=6, help="number of the robot that loses thrust, from 0 on")
    five.add_argument("--loss", type=float, default=0.01, help="share of the thrust lost a week")
    five.add_argument("--seed-word", default="", help="public word that gives the seed; the commit if left out")
    five.set_defaults(run=_fleet)
    return whole


if __name__ == "__main__":
    arguments = parser().parse_args()
    sys.exit(arguments.run(arguments))
