"""Families of forms: members by a public word, forms and laws of the grammar by hand, earlier seeds as they were."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.special import beta

# Kind and last place (x, y, z, yaw) of the first robot, of numbers of seed 60 over a minute.
BEFORE = {
    3: ("several", [0.8343606595499702, -0.5656623117277837, -0.4280171393854, -14.556435472273082]),
    4: ("several", [0.6345322528118464, 0.16160661352663194, -0.47820719771056264, -4.931533169887429]),
    5: ("recalibration", [-0.2541332161844001, -0.977793885654419, -0.5528776001662145, 11.240731320681755]),
    7: ("several", [0.1034143564970449, -0.8152955552110218, -1.689178299272671, -17.033983427411215]),
}

# Effects that came into the prior after those numbers were taken.
LATER = {
    "density_gradient", "surface_loss", "speed_log_scale", "speed_log_misalignment", "pose_heading", "pose_lever",
    "motor_field", "surface_waves",
}  # fmt: skip


@pytest.fixture(scope="module")
def table() -> dict[str, Any]:
    """The table of families of a word."""
    from concealer.families import table_of

    return table_of("a word")


def test_earlier_seeds_move_as_they_did(numbers: dict[str, Any]) -> None:
    """Without families a seed draws and moves what it did before there were any: numbers of the version before."""
    from concealer.prior import Wish, draw
    from concealer.recording import move, stage

    assert set(numbers["effects"]) >= LATER
    numbers = numbers | {"effects": {key: each for key, each in numbers["effects"].items() if key not in LATER}}
    for index, (kind, place) in BEFORE.items():
        plotting, hiding, moving, _ = np.random.default_rng([60, index]).spawn(4)
        plot = draw(plotting, numbers, Wish(duration=60.0))
        rows, _ = move(moving, plot, stage(hiding, numbers, plot)[0])
        assert plot.kind == kind
        assert rows[-1, 0, :4] == pytest.approx(place, rel=1e-6)


def test_a_word_gives_the_numbers_of_sealed_members_alone(table: dict[str, Any]) -> None:
    """The same word gives the same table and hash; another word other sealed numbers, in their ranges, alone."""
    from concealer.families import DRAWN, digest, table_of

    other = table_of("another word")
    assert digest(table_of("a word")) == digest(table) != digest(other)
    for family in DRAWN:
        for name, numbers in table[family].items():
            assert (numbers == other[family][name]) == (not numbers["sealed"]), name
    widths = [table["forms"][f"saturating_{k}"]["width"] for k in (1, 2)]
    assert all(0.8 <= width <= 2.5 for width in widths) and widths[0] != widths[1]
    with pytest.raises(ValueError, match="public word"):
        table_of("")


@pytest.mark.parametrize(
    ("kind", "number", "force", "expected"),
    [
        ("plain", 0.0, 3.0, 3.0),
        ("smooth", 2.0, -3.0, -9.0 / 5.0),  # scale 2: sqrt(9 + 16)
        ("saturating", 1.5, 3.0, 3.0 * math.tanh(1.0)),
        ("fractional", 0.5, -8.0, -4.0),  # 2 sqrt(8 / 2)
        ("hysteretic", 0.2, 3.0, 2.5),  # what is remembered
        ("placed", 0.5, 3.0, 4.5),  # x = 0.25 m of a wave of 1 m
    ],
)
def test_a_form_by_hand(kind: str, number: float, force: float, expected: float) -> None:
    """g(F) of each form, for the scale 2."""
    from concealer import layout as at
    from concealer.forms import ALONG_X, KINDS, NUMBER, shaped

    form, s = np.zeros(10), np.zeros(at.STATE)
    form[0], form[NUMBER], form[ALONG_X] = KINDS[kind], number, 2.0 * math.pi
    s[at.X] = 0.25
    assert shaped(form, force, 2.0, s, 2.5) == pytest.approx(expected)


def _wide(**places: float) -> Any:
    """(WIDE,) a robot with one block, in which the law has these numbers, in its plain form."""
    from concealer import layout as at
    from concealer.forms import BLOCK, GAIN, KINDS, SCALE_X, WIDE

    p = np.zeros(WIDE)
    p[: at.SIZE] = p[at.SIZE : 2 * at.SIZE] = at.nominal_robot()
    for name, value in places.items():
        p[at.SIZE + getattr(at, name.upper())] = value
    form = p[2 * at.SIZE : at.SIZE + BLOCK]
    form[0], form[GAIN], form[SCALE_X : SCALE_X + 4] = KINDS["plain"], 1.0, 1.0
    return p


def test_a_plain_block_is_the_law_itself(run: Any) -> None:
    """A robot whose drag is in a block moves as one that has it among its own numbers."""
    from concealer import layout as at
    from concealer.physics import replay, still

    own, wide = at.nominal_robot(), _wide(linear_surge=0.02, linear_yaw=1e-4)
    own[[at.LINEAR_SURGE, at.LINEAR_YAW]] = 0.02, 1e-4
    commands, start = np.tile([0.8, 0.4, 0.01], (200, 1, 1)), np.zeros((1, at.STATE))
    start[0, at.Z] = -1.0
    one, two = (replay(p[None], start, commands, still(1, 200), 0) for p in (own, wide))
    assert np.abs(one[-1, 0, at.U]) > 0.01
    assert np.allclose(one, two, rtol=1e-9, atol=1e-12)


def test_a_play_operator_stops_where_the_force_turns() -> None:
    """Of a force that went up to 3 and back to 2.6, half a width of 0.5 remembers 2.5; back to 1.9, 2.4."""
    from concealer import layout as at
    from concealer.forms import BLOCK, KINDS, NUMBER, remember

    p, s = _wide(trim=3.0), np.zeros(at.STATE)
    form, trim = p[2 * at.SIZE : at.SIZE + BLOCK], at.SIZE + at.TRIM
    form[0], form[NUMBER] = KINDS["hysteretic"], 1.0
    for force, expected in ((3.0, 2.5), (2.6, 2.5), (1.9, 2.4), (2.2, 2.4)):
        p[trim] = force
        remember(p, s, np.zeros(3), 0.0)
        assert s[at.MEMORY + 2] == pytest.approx(expected)


def test_the_nearest_drag_of_a_fractional_one_is_a_quotient_of_beta_functions() -> None:
    """Over a swing u = U sin, c |u/U|^q U is nearest to c B(q/2 + 1, 1/2) / B(3/2, 1/2) u, by least squares."""
    from concealer import layout as at
    from concealer.forms import BLOCK, KINDS, NUMBER, SCALE_X
    from concealer.nearest import fit_gain, nearest

    p, rows, power = _wide(linear_surge=0.02), np.zeros((20001, at.ROW)), 0.6
    rows[:, at.U] = 0.05 * np.sin(2.0 * np.pi * np.arange(20001) / 2000.0)
    form = p[2 * at.SIZE : at.SIZE + BLOCK]
    form[0], form[NUMBER], form[SCALE_X] = KINDS["fractional"], power, 0.02 * 0.05
    commands, quotient = np.zeros((4000, 3)), beta(0.5 * power + 1.0, 0.5) / beta(1.5, 0.5)
    found, left = nearest("linear_drag", p, rows, commands, 0)
    assert found == {"surge": pytest.approx(0.02 * quotient, rel=1e-4)}
    alone = 1.0 - quotient**2 * beta(1.5, 0.5) / beta(power + 0.5, 0.5)
    assert left == pytest.approx(math.sqrt(alone), rel=1e-3)
    assert fit_gain(p, rows, commands, 0) == pytest.approx(1.0 / quotient, rel=1e-4)


def test_a_force_that_is_never_felt_keeps_its_numbers() -> None:
    """A loss in reverse of a robot that never goes backwards: nothing to fit, a gain of 1."""
    from concealer import layout as at
    from concealer.forms import BLOCK, KINDS, NUMBER
    from concealer.nearest import fit_gain, nearest

    p, rows, commands = _wide(reverse_loss=0.1), np.zeros((501, at.ROW)), np.full((100, 3), 0.5)
    form = p[2 * at.SIZE : at.SIZE + BLOCK]
    form[0], form[NUMBER] = KINDS["saturating"], 1.5
    assert fit_gain(p, rows, commands, 0) == 1.0
    assert nearest("reverse_loss", p, rows, commands, 0) == ({}, 0.0)


def test_laws_of_the_grammar_are_new_and_are_what_their_names_say(table: dict[str, Any]) -> None:
    """Names are read as laws, none is one of the table; the force is the product that the name says, over scales."""
    from concealer import layout as at
    from concealer.forms import product
    from concealer.grammar import KNOWN, draw
    from concealer.laws import law

    rng, names = np.random.default_rng(3), set()
    for _ in range(200):
        names.add(draw(rng, table["grammar"])[1].id)
    assert len(names) > 60
    assert all(law(name) for name in names)
    assert not {law(name) for name in names} & {law(f"unknown:{name}") for name in KNOWN}
    numbers, s = np.zeros(11), np.zeros(at.STATE)
    numbers[:3], numbers[3:7], numbers[7:11] = (3.0, 1.0, 0.0), (1, 0.05, 1.5, 1.0), (7, 1.0, 2.0, 0.0)
    s[at.Z] = -1.5
    assert product(numbers, s, np.zeros(3), (-0.1, 0.0), 0.0) == pytest.approx(-(2.0**1.5) * 2.25)


def test_noises_have_their_spread_tails_and_memory() -> None:
    """Standard deviation 1; Student's kurtosis 3 + 6 / (n - 4) of freedom n = 9; memory exp(-step / time)."""
    from concealer.noises import in_digits, left_by_holes, noise

    rng, time = np.random.default_rng(5), np.arange(0.0, 20000.0, 0.1)
    heavy = noise(rng, (time.size,), {"kind": "student", "freedom": 9.0}, time)
    slow = noise(rng, (time.size, 2), {"kind": "coloured", "correlation": 0.5}, time)
    assert (heavy.std(), slow.std()) == pytest.approx((1.0, 1.0), rel=0.02)
    assert np.mean(heavy**4) == pytest.approx(4.2, rel=0.1)
    assert np.mean(slow[1:, 1] * slow[:-1, 1]) == pytest.approx(math.exp(-0.2), rel=0.02)
    assert in_digits(np.array([0.9, -2.6]), 0.5) == pytest.approx([1.0, -2.5])
    keep = left_by_holes(rng, time[:6000], {"holes": 10.0, "hole": 4.0})
    assert 0.9 < keep.mean() < 1.0 and left_by_holes(rng, time[:6000], {}).all()


