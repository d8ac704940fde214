"""Numbers of a platform that a diagnosis keeps as the file gives them, in place of fitting them.

`kept_as_given: [yaw_drag, effects.linear_drag.yaw]` names them by their keys in the file. They are known better than
recordings tell them, or an earlier diagnosis has found that the vehicle is foretold worse once they are fitted.
"""

from __future__ import annotations

from collections.abc import Collection

from cocorosim_ros.scenario.reading.entry import Entry, listed

FITTED_WITHOUT_RANGE = ("thrust_gain", "yaw_torque_gain", "drag", "yaw_drag", "buoyancy_gain")
"""Numbers that a diagnosis fits although the file gives no range beside them."""


def read_kept(entry: Entry) -> tuple[str, ...]:
    """The keys of a list, each once.

    Raises CocorosimError: no list of words, a key that stands there twice.
    """
    keys = [part.text() for part in entry.items()]
    for place, key in enumerate(keys):
        if key in keys[:place]:
            raise entry.items()[place].problem(f"has '{key}', which stands in the list before; leave it out.")
    return tuple(keys)


def check_kept(entry: Entry, ranged: Collection[str]) -> None:
    """Refuse keys of a list that no diagnosis fits; ranged: keys of the numbers that have a range.

    Raises CocorosimError: it names the key and those that are allowed.
    """
    allowed = sorted({*FITTED_WITHOUT_RANGE, *ranged})
    for part in entry.items():
        if part.value not in allowed:
            fitted = listed(allowed)
            raise part.problem(f"has {part.found()}, which no diagnosis fits; leave it out, or name one of {fitted}.")
