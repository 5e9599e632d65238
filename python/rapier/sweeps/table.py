"""The table of a sweep: Arrow, Parquet, plots."""

from __future__ import annotations

import os
from collections.abc import Iterable
from typing import Any, Optional, Union

from .._rapier import InvalidValueError, RapierError

#: Columns besides the parameters and metrics.
COLUMNS = ["hash", "seconds", "worker"]


def check_columns(parameters, metrics):
    """Raises an exception if two columns of the table have one name."""
    taken = {name: "a column of each table" for name in COLUMNS}
    for kind, names in (("a parameter", parameters), ("a metric", metrics)):
        for name in names:
            if name in taken:
                raise InvalidValueError(f"the column {name} is {kind}, but also {taken[name]}")
            taken[name] = kind


class SweepError(RapierError):
    """Cases of a sweep failed. `result` contains the others."""

    def __init__(self, message: str, result: SweepResult) -> None:
        super().__init__(message)
        self.result = result


class SweepResult:
    """The results of a sweep, a row for each case in the order of the grid.

    parameters, metrics: names of the columns. rows: dictionaries. failures: texts of exceptions by the number of the case. lost_workers: processes that ended.
    """

    def __init__(
        self, parameters: Iterable[str], metrics: Iterable[str], rows: list[dict[str, Any]], failures: dict[int, str], lost_workers: int,
    ) -> None:
        self.parameters, self.metrics, self.rows = list(parameters), list(metrics), rows
        self.failures, self.lost_workers = failures, lost_workers

    def __len__(self) -> int:
        """The number of cases."""
        return len(self.rows)

    @property
    def table(self) -> Any:
        """The rows as a `pyarrow.Table`. Failed cases have null metrics. The column "hash" is that of the world after the steps."""
        import pyarrow

        columns = [*self.parameters, *self.metrics, *COLUMNS]
        arrays = {name: [row.get(name) for row in self.rows] for name in columns}
        hashes = pyarrow.array(arrays.pop("hash"), pyarrow.uint64())
        table = pyarrow.table(arrays)
        return table.append_column("hash", hashes)

    def to_parquet(self, path: Union[str, os.PathLike[str]]) -> None:
        """Writes the table as a Parquet file."""
        import pyarrow.parquet

        pyarrow.parquet.write_table(self.table, path)

    def plot(self, x: Optional[str] = None, y: Optional[str] = None, by: Optional[str] = None, ax: Any = None) -> Any:
        """Plots a metric against a parameter, one line for each value of another parameter. Returns the axes of matplotlib.

        x: by default the first parameter. y: by default the first metric. by: by default the second parameter, if there is one.
        """
        import matplotlib.pyplot as pyplot

        x, y = x or self.parameters[0], y or self.metrics[0]
        others = [name for name in self.parameters if name != x]
        by = by or (others[0] if others else None)
        ax = ax or pyplot.subplots(figsize=(7, 4.5))[1]
        lines = {}
        for row in self.rows:
            if row.get(y) is not None:
                lines.setdefault(row.get(by) if by else None, []).append((row[x], row[y]))
        for value, points in lines.items():
            ax.plot(*zip(*sorted(points)), marker="o", label=None if by is None else f"{by} = {value}")
        ax.set_xlabel(x)
        ax.set_ylabel(y)
        ax.grid(alpha=0.3)
        if by:
            ax.legend()
        return ax

    def __repr__(self) -> str:
        return f"<SweepResult: {len(self.rows)} cases of {', '.join(self.parameters)}, {len(self.failures)} failed>"
