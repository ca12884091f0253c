"""compare_tables.py ONE OTHER

Compares the tables (*.csv) of two directories that the same cases have made on two processors: the
bytes, and where those differ the cells. A number may differ by the error bounds of the two rows, as
shares of the largest number of its column in the table and, of a stretch, in the row; what measures
an error (`residual`, `compatibility`, `error_bound`) is not compared. Words, and how many rows there are, have to
be the same; a Krein signature may be given on one side alone.

Exit code 1 where anything else differs, or a table is missing.
"""

import csv
import pathlib
import sys

STRETCHES = {"alpha", "xi", "zeta", "rho", "lambda", "mu"}
ERRORS = {"residual", "compatibility", "error_bound"}


def number(text):
    try:
        return float(text)
    except ValueError:
        return None


def largest(rows):
    """The largest magnitude of each column."""
    out = {}
    for row in rows:
        for column, text in row.items():
            value = number(text)
            if value is not None:
                out[column] = max(out.get(column, 0.0), abs(value))
    return out


def cells_apart(one, other, sizes):
    """(column, texts, share of what is allowed) of each cell of two rows that differs."""
    bound = sum(number(row.get("error_bound", "")) or 0.0 for row in (one, other))
    bound += 2.0**-52
    stretch = max([abs(number(one[c])) for c in STRETCHES & one.keys() if number(one[c]) is not None], default=0.0)
    for column in one:
        if column in ERRORS or one[column] == other[column]:
            continue
        x, y = number(one[column]), number(other[column])
        if x is None or y is None:
            given_once = column.startswith("krein") and "" in (one[column], other[column])
            yield column, (one[column], other[column]), 0.0 if given_once else float("inf")
            continue
        size = stretch if column in STRETCHES else sizes[column]
        yield column, (one[column], other[column]), abs(x - y) / (bound * size)


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    first, second = map(pathlib.Path, sys.argv[1:])
    names = sorted(path.name for path in second.glob("*.csv"))
    same, within, beyond = 0, 0, 0
    for name in names:
        if not (first / name).exists():
            print(f"{name}: not in {first}")
            beyond += 1
            continue
        texts = [(directory / name).read_text(encoding="utf-8") for directory in (first, second)]
        if texts[0] == texts[1]:
            same += 1
            continue
        tables = [list(csv.DictReader(line for line in text.splitlines() if not line.startswith("#"))) for text in texts]
        if len(tables[0]) != len(tables[1]) or tables[0] and tables[0][0].keys() != tables[1][0].keys():
            print(f"{name}: {len(tables[0])} and {len(tables[1])} rows, or other columns")
            beyond += 1
            continue
        sizes = largest(tables[0] + tables[1])
        apart, worst = 0, ("", ("", ""), 0.0)
        for one, other in zip(*tables):
            for cell in cells_apart(one, other, sizes):
                apart += 1
                worst = max(worst, cell, key=lambda c: c[2])
        print(f"{name}: {apart} cells differ, the most by {worst[2]:.2g} of what is allowed {worst[0]} {worst[1]}")
        if worst[2] <= 1.0:
            within += 1
        else:
            beyond += 1
    print(f"{len(names)} tables: {same} of the same bytes, {within} within their error bounds, {beyond} not")
    sys.exit(1 if beyond or not names else 0)


if __name__ == "__main__":
    main()
