"""Two CSV tables of results compared cell by cell: where they first differ, and by how much."""
import csv
import math


def read_table(path):
    """Returns the names of the columns and the rows of a CSV file."""
    with open(path, encoding="utf-8", newline="") as file:
        reader = csv.DictReader(file)
        return reader.fieldnames or [], list(reader)


def is_repeatable(column):
    """Returns whether a column has the same values in every run of one program: clocks and memory do not."""
    return not column.endswith("seconds") and column != "peak_memory_bytes"


def measure_difference(before, after):
    """Returns the largest difference of two columns over their largest magnitude, and this magnitude."""
    try:
        differences = [abs(float(a) - float(b)) for a, b in zip(before, after) if a != b]
        values = [abs(float(cell)) for cell in before + after if cell]
    except (TypeError, ValueError):  # a cell is missing, empty or a word
        return math.inf, 0.0
    magnitude = max(filter(math.isfinite, values), default=0.0)
    if not all(map(math.isfinite, differences)):
        return math.inf, magnitude
    return max(differences, default=0.0) / (magnitude or 1.0), magnitude


class Comparison:
    """The differences between the tables of two runs."""

    def __init__(self):
        self.rows, self.first, self.problems, self.new = 0, "", [], []
        self.differences = {}  # by column: relative difference, magnitude
        self.newton = []       # for each table: whether the columns newton_iterations are equal

    def add(self, label, before_path, after_path):
        """Compares two files; `label` stands before places in them."""
        (names, before), (new_names, after) = read_table(before_path), read_table(after_path)
        self.rows += len(after)
        if not before or len(before) != len(after):
            self.problems.append(f"{label}{len(before)} rows before, {len(after)} after")
        missing = [name for name in names if name not in new_names]
        if missing:
            self.problems.append(f"{label}missing columns: {', '.join(missing)}")
        failed = [row for row in after if row.get("status") == "failed"]  # of a study; such a run compares nothing
        if failed:
            self.problems.append(f"{label}failed runs after: {len(failed)}, the first: {failed[0].get('reason')}")
        self.new += [name for name in new_names if name not in names and name not in self.new]
        shared = [name for name in names if name in new_names and is_repeatable(name)]
        places = ((i, name) for i, (a, b) in enumerate(zip(before, after)) for name in shared if a[name] != b[name])
        place = next(places, None)
        if place and not self.first:
            self.first = f"{label}row {place[0]}, column {place[1]}"
        for name in shared:
            columns = [row[name] for row in before], [row[name] for row in after]
            if name == "newton_iterations":
                self.newton.append(columns[0] == columns[1])
            if any(a != b for a, b in zip(*columns)):
                self.differences[name] = max(self.differences.get(name, (0.0, 0.0)), measure_difference(*columns))

    def judge(self, tolerance):
        """Returns the result in words, and whether it passes."""
        largest = sorted(self.differences.items(), key=lambda item: -item[1][0])
        within = not self.first or (tolerance > 0 and largest[0][1][0] <= tolerance)
        words = list(self.problems)
        if self.first:
            words.append(f"{'within the tolerance' if within else 'DIFFERENT'}, first in {self.first}")
            shown = [f"{name} {'not a number' if relative == math.inf else f'{relative:.1e} of {magnitude:.1e}'}"
                     for name, (relative, magnitude) in largest[:4]]
            words.append(f"differing columns: {len(largest)}, largest relative differences: {', '.join(shown)}")
        if words and self.newton:
            words.append(f"newton_iterations {'equal' if all(self.newton) else 'DIFFERENT'}")
        words = words or ["same"]
        if self.new:
            words.append(f"new columns: {', '.join(self.new)}")
        return "; ".join(words), within and not self.problems
