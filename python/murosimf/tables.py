"""Tables of studies and recordings as columns, and as Parquet files for pandas, Polars, DuckDB and Spark."""

from __future__ import annotations

import os
from collections.abc import Mapping
from os import PathLike
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._optional import optional


def columns(table: Mapping[str, Any] | NDArray[np.void]) -> dict[str, NDArray[Any]]:
    """Of a sweep or an experiment: a row for each run, with the values of its axes (numbers, or texts where one of them is none),
    its `seed`, and its results under their names with units. Of records (Recording.table): their fields."""
    if isinstance(table, np.ndarray):
        return {name: table[name] for name in table.dtype.names or ()}
    runs = table["runs"]
    result = {axis: _values([run["values"][i] for run in runs]) for i, axis in enumerate(table["axes"])}
    result["seed"] = np.array([run["seed"] for run in runs], dtype=np.uint64)
    for i, name in enumerate(table["results"]):
        result[name] = np.array([float(run["results"][i]) for run in runs])  # JSON has "NaN" as a text
    return result


def write_parquet(file: str | PathLike[str], table: Mapping[str, Any] | NDArray[np.void]) -> None:
    """The columns of a table (columns()) as a Parquet file, with all digits. Raises StateError without the package pyarrow."""
    arrow, parquet = optional("pyarrow", "parquet"), optional("pyarrow.parquet", "parquet")
    parquet.write_table(arrow.table(columns(table)), os.fspath(file))


def _values(texts: list[str]) -> NDArray[Any]:
    try:
        return np.array([float(text) for text in texts])
    except ValueError:
        return np.array(texts, dtype=object)
