"""The stages of a search: which settings follow from which results."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

TARGET = (True, False, False, True, True, False, True, False)
Search = Callable[..., list[Any]]


def changes(setting: tuple[bool, ...]) -> int:
    """How many factors differ from the target."""
    return sum(one != other for one, other in zip(setting, TARGET, strict=True))


def test_stages_come_in_their_order_with_their_runs(searched: Search) -> None:
    """Screening, two rounds, the three best with more runs, many runs of one setting that was not chosen by them."""
    stages = searched(8, changes, 2)
    told = [(part.stage.name, part.stage.runs) for part in stages]
    assert told == [("screening", 4), ("refining_1", 6), ("refining_2", 6), ("choosing", 20), ("confirming", 400)]
    assert [len(part.stage.settings) for part in stages] == [16, 6, 8, 3, 1]


def test_additive_choices_are_found_by_main_effects_alone(searched: Search) -> None:
    """The target is not in the screening; the first round has it, the second its neighbours, the others it again."""
    stages = searched(8, changes, 2)
    assert TARGET not in stages[0].stage.settings
    assert stages[1].stage.settings[0] == TARGET
    assert {changes(one) for one in stages[2].stage.settings} == {1}
    assert stages[3].stage.settings[0] == TARGET
    assert stages[4].stage.settings == (TARGET,)


def test_a_neighbour_that_is_better_is_taken(searched: Search) -> None:
    """The first factor counts only beside others as in the target: main effects can miss it, neighbours do not."""

    def crooked(setting: tuple[bool, ...]) -> float:
        others = changes((TARGET[0], *setting[1:]))
        return 2.0 * others + (1.0 if setting[0] == TARGET[0] else 0.0) - (4.0 if setting == TARGET else 0.0)

    stages = searched(8, crooked, 2)
    assert stages[1].stage.settings[0] == (not TARGET[0], *TARGET[1:])
    assert TARGET in stages[2].stage.settings
    assert stages[4].stage.settings == (TARGET,)


def test_settings_are_not_refined_twice(searched: Search) -> None:
    """Three rounds about the same best setting: the third has nothing to do."""
    stages = searched(8, changes, 3)
    assert [part.stage.name for part in stages] == ["screening", "refining_1", "refining_2", "choosing", "confirming"]
    refined = [one for part in stages[1:3] for one in part.stage.settings]
    assert len(refined) == len(set(refined))


def test_without_rounds_the_best_of_the_screening_is_confirmed(searched: Search) -> None:
    """Whatever main effects say."""
    stages = searched(8, changes, 0)
    assert [part.stage.name for part in stages] == ["screening", "choosing", "confirming"]
    assert changes(stages[2].stage.settings[0]) == min(changes(one) for one in stages[0].stage.settings)


def test_what_is_chosen_among_counts_by_its_later_runs(searched: Search) -> None:
    """The best of the refining is the worst of three when it is run again: the second is confirmed."""
    asked: list[tuple[bool, ...]] = []

    def deceptive(setting: tuple[bool, ...]) -> float:
        asked.append(setting)
        lucky = setting == TARGET and asked.count(TARGET) == 1
        return 0.0 if lucky else 9.0 if setting == TARGET else changes(setting)

    stages = searched(8, deceptive, 2)
    assert TARGET in stages[3].stage.settings
    assert changes(stages[4].stage.settings[0]) == 1
