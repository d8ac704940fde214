"""Forms of an actuator's curve, tried on a made table: the form that made it errs by nothing, the others do."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest


@pytest.mark.parametrize(
    ("exact", "law"),
    [
        (0, lambda c: 20.0 * c),
        (1, lambda c: 20.0 * c * np.abs(c)),
        (2, lambda c: 20.0 * np.sign(c) * np.maximum(np.abs(c) - 0.1, 0.0) / 0.9),
    ],
)
def test_the_form_that_made_a_table_holds_it(exact: int, law: object, tmp_path: Path) -> None:
    """Rows that no curve was made of, in kilograms as the maker has them; the table of few points errs between them."""
    from trial.thruster import FOLDER, FORMS, STANDARD_GRAVITY, thruster_figures, thruster_rows

    pulse = np.arange(1100, 1901, 4)
    force = law((pulse - 1500.0) / 400.0) / STANDARD_GRAVITY  # type: ignore[operator]
    rows = [f"{each},0,0,0,0,{kilograms!r},0" for each, kilograms in zip(pulse, force.tolist(), strict=True)]
    (tmp_path / FOLDER).mkdir()
    (tmp_path / FOLDER / "made.csv").write_text("\n".join(["pwm,rpm,a,v,w,kgf,eff", *rows]))
    (row,) = thruster_rows(thruster_figures(tmp_path))
    name, largest, *errors = [cell.strip() for cell in row.strip("|").split("|")]
    assert (name, largest, len(errors)) == ("made", "20.0", len(FORMS))
    found = dict(zip(FORMS, map(float, errors), strict=True))
    assert found[FORMS[exact]] < 0.02
    others = [found[form] for form in FORMS[:3] if form != FORMS[exact] and not (exact == 0 and "dead" in form)]
    assert min(others) > 0.3
