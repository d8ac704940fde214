"""The command line: conceal, verify, score, tamper."""

from __future__ import annotations

import argparse
import json
import sys
import time
from pathlib import Path

from concealer import families, prior
from concealer.conceal import conceal
from concealer.prior import KINDS, Wish
from concealer.seal import LEDGER, broken_seals


def _conceal(options: argparse.Namespace) -> int:
    effects = tuple(options.effects.split(",")) if options.effects else ()
    kind = options.kind or (("several" if len(effects) > 1 else "single") if effects else None)
    wish = Wish(kind, effects, options.size, options.noise, options.robots, options.manoeuvre, options.duration)
    numbers = prior.load(options.prior)
    if options.families:
        numbers["families"] = families.table_of(options.families)
    if options.formed:
        formed = numbers["families"]["forms_of"]
        numbers["effects"] = {name: spec for name, spec in numbers["effects"].items() if name in formed}
    indices = range(options.first, options.first + options.count)
    begun = time.monotonic()
    for name in conceal(options.out, numbers, options.seed, indices, wish, options.jobs):
        print(f"{name}  {time.monotonic() - begun:.1f} s", flush=True)
    return 0


def _families(options: argparse.Namespace) -> int:
    table = families.table_of(options.word)
    print(json.dumps({"sha256": families.digest(table), "table": table}, indent=1))
    return 0


def _verify(options: argparse.Namespace) -> int:
    faults = broken_seals(options.trial / LEDGER, options.trial / "envelopes", options.trial / "recordings")
    print("\n".join(faults) or "all seals hold")
    return 1 if faults else 0


def _score(options: argparse.Namespace) -> int:
    from concealer.score import score_trial

    tried = options.tried.read_text(encoding="utf-8").split() if options.tried else None
    text = score_trial(options.trial, options.diagnoses, options.out, options.window, tried)
    print(text)
    return 0


def _tamper(options: argparse.Namespace) -> int:
    from concealer.tamper import tamper

    print(tamper(options.bag, options.out, options.how, options.amount, options.robot))
    return 0


def parser() -> argparse.ArgumentParser:
    """The parser of the command line."""
    main_parser = argparse.ArgumentParser(prog="concealer", description=__doc__)
    commands = main_parser.add_subparsers(required=True)
    one = commands.add_parser("conceal", help="write recordings in which something is concealed, and seal what")
    one.add_argument("--seed", type=int, required=True)
    one.add_argument("--count", type=int, required=True)
    one.add_argument("--out", type=Path, required=True)
    one.add_argument("--first", type=int, default=0, help="number of the first recording")
    one.add_argument("--jobs", type=int, default=1)
    one.add_argument("--prior", type=Path, default=prior.PRIOR)
    one.add_argument("--kind", choices=KINDS, help="instead of the prior's composition")
    one.add_argument("--effects", help="instead of drawn ones, separated by commas")
    one.add_argument("--size", type=float, help="fraction of large, instead of drawn")
    one.add_argument("--noise", type=float, help="rms of random forces as a fraction of full thrust")
    one.add_argument("--robots", type=int)
    one.add_argument("--manoeuvre")
    one.add_argument("--duration", type=float, help="s")
    one.add_argument(
        "--families", default="", help="public word that gives the numbers of sealed families; none if left out"
    )
    one.set_defaults(run=_conceal)
    one.add_argument("--formed", action="store_true", help="with --families: only effects whose form is drawn")
    table = commands.add_parser("families", help="the table of families that a public word gives, and its hash")
    table.add_argument("word")
    table.set_defaults(run=_families)
    two = commands.add_parser("verify", help="check envelopes and recordings against the ledger")
    two.add_argument("trial", type=Path)
    two.set_defaults(run=_verify)
    three = commands.add_parser("score", help="compare diagnoses with envelopes")
    three.add_argument("trial", type=Path)
    three.add_argument("diagnoses", type=Path, help="folder with NAME/diagnosis.json or NAME.json")
    three.add_argument("--out", type=Path, required=True, help="new folder for scores.json and scores.md")
    three.add_argument("--window", type=float, default=20.0, help="length of the tool's free runs [s]")
    three.add_argument(
        "--tried", type=Path, help="file with the names of the recordings that the tool was given; all if left out"
    )
    three.set_defaults(run=_score)
    four = commands.add_parser("tamper", help="alter the logs of a recording in a known way")
    four.add_argument("bag", type=Path)
    four.add_argument("--how", required=True)
    four.add_argument("--amount", type=float, required=True)
    four.add_argument("--robot", help="namespace; the first one if left out")
    four.add_argument("--out", type=Path, required=True)
    four.set_defaults(run=_tamper)
    return main_parser


def main(arguments: list[str]) -> int:
    """Exit status of the command line: 0, or 2 with one sentence if the input is unusable."""
    options = parser().parse_args(arguments)
    try:
        return int(options.run(options))
    except (OSError, ValueError, KeyError) as error:
        print(f"concealer: {error}", file=sys.stderr)
        return 2
