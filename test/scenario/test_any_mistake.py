"""Whatever stands in the place of any value of a scenario, the answer is a scenario or a sentence."""

from __future__ import annotations

import copy
from collections.abc import Iterator
from typing import Any

from hypothesis import given, settings
from hypothesis import strategies as st

from cocorosim_ros.foundation.errors import CocorosimError
from cocorosim_ros.scenario.reading.entry import entry_of
from cocorosim_ros.scenario.reading.records import record_tree
from cocorosim_ros.world.checks.loading import load_scenario, read_scenario

TREE = record_tree(load_scenario("eleven_lilys"))
WRONG = st.one_of(
    st.none(),
    st.booleans(),
    st.integers(-(10**400), 10**400),
    st.floats(),
    st.text(max_size=5),
    st.sampled_from(["1 m", "-1 m", "1e999 m", "nan s", "0 kg", "lily", "all", "../x.yaml", "/"]),
    st.sampled_from([[], {}, [[]], [{}], {"kind": "sphere"}, {"value": [1], "unit": "m", "source": "x"}]),
)


def places(tree: Any, path: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    """The paths of all values in a tree."""
    if path:
        yield path
    if isinstance(tree, dict | list | tuple):
        for key in tree if isinstance(tree, dict) else range(len(tree)):
            yield from places(tree[key], (*path, key))


@settings(deadline=None, max_examples=300)
@given(st.sampled_from(list(places(TREE))), WRONG)
def test_a_scenario_or_a_sentence(path: tuple[Any, ...], wrong: Any) -> None:
    """Replacing one value ends in no other exception, and each sentence is one line with its place."""
    tree: Any = copy.deepcopy(TREE)
    part = tree
    for key in path[:-1]:
        part[key] = list(part[key]) if isinstance(part[key], tuple) else part[key]
        part = part[key]
    part[path[-1]] = wrong
    try:
        read_scenario(entry_of(tree, "x.yaml"))
    except CocorosimError as error:
        assert str(error).startswith("x.yaml: ")
        assert "\n" not in str(error)