def test_recordings_of_families_are_the_same_twice_and_say_what_they_drew(
    tmp_path: Path, numbers: dict[str, Any], table: dict[str, Any]
) -> None:
    """The same bytes from the same seed and word; the envelope names members and the table's hash."""
    from concealer.families import digest
    from concealer.prior import Wish
    from concealer.recording import make

    entries, numbers = [], numbers | {"families": table}
    wish = Wish("single", ("tether",), size=0.8, noise=0.01, robots=1)
    for name in ("one", "two"):
        for folder in ("recordings", "envelopes"):
            (tmp_path / name / folder).mkdir(parents=True)
        entries.append([make(index, 5, tmp_path / name, numbers, wish) for index in range(3)])
    assert entries[0] == entries[1]
    truths = [json.loads(path.read_text()) for path in sorted((tmp_path / "one" / "envelopes").glob("*.json"))]
    assert all(truth["families"]["table"] == digest(table) for truth in truths)
    for truth in truths:
        (effect,) = truth["effects"]
        kind = table["forms"][effect["form_of_family"]]["kind"]
        assert ("concealed" in effect) == (kind != "plain")


def test_a_law_of_the_grammar_is_sealed_with_what_it_leaves(
    tmp_path: Path, numbers: dict[str, Any], table: dict[str, Any]
) -> None:
    """A recording outside the catalogue hides a law of the grammar; its rms is that of a force that swings so far."""
    from concealer.prior import Wish
    from concealer.recording import make

    for folder in ("recordings", "envelopes"):
        (tmp_path / folder).mkdir()
    make(0, 6, tmp_path, numbers | {"families": table}, Wish("outside", size=0.8, noise=0.01, robots=1))
    (effect,) = json.loads((tmp_path / "envelopes" / "r0000.json").read_text())["effects"]
    assert effect["id"].startswith("unknown:") and effect["id"] in effect["acceptable"]
    assert effect["parameters"]["coefficient"] != 0.0 and effect["parameters"]["nats"] >= 0.0


