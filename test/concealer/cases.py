"""One case of a trial: an envelope beside the diagnosis of its recording, and what can be asked of the two."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from concealer.laws import matches

AMBIGUITY = 3.0  # nats
CATALOGUE_KINDS = ("single", "several")


def names(effect: dict[str, Any], truth: dict[str, Any]) -> bool:
    """Whether a reported effect names a secret, or what this recording cannot tell from it, on the right stream."""
    told, hidden = effect.get("topic"), truth["topic"]
    return effect["id"] in {truth["id"], *truth.get("twins", [])} and (not told or not hidden or told == hidden)


@dataclass(frozen=True)
class Case:
    """Truth and answer. A diagnosis that is missing is an answer that is never right."""

    truth: dict[str, Any]
    diagnosis: dict[str, Any] | None
    block: str = ""

    @property
    def name(self) -> str:
        """Name of the recording, behind that of its part of the trial."""
        return f"{self.block}/{self.truth['recording']}".lstrip("/")

    @property
    def kind(self) -> str:
        """Class of the composition."""
        return str(self.truth["kind"])

    @property
    def hidden(self) -> list[str]:
        """Identifiers of what was hidden."""
        return [str(effect["id"]) for effect in self.truth["effects"]]

    @property
    def effects(self) -> list[dict[str, Any]]:
        """Reported effects, strongest first."""
        return list((self.diagnosis or {}).get("effects") or [])

    @property
    def named(self) -> list[str]:
        """Identifiers of the reported effects, each once."""
        return list(dict.fromkeys(str(effect["id"]) for effect in self.effects))

    @property
    def verdict(self) -> str:
        """The verdict, or that there is none."""
        return str(self.diagnosis["verdict"]) if self.diagnosis else "no diagnosis"

    @property
    def first(self) -> str:
        """The first named effect, "none", or "no diagnosis"."""
        if self.diagnosis is None:
            return "no diagnosis"
        return self.named[0] if self.named else "none"

    @property
    def size(self) -> float:
        """Size of the first hidden effect as a fraction of large."""
        return float(self.truth["effects"][0]["size"])

    @property
    def band(self) -> str:
        """weak below 0.25 of large, medium to 0.75, large above."""
        return "weak" if self.size < 0.25 else "medium" if self.size <= 0.75 else "large"

    def unnamed(self) -> list[dict[str, Any]]:
        """Secrets that no reported effect names."""
        return [truth for truth in self.truth["effects"] if not any(names(effect, truth) for effect in self.effects)]

    def spurious(self) -> list[dict[str, Any]]:
        """Reported effects that name no secret, and no part of one that is an entry of its own."""
        return [
            effect
            for effect in self.effects
            if effect["id"] not in self.tolerated() and not any(names(effect, t) for t in self.truth["effects"])
        ]

    def exact(self) -> bool:
        """Everything hidden is named and nothing else."""
        return self.diagnosis is not None and not self.unnamed() and not self.spurious()

    def first_wrong(self) -> bool:
        """The strongest reported effect names nothing that is hidden."""
        return bool(self.effects) and not any(names(self.effects[0], truth) for truth in self.truth["effects"])

    def right_robots(self) -> bool:
        """Every secret that is named is found on the robots that have it and on no others."""
        for truth in self.truth["effects"]:
            said = {r for effect in self.effects if names(effect, truth) for r in effect.get("robots") or []}
            if said and said != set(truth["robots"]):
                return False
        return True

    def false_alarm(self) -> bool:
        """Something is named, or a mismatch is claimed, where structure is intact."""
        return bool(self.named) or self.verdict == "mismatch"

    def ambiguity_set(self) -> set[str]:
        """The first named effect and its rivals within 3 nats."""
        rivals = self.effects[0].get("ambiguous_with") or []
        return {self.named[0]} | {str(rival["id"]) for rival in rivals if rival["nats_behind"] <= AMBIGUITY}

    def truth_in_set(self) -> bool:
        """The ambiguity set holds something that is hidden, or a twin of it."""
        right = {name for truth in self.truth["effects"] for name in (truth["id"], *truth.get("twins", []))}
        return bool(right & self.ambiguity_set())

    def right(self) -> bool:
        """There is a diagnosis, and it says what it should of a recording of this kind."""
        if self.diagnosis is None:
            return False
        if self.kind in ("nothing", "recalibration"):
            return not self.false_alarm()
        if self.kind == "outside":
            return self.flagged() and not self.named_wrongly()
        return not self.effects if self.kind == "cannot_tell" else self.exact()

    def unknowns(self) -> list[str]:
        """Named effects outside the catalogue."""
        return [name for name in self.named if name.startswith("unknown:")]

    def flagged(self) -> bool:
        """It is said that something outside the catalogue is missing."""
        return bool(self.unknowns()) or (self.verdict == "mismatch" and not self.named)

    def tolerated(self) -> set[str]:
        """Catalogue entries that have something to do with a law outside it, or are a part of what was hidden."""
        return {n for e in self.truth["effects"] for n in [*e.get("tolerated", []), *e.get("twins", [])]}

    def named_wrongly(self) -> bool:
        """A catalogue entry is named that has nothing to do with what was hidden."""
        return any(not name.startswith("unknown:") and name not in self.tolerated() for name in self.named)

    def of_tier(self, tier: str) -> list[bool]:
        """Whether each name of this tier is right, those of several robots once.

        A law outside the catalogue is told by any law, or by an entry that has something to do with it.
        """
        named = {(each["id"], each.get("topic")): each for each in self.effects if each.get("tier") == tier}
        return [self._is_right(each) for each in named.values()]

    def _is_right(self, effect: dict[str, Any]) -> bool:
        if self.kind == "outside" and (effect["id"].startswith("unknown:") or effect["id"] in self.tolerated()):
            return True
        return any(names(effect, truth) for truth in self.truth["effects"])

    def rightly_unknown(self) -> bool:
        """The law outside the catalogue has a right name."""
        patterns = [pattern for effect in self.truth["effects"] for pattern in effect["acceptable"]]
        return any(matches(name, pattern) for name in self.unknowns() for pattern in patterns)

    def says_so(self) -> bool:
        """Nothing is named, and the recording is said not to show what was hidden."""
        unseen = (self.diagnosis or {}).get("not_shown_by_this_recording") or []
        told = self.verdict == "insufficient" or any(name in unseen for name in self.hidden)
        return self.diagnosis is not None and not self.named and told


def load(trial: Path, diagnoses: Path, block: str = "") -> list[Case]:
    """All cases of a trial; a diagnosis is NAME/diagnosis.json or NAME.json."""
    cases = []
    for envelope in sorted((trial / "envelopes").glob("*.json")):
        truth = json.loads(envelope.read_text(encoding="utf-8"))
        places = [diagnoses / envelope.stem / "diagnosis.json", diagnoses / envelope.name]
        found = next((place for place in places if place.exists()), None)
        answer = json.loads(found.read_text(encoding="utf-8")) if found else None
        cases.append(Case(truth, answer, block))
    return cases
