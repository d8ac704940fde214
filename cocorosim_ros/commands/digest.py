"""`cocorosim digest`: the digest of recordings, and where two of them differ."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import click
from rich.console import Console

from cocorosim_ros.commands.examples import with_examples
from cocorosim_ros.commands.json_output import console_beside, give_json, json_option
from cocorosim_ros.commands.reading_bar import ReadingBar
from cocorosim_ros.commands.terminal import say
from cocorosim_ros.wire.bags.bag_reader import Bag, read_bag, recording_at

if TYPE_CHECKING:
    from cocorosim_ros.wire.bags.digest import Digest

EQUAL, DIFFERENT = 0, 1


class _Digested(NamedTuple):
    """A recording with its digest."""

    bag: Bag
    digest: Digest


@with_examples("cocorosim digest runs/one --topics")
@click.command("digest", short_help="the digest of recordings, and where two of them differ")
@click.argument("bags", nargs=-1, required=True, metavar="BAG [BAG ...]", type=click.Path(path_type=Path))
@click.option("--topics", is_flag=True, help="also count, digest and type of every topic")
@json_option
@click.option("--force", is_flag=True, help="replace a file that is there")
@click.pass_context
def command(ctx: click.Context, /, bags: tuple[Path, ...], topics: bool, json_file: Path | None, force: bool) -> None:
    """Print the digest of each BAG: equal digests mean, topic by topic, equal header stamps and CDR bytes.

    With several, say whether all are equal to the first, or where they first differ.

    Exit status: 0 if they are equal (or one bag was given), 1 if they differ, or if one of them does not hold what it
    held when it was closed; 2 if one cannot be read.
    """
    console = console_beside(json_file, force=force, inputs=map(recording_at, bags))
    with ReadingBar(console) as bar:
        opened = [read_bag(path, bar.watch) for path in bags]
        from cocorosim_ros.wire.bags.comparison import bag_digest

        digests = [bag_digest(bag) for bag in opened]
    pairs = [_Digested(bag, digest) for bag, digest in zip(opened, digests, strict=True)]
    untouched = [_show(console, bag, digest, topics=topics) for bag, digest in pairs]
    differences = [_compare(console, *pairs[0], *pair) for pair in pairs[1:]]
    give_json(console, json_file, _tree(pairs, untouched, differences))
    ctx.exit(EQUAL if all(untouched) and not any(differences) else DIFFERENT)


def _show(console: Console, bag: Bag, digest: Digest, *, topics: bool) -> bool:
    """Print the digest; False if the recording says that it had another one."""
    say(console, f"{digest.hexdigest()}  {bag.path}")
    for line in digest.lines() if topics else []:
        topic, type_name, count, topic_digest = line.split(" ")
        say(console, f"  {topic_digest}  {count:>8}  {topic}  {type_name}")
    from cocorosim_ros.wire.bags.bag_summary import METADATA_NAME

    errors = Console(file=sys.stderr)
    if bag.summary.damage:
        say(errors, bag.summary.damage, "yellow")
    stored = bag.summary.metadata.get(METADATA_NAME, {}).get("digest")
    if stored is None or stored == digest.hexdigest():
        return True
    say(errors, f"{bag.path} had the digest {stored} when it was closed: it was changed or damaged since.", "yellow")
    return False


def _compare(console: Console, first: Bag, digest: Digest, other: Bag, other_digest: Digest) -> list[str]:
    """Say whether two recordings are equal, and where they differ; the sentences about that."""
    from cocorosim_ros.wire.bags.comparison import difference

    if digest.hexdigest() == other_digest.hexdigest():
        say(console, f"{first.path} and {other.path} are equal.")
        return []
    sentences = difference(first, other)
    for sentence in sentences:
        say(console, sentence)
    return sentences


def _tree(pairs: list[_Digested], untouched: list[bool], differences: list[list[str]]) -> dict[str, Any]:
    """Each recording with its topics, and from the second on where it differs from the first."""
    told = [{}, *({"equal": not sentences, "differences": sentences} for sentences in differences)]
    recordings = []
    for (bag, digest), kept, compared in zip(pairs, untouched, told, strict=True):
        rows = [line.split(" ") for line in digest.lines()]
        topics = [
            {"topic": name, "type": kind, "messages": int(count), "digest": hexes} for name, kind, count, hexes in rows
        ]
        facts = {"recording": str(bag.path), "digest": digest.hexdigest(), "as_closed": kept, "topics": topics}
        recordings.append({**facts, **compared})
    return {"recordings": recordings}