def _case(kind: str, effects: list[Any], named: list[Any], **families: Any) -> Any:
    from concealer.cases import Case

    drawn = {"noise": "white", "plan": "rich", "arena": "square"} | families
    drawn["sealed"] = {"noise": False, "plan": False, "arena": False, "forms": {}}
    truth = {"recording": "r", "kind": kind, "effects": effects, "noise": 0.01, "families": drawn}
    return Case(truth, {"verdict": "mismatch" if named else "consistent", "effects": named})


def test_figures_by_family_are_counted_by_hand() -> None:
    """Two forms of drag, of which one is named and its interval holds; a false alarm with heavy noise."""
    from concealer.score_families import by_family

    drag = {"id": "linear_drag", "topic": None, "robots": ["lily_01"], "parameters": {"surge": 0.02}, "size": 0.5}
    said = {"id": "linear_drag", "nats": 50.0, "parameters": {"surge": {"value": 0.021, "ci95": [0.019, 0.023]}}}
    cases = [
        _case("single", [drag | {"form_of_family": "placed_2"}], [said]),
        _case("single", [drag | {"form_of_family": "smooth"}], []),
        _case("nothing", [], [said], noise="heavy_1"),
        _case("nothing", [], [], noise="coloured_1"),
    ]
    found = by_family(cases)
    counts = {title: {name: (r["hits"], r["of"]) for name, r in rows.items()} for title, rows in found.items()}
    assert counts["exact naming of one effect, by form"] == {"placed": (1, 1), "smooth": (0, 1)}
    assert counts["right answers of all kinds, by noise"] == {"coloured": (1, 1), "heavy": (0, 1), "white": (1, 2)}
    assert counts["false alarms where structure is intact, by noise"] == {"coloured": (0, 1), "heavy": (1, 1)}
    assert counts["95 % intervals of effects that hold the truth, by form"] == {"placed": (1, 1)}
    assert by_family([]) == {}
