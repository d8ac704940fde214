"""What a key, a metric, an effect, a topic or a controller means."""

from __future__ import annotations

import difflib

from cocorosim_ros.foundation.errors import ArgumentError
from cocorosim_ros.library.explaining.explanation import CATALOGUE, PLACE, Explanation
from cocorosim_ros.library.explaining.index import every_explanation

_SUGGESTED = 5


def explain(key: str) -> tuple[Explanation, ...]:
    """Unit, range, default, source and users of a key.

    key: a dotted key of a scenario, platform or map ('lockstep.patience'), its last word ('patience'), an effect
    ('wall_effect') or a number of it ('wall_effect.gain'), a metric, a topic, a controller or its parameter.

    Returns what has that name; where nothing has, all whose last word it is. With 'effects', the key of a platform,
    comes the catalogue: every effect and error of a sensor that may stand below it. Raises CocorosimError with the
    nearest names where there is none. All of it is derived from the records, tables and files that define the keys.

    Example: `explain("mass")[0].facts["form"]` is 'mass [kg], greater than zero'.
    """
    wanted = ".".join(str(key).replace("[]", "").strip().split("."))
    every = every_explanation()
    found = tuple(each for each in every if wanted in (each.name, each.name.lstrip("/")))
    found = found or tuple(each for each in every if each.name.endswith(f".{wanted}"))
    if wanted == CATALOGUE:
        found += tuple(each for each in every if each.facts.get(PLACE, "").startswith(f"{CATALOGUE}."))
    if found:
        return found
    names = list(dict.fromkeys(part for each in every for part in (each.name, each.last_word)))
    close = difflib.get_close_matches(wanted, names, n=_SUGGESTED)
    close += [name for name in names if wanted and wanted in name and name not in close][: _SUGGESTED - len(close)]
    guess = f"did you mean {', '.join(close)}?" if close else "`cocorosim explain` lists what there is."
    raise ArgumentError(f"'{key}' is no key, effect, metric, topic or controller; {guess}", "key")
