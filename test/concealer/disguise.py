"""Laws in other forms than the Concealer's own: a scene whose robots have blocks of numbers, as forms.py reads them."""

from __future__ import annotations

import copy
from dataclasses import asdict
from typing import Any

import numpy as np

from concealer import families, grammar, staging
from concealer import layout as at
from concealer.families import Members
from concealer.forms import ALONG_X, ALONG_Y, BLOCK, COEFFICIENT, EQUATIONS, KINDS, LAW, NUMBER, PHASE, PLAIN, WIDE
from concealer.layout import FloatArray
from concealer.nearest import PLACES, nearest, normalise
from concealer.prior import Plot
from concealer.scene import Scene, Secret

Numbers = dict[str, Any]
LAW_OF_THE_GRAMMAR = "grammar"


class Disguise:
    """One recording of the part `families`: what it drew, and what is known of its forms once it has run."""

    def __init__(self, rng: np.random.Generator, numbers: Numbers, plot: Plot) -> None:
        self.table: Numbers = numbers["families"]
        if plot.kind == "outside":
            plot.hidden = {LAW_OF_THE_GRAMMAR: next(iter(plot.hidden.values()))}
        self.members: Members = families.members(rng, self.table, list(plot.hidden))
        self.plot, self.numbers = plot, numbers
        self.blocks: dict[str, int] = {}  # by effect
        arena, plan = self.table["arenas"][self.members.arena], self.table["plans"][self.members.plan]
        if plot.manoeuvre != "idle":
            plot.arena = arena["side"], arena["other"], arena["depth"]
        if plot.kind != "cannot_tell":
            plot.style = plan["stretch"], plan["level"], plan["taste"]

    @property
    def sensors(self) -> Numbers:
        """Numbers of the sensors, with their noise."""
        member = self.table["noises"][self.members.noise]
        return dict(self.numbers["sensors"]) | {"member": member, "digit": self.table["digit"]}

    def _has_block(self, name: str) -> bool:
        kind = self.table["forms"][self.members.forms[name]]["kind"]
        return kind != "plain" and name in PLACES and len(self.blocks) < at.FORMED

    def stage(self, rng: np.random.Generator) -> tuple[Scene, list[Secret]]:
        """Robots (robots, WIDE) and water with everything hidden; forms still have neither scale nor gain."""
        scene, plot = staging.empty(rng, self.numbers, self.plot), self.plot
        secrets: dict[str, Secret] = {}
        for name, share in plot.hidden.items():
            if name != LAW_OF_THE_GRAMMAR and not self._has_block(name):
                secrets[name] = staging.hide(rng, self.numbers, name, share, scene)
        if plot.kind == "cannot_tell":
            staging.without_ramp(scene)
        bare = scene.robots
        wide = np.concatenate([bare, np.zeros((len(bare), WIDE - at.SIZE))], axis=1)
        for name, share in plot.hidden.items():
            if name == LAW_OF_THE_GRAMMAR:
                wide[scene.victim, LAW:], secrets[name] = grammar.draw(rng, self.table["grammar"])
            elif name not in secrets:
                scene.robots = bare.copy()
                secrets[name] = staging.hide(rng, self.numbers, name, share, scene)
                if plot.kind == "cannot_tell":
                    staging.without_ramp(scene)
                self._block(wide, name, scene.robots)
        scene.robots = wide
        return scene, [secrets[name] for name in plot.hidden]

    def _block(self, wide: FloatArray, name: str, robots: FloatArray) -> None:
        """Writes a block: the robots with the law in them, and the numbers of the form, which is plain for now."""
        form = self.table["forms"][self.members.forms[name]]
        k = self.blocks.setdefault(name, len(self.blocks))
        begin = at.SIZE + k * BLOCK
        wide[:, begin : begin + at.SIZE] = robots
        numbers = np.zeros(BLOCK - at.SIZE)
        numbers[0], numbers[1] = PLAIN, 1.0
        numbers[NUMBER] = next((form[key] for key in ("width", "power", "depth") if key in form), 0.0)
        if "length" in form:
            wave = 2.0 * np.pi / form["length"]
            numbers[ALONG_X], numbers[ALONG_Y] = wave * np.cos(form["bearing"]), wave * np.sin(form["bearing"])
            numbers[PHASE] = form["phase"]
        wide[:, begin + at.SIZE : begin + BLOCK] = numbers

    def move(self, rng: np.random.Generator, scene: Scene) -> tuple[FloatArray, FloatArray]:
        """Trajectory and commands; a run with plain forms goes before and gives the forms their scales."""
        if self.blocks or LAW_OF_THE_GRAMMAR in self.plot.hidden:
            held = scene.own[LAW:].copy()
            scene.own[LAW:] = 0.0
            rows, commands = staging.move(copy.deepcopy(rng), self.plot, scene)
            rows, commands = rows[:, scene.victim], commands[:, scene.victim]
            for name, k in self.blocks.items():
                kind = KINDS[self.table["forms"][self.members.forms[name]]["kind"]]
                normalise(scene.robots, scene.victim, rows, commands, k, kind)
            scene.own[LAW:] = held
            if held[0]:
                equation = EQUATIONS[int(held[0])]
                large = self.table["grammar"]["equations"][equation] * self.plot.hidden[LAW_OF_THE_GRAMMAR]
                rms = float(np.sqrt(np.mean(grammar.series(held, rows, commands) ** 2)))
                scene.own[LAW + COEFFICIENT] *= large * np.sqrt(0.5) / max(rms, 1e-3)
        return staging.move(rng, self.plot, scene)

    def settle(self, name: str, secret: Secret, scene: Scene, rows: FloatArray, commands: FloatArray) -> Numbers:
        """Fills in the numbers of a secret by the victim's trajectory; returns what is told of its form.

        Effects without a block are left as they are; the caller settles them.
        """
        told: Numbers = {"form_of_family": self.members.forms[name]}
        if name == LAW_OF_THE_GRAMMAR:
            water = self.plot.noise, self.plot.correlation
            grammar.settle(secret, scene.own[LAW:], rows, commands, water)
        elif name in self.blocks:
            plain = dict(secret.parameters)
            found, left = nearest(name, scene.own, rows, commands, self.blocks[name])
            secret.parameters = {**plain, **found}
            told |= {"concealed": plain, "left_by_nearest": left}
        return told

    def described(self) -> Numbers:
        """What the envelope says of the families."""
        chosen = asdict(self.members)
        sealed = {
            "noise": self.table["noises"][self.members.noise]["sealed"],
            "plan": self.table["plans"][self.members.plan]["sealed"],
            "arena": self.table["arenas"][self.members.arena]["sealed"],
            "forms": {name: self.table["forms"][form]["sealed"] for name, form in self.members.forms.items()},
        }
        return chosen | {"sealed": sealed, "table": families.digest(self.table)}
