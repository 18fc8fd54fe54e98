"""Two runs' histories compared column by column: the differences over the scale of each column's quantity."""
import re

import numpy as np

# Columns that differ between runs of equal solutions.
COUNTS_AND_CLOCKS = {"newton_iterations", "linear_iterations", "wall_seconds"}


def quantity(column):
    """Returns the name of a column without its axis: components have one scale."""
    return re.sub(r"(?<=[_uv])[xyz]$", "", column)


def scales(history):
    """Returns the largest finite magnitude of each quantity."""
    result = {}
    for column, values in history.items():
        largest = np.max(np.abs(values[np.isfinite(values)]), initial=0.0)
        result[quantity(column)] = max(result.get(quantity(column), 0.0), largest)
    return result


def differences(one, two, bound, rows=slice(None)):
    """Yields messages on columns that differ in some rows by more than `bound` of the largest value in `one`."""
    if list(one) != list(two) or len(one["step"][rows]) != len(two["step"][rows]):
        yield "the tables differ in columns or rows"
        return
    largest = scales(one)
    for column in one:
        if column in COUNTS_AND_CLOCKS:
            continue
        a, b = one[column][rows], two[column][rows]
        if (np.isnan(a) != np.isnan(b)).any():
            yield f"{column}: other cells are empty"
        apart = (a != b) & ~np.isnan(a) & ~np.isnan(b)
        difference = np.max(np.abs(a[apart] - b[apart]), initial=0.0)
        if difference > bound * largest[quantity(column)]:
            yield f"{column}: {difference:.3g}, of {largest[quantity(column)]:.3g}"
