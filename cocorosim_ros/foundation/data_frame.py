"""DataFrames of results; pandas is loaded when the first one is asked for, and nothing else needs it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from numpy.typing import ArrayLike

from cocorosim_ros.foundation.errors import CocorosimError

if TYPE_CHECKING:
    import pandas as pd


def data_frame(columns: Mapping[str, ArrayLike]) -> pd.DataFrame:
    """A DataFrame of columns of equal length. Raises CocorosimError if pandas is not installed."""
    return loaded_pandas().DataFrame(dict(columns))


def loaded_pandas() -> Any:
    """The module pandas. Raises CocorosimError if it is not installed."""
    try:
        import pandas
    except ImportError as error:
        raise CocorosimError(
            "A DataFrame needs pandas, which is not installed here; run `pip install 'pandas<3'`, or take the arrays "
            "of the record itself."
        ) from error
    return pandas
