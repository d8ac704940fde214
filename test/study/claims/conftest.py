"""Results of numbers that a test makes up."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
import pyarrow as pa
import pytest

RUNS = 40


@pytest.fixture
def made_up() -> Callable[..., Any]:
    """Function of (design, groups with the first as baseline, {(group, column): number}, runs): Results in `paper`.

    Every run of a group has the number plus a thousandth of its own; what is not given is 0.
    """

    def make(design: str, groups: tuple[str, ...], numbers: Mapping[tuple[str, str], float], runs: int = RUNS) -> Any:
        from cocorosim_ros.study.experiments.rows import SCHEMA
        from cocorosim_ros.study.results.results import Results

        tables = []
        for group in groups:
            columns: dict[str, Any] = {}
            for field in SCHEMA:
                plain = np.arange(runs) if field.type == pa.int64() else np.arange(runs) / 1000
                columns[field.name] = ["x"] * runs if field.type == pa.string() else plain
            columns |= {"numerics": ["paper"] * runs, "group": [group] * runs, "replicate": np.arange(runs)}
            for (owner, column), number in numbers.items():
                if owner == group:
                    columns[column] = number + np.arange(runs) / 1000
            arrays = {name: pa.array(values, SCHEMA.field(name).type) for name, values in columns.items()}
            tables.append(pa.table(arrays, schema=SCHEMA))
        about = {
            "design": design,
            "digest": "d",
            "baseline": groups[0],
            "ticks": 100,
            "robots": 10,
            "cells": [{"numerics": "paper", "group": group} for group in groups],
        }
        return Results(about, pa.concat_tables(tables))

    return make
