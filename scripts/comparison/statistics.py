"""Two statistics.csv, column by column."""

import csv
import math
import os
import re

# What a changed order of sums may explain.
ROUNDING = 1e-10


class Table:
    """The columns of a statistics.csv, as text, by heading."""

    def __init__(self, folder):
        with open(os.path.join(folder, "statistics.csv"), newline="", encoding="utf-8") as file:
            rows = list(csv.reader(file))
        self.columns = {heading: [row[i] for row in rows[1:]] for i, heading in enumerate(rows[0])}
        self.n_rows = len(rows) - 1


class Report:
    def __init__(self, line):
        self.lines = [line]
        self.is_same = True

    def add(self, other):
        self.lines[0] += other.lines[0]
        self.lines += other.lines[1:]
        self.is_same = self.is_same and other.is_same

    def difference(self, line):
        self.lines.append(line)
        self.is_same = False


def is_wall_time(heading):
    return "wall time" in heading


def is_exact(heading, values):
    """Counts, whose headings have no unit, and words."""
    return "[" not in heading or not all(is_number(value) for value in values)


def is_number(text):
    try:
        return math.isfinite(float(text))
    except ValueError:
        return False


def quantity_of(heading):
    """The components of a vector are one quantity: 'momentum' of 'momentum x [kg m/s]'. So are the torques
    on all magnets, since that on a round wire is zero but for rounding, and the magnetic forces on all
    bodies with what is dropped of them, which is small beside them."""
    heading = re.sub(r" [xyz] (?=\[)", " ", heading)
    return re.sub(r"^(.*: torque|.*: magnetic force|dropped magnetic force)",
                  lambda name: name[0].replace("dropped ", "").split(": ")[-1], heading)


def sizes_of(table):
    """The largest value of each quantity; that of a residual, which is relative already, is 1."""
    sizes = {}
    for heading, values in table.columns.items():
        numbers = [abs(float(value)) for value in values if is_number(value)]
        quantity = quantity_of(heading)
        sizes[quantity] = max(numbers + [sizes.get(quantity, 0.0)])
        if quantity.startswith("Newton residual"):
            sizes[quantity] = 1.0
    return sizes


def difference_of(one, other, size):
    """Relative; infinite if the one is no number, or nothing is there to compare with."""
    if one == other:
        return 0.0
    if not (is_number(one) and is_number(other)):
        return math.inf
    difference = abs(float(one) - float(other))
    return difference / size if size > 0 else (math.inf if difference > 0 else 0.0)


def first_unlike(old, new, tolerance, size):
    """The row (from 1) where two columns differ for the first time, the values there and a difference."""
    differences = [difference_of(one, other, size) for one, other in zip(old, new)]
    row = next((row for row, difference in enumerate(differences) if difference > tolerance), None)
    worst = max(differences, default=0.0)
    return (None if row is None else "from row %d (%s, was %s)" % (row + 1, new[row], old[row])), worst


def compare(old, new, tolerance):
    """A Report on two Tables."""
    sizes = sizes_of(old)
    report = Report("%3d rows" % old.n_rows)
    if new.n_rows != old.n_rows:
        report.difference("%d rows, there were %d" % (new.n_rows, old.n_rows))
    worst, worst_heading = 0.0, ""
    for heading, values in old.columns.items():
        if is_wall_time(heading):
            continue
        if heading not in new.columns:
            report.difference("column '%s' is missing" % heading)
        elif is_exact(heading, values):
            where, _ = first_unlike(values, new.columns[heading], 0.0, 0.0)
            if where:
                report.difference("%s: not equal %s" % (heading, where))
        else:
            where, difference = first_unlike(values, new.columns[heading], tolerance,
                                             sizes[quantity_of(heading)])
            if difference > worst:
                worst, worst_heading = difference, heading
            if where:
                report.difference("%s: %.1e%s, %s"
                                  % (heading, difference,
                                     ", more than rounding" if difference > ROUNDING else "", where))
    for heading in new.columns:
        if heading not in old.columns and not is_wall_time(heading):
            report.lines.append("column '%s' is new" % heading)
    report.lines[0] += (", to the last bit" if worst == 0 and report.is_same else
                        ", worst: %s %.1e" % (worst_heading, worst))
    return report
