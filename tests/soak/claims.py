"""What a table says, held against the balance in 90 digits (balance.py) and against other commands of the program."""

import copy
import csv
import io
import json
import math
from collections import Counter
from decimal import Decimal

from balance import Balance, Shape, Unsupported
from cases import Number, anisotropic, get, numbers_of, put, toml
from checks import NotSo, require
from grammar import DONE, NONE

AXES = {"i": 0, "ii": 1, "iii": 2}
STRETCHES = ("xi", "zeta", "rho")
INNER_BOX = (2e-3, 500.0)  # well within that of solve.all


def table_rows(data):
    return list(csv.DictReader(io.StringIO(data.decode("utf-8"))))


def exact(text):
    """All digits of the double that is printed so."""
    return Number(Decimal(float(text)))


class Claims:
    """`again(words, inputs)` runs another command of the program and gives its run."""

    def __init__(self, rng, command, again):
        self.rng, self.command, self.again = rng, command, again
        self.counts = Counter()

    def check(self, run, files):
        tree = self.command.tree
        if tree is None or run.overdue:
            return
        table = self.command.table
        data = run.out if table == "-" else files.bytes.get(table)
        verb = self.command.verb
        columns = tree.get("output", {}).get("columns")
        if verb == "solve" and run.code == NONE and "no stationary ellipsoid exists" in run.err:
            self.none_exists(tree, "with stretches in" in run.err)
        if run.code != DONE or not data or table.endswith(".h5") or columns or "--part" in self.command.words:
            return
        rows = table_rows(data)
        if "--merge" in self.command.words:
            self.merged(data)
        if verb in ("solve", "continue", "atlas", "map") and "--grid" not in self.command.words:
            self.rows(tree, rows)
        if verb == "atlas" and "x.meta.json" in files.bytes and "--grid" not in self.command.words:
            self.completeness(tree, json.loads(files.bytes["x.meta.json"]))
        if verb == "solve" and tree.get("solve", {}).get("all") and "x.meta.json" in files.bytes:
            self.listed(tree, rows, json.loads(files.bytes["x.meta.json"]))
        if verb == "study" and "solve" in self.command.words:
            self.study(tree, rows)
        if verb == "sensitivity" and "--events" not in self.command.words:
            self.slopes(tree, rows)

    # Rows.

    def case_of(self, tree, row):
        """The case of one row, or None where the row does not tell all of it."""
        tree = copy.deepcopy(tree)
        branch = row["branch"]
        if "pi_G_rho" in tree.get("gravity", {}):  # g is held while one of J varies
            tree["gravity"] = {"g": Number(Balance(tree).g)}
        for name, value in row.items():
            if "/" in name and name.startswith("body"):
                return None
            if name.split(".")[0] in ("body", "potential", "gravity", "motion"):
                put(tree, name, exact(value))
        motion = tree["motion"]
        if branch in AXES:
            # Of a ν that is the program's own the double is meant, of one of the case the decimal number.
            nu = exact(row[f"nu{AXES[branch] + 1}"])
            if motion["branch"] == branch and not self.varies_spin(tree):
                nu = motion["nu"]
            tree["motion"] = {"branch": branch, "nu": nu}
        elif self.command.verb != "solve" or branch != motion["branch"]:
            return None
        return tree

    def varies_spin(self, tree):
        verb = self.command.verb
        if verb == "map":
            return any(axis["parameter"] == "nu" for axis in tree["map"].values())
        return verb == "atlas" or verb == "continue" and tree["continuation"].get("parameter", "nu") == "nu"

    def spin(self, tree, row):
        motion = tree["motion"]
        spin = [Decimal(row[f"nu{k}"]) for k in (1, 2, 3)]
        if motion["branch"] in AXES:
            spin[AXES[motion["branch"]]] = Decimal(motion["nu"])
        elif motion["branch"] in ("tilted", "oblique"):
            length = sum(each * each for each in spin).sqrt()
            spin = [each * abs(Decimal(motion["nu"])) / length for each in spin]
        return spin

    def rows(self, tree, rows):
        rows = [row for row in rows if row.get("xi") and not row.get("event") and row.get("status", "solved") == "solved"]
        rows = self.off_vertical_branches(rows)
        few = 2 if "gravity" in tree else 6
        for row in self.rng.sample(rows, min(few, len(rows))):
            case = self.case_of(tree, row)
            if case is None:
                continue
            try:
                self.bound(case, row)
                self.momenta(case, row)
            except Unsupported:
                pass
        for row in self.rng.sample(rows, min(2, len(rows))):
            case = self.case_of(tree, row)
            if case is not None and row["branch"] in AXES:
                self.solved_again(case, row)
        if rows and self.rng.random() < 0.4:
            row = self.rng.choice(rows)
            case = self.case_of(tree, row)
            if case is not None and row["branch"] in AXES and not anisotropic(case):
                self.among_all(case, row)

    def off_vertical_branches(self, rows):
        """Ellipses of one ν only: at the double next to it there are none to compare with."""
        if not self.varies_spin(self.command.tree):
            return rows
        spins = {}
        for row in rows:
            spins.setdefault((row["branch"], row.get("sheet")), []).append(tuple(row.get(f"nu{k}") for k in (1, 2, 3)))
        return [row for row in rows
                if len(spins[row["branch"], row.get("sheet")]) < 3 or len(set(spins[row["branch"], row.get("sheet")])) > 1]

    def start(self, row):
        return {name: Decimal(float(row[name] or "0")) for name in ("alpha",) + STRETCHES}

    def bound(self, case, row):
        """error_bound bounds the error of S."""
        if not row.get("error_bound"):
            return
        balance = Balance(case)
        start = self.start(row)
        found = balance.corrected(start, self.spin(case, row))
        if found is None:
            self.counts["balance: Newton's method does not converge"] += 1
            require(float(row["error_bound"]) > 1e-9, f"no solution of the balance near {row}")
            return
        bound = Decimal(row["error_bound"])
        for name in STRETCHES:
            off = abs(start[name] - found[0][name]) / found[0][name]
            require(off <= bound, f"{name} is off by {float(off):.3g}, error_bound {row['error_bound']}: {row}")
        self.counts["error bounds"] += 1

    def momenta(self, case, row):
        """π = Iν, and the energy."""
        if case["motion"]["branch"] == "two-polar" or not row.get("pi1"):
            return
        balance = Balance(case)
        shape = Shape(**self.start(row))
        spin = self.spin(case, row)
        i11, i22, i33, i12 = balance.locked_inertia(shape)
        meant = (i11 * spin[0] + i12 * spin[1], i12 * spin[0] + i22 * spin[1], i33 * spin[2])
        scale = max(map(abs, meant))
        slack = Decimal("1e-14") + 8 * Decimal(row.get("error_bound") or "0")
        for k, value in enumerate(meant):
            require(abs(Decimal(row[f"pi{k + 1}"]) - value) <= slack * scale, f"pi{k + 1} is not {value:.17g}: {row}")
        turning = balance.rotational(shape, spin)
        energy = balance.potential(shape) + turning
        size = turning + sum(abs(each(shape)) for each in balance.terms) + 1
        require(abs(Decimal(row["energy"]) - energy) <= 10 * slack * size, f"energy is not {energy:.17g}: {row}")
        self.counts["momenta, energies"] += 1

    def alone(self, case, **more):
        """The case with nothing but body, potential, motion and this; numbers of a table as it prints them."""
        out = {name: copy.deepcopy(case[name]) for name in ("body", "gravity", "potential", "motion") if name in case}
        out["solve"] = more
        for name in numbers_of(out) + ["motion.nu"]:
            put(out, name, Number(as_read(get(out, name))))
        return {"again.toml": toml(out).encode()}

    def solved_again(self, case, row):
        """`solve` started at the row has its S and its class."""
        start = [Number(row[name] or "0") for name in ("alpha",) + STRETCHES]
        run = self.again(["solve", "again.toml", "-q", "-o", "-"], self.alone(case, start=start))
        slack = 1e-12 + 10 * float(row.get("error_bound") or "inf")
        if slack > 1e-6:
            return
        require(run.code == DONE, f"solve finds nothing at {row}: {run.err.strip()[:200]}")
        mine = table_rows(run.out)[0]
        slack += 10 * float(mine["error_bound"])
        for name in STRETCHES:
            off = abs(float(mine[name]) / float(row[name]) - 1)
            require(off <= slack, f"solve started at the row has another {name}, off by {off:.3g}: {row}")
        both = {mine["class"], row.get("class") or mine["class"]}
        require(len(both) == 1 or "marginal" in both, f"class {row.get('class')}, by solve {mine['class']}: {row}")
        self.counts["classes"] += 1

    # What there is and is not.

    def all_of(self, case):
        """Rows of solve.all, and whether they are said to be all in the box."""
        run = self.again(["solve", "again.toml", "-q", "-o", "-", "--certify"], self.alone(case, all=True))
        if run.overdue:
            return [], False
        require(run.code in (DONE, NONE) or run.err, "solve.all fails and says nothing")
        rows = table_rows(run.out) if run.out else []
        complete = run.code == DONE and not run.err or run.code == NONE and "no stationary ellipsoid exists" in run.err
        return rows, complete

    def is_among(self, case, q, slack, rows):
        """Whether these stretches are of one of the rows; where J1 = J2 in (iii) the angle is free."""
        J = case["body"]["J"]
        free = float(J[0]) == float(J[1]) and case["motion"]["branch"] == "iii"
        for row in rows:
            theirs = [float(row[name]) for name in STRETCHES]
            mine = [float(q[name]) for name in STRETCHES]
            if free:
                theirs[:2], mine[:2] = sorted(theirs[:2]), sorted(mine[:2])
            near = slack + 2 * float(row["error_bound"] or 0)
            if all(abs(a / b - 1) <= near for a, b in zip(theirs, mine)):
                return True
        return False

    def inside(self, q):
        return all(INNER_BOX[0] < float(q[name]) < INNER_BOX[1] for name in STRETCHES)

    def among_all(self, case, row):
        """The exhaustive search has the row; whatever Newton's method finds from random starts it has too."""
        rows, complete = self.all_of(case)
        if not complete:
            return
        slack = 1e-12 + 2 * float(row.get("error_bound") or 1)
        if self.inside(row) and slack < 1e-3:
            require(self.is_among(case, row, slack, rows), f"solve.all of {case['motion']} has not this: {row}")
            self.counts["rows among all"] += 1
        self.no_others(case, rows, True)

    def no_others(self, case, rows, in_box):
        if "gravity" in case or anisotropic(case) or case["motion"]["branch"] not in AXES:
            return
        try:
            balance = Balance(case)
        except Unsupported:
            return
        spin = [Decimal(0)] * 3
        spin[AXES[case["motion"]["branch"]]] = Decimal(case["motion"]["nu"])
        for _ in range(6):
            start = {name: Decimal(repr(math.exp(self.rng.uniform(-1.6, 1.6)))) for name in STRETCHES}
            start["alpha"] = Decimal(0)
            found = balance.corrected(start, spin, 25, renewed=True)
            if found and (not in_box or self.inside(found[0])):
                require(self.is_among(case, found[0], 1e-12, rows),
                        f"{case['motion']}: said to be all or none, and there is "
                        f"{ {n: float(v) for n, v in found[0].items()} }")
        self.counts["no others"] += 1

    def none_exists(self, tree, in_box):
        case = copy.deepcopy(tree)
        self.no_others(case, [], in_box)
        self.counts["none exists"] += 1

    def listed(self, tree, rows, told):
        """The counts of solve.all are those of its rows."""
        counts = told["counts"]
        require(counts["proven"] + counts["found_unproven"] == len(rows) == told["rows"],
                f"counts {counts}, {len(rows)} rows")
        if rows and "certified" in rows[0]:
            proven = sum(row["certified"] in ("yes", "assuming") for row in rows)
            require(proven <= len(rows), f"{proven} certified")
        self.counts["counts of solve.all"] += 1

    def completeness(self, tree, told):
        """Where the number of sheets is proven, solve.all within has so many motions."""
        proven = [each for each in told.get("completeness", [])
                  if each["status"] == "proven" and each["branch"] in AXES and each["to"] > each["from"]]
        for each in self.rng.sample(proven, min(2, len(proven))):
            case = copy.deepcopy(tree)
            nu = each["from"] + (each["to"] - each["from"]) * self.rng.uniform(0.2, 0.8)
            case["motion"] = {"branch": each["branch"], "nu": Number(repr(nu))}
            if "solve" in case:
                continue
            rows, complete = self.all_of(case)
            if complete:
                require(len(rows) == each["sheets"], f"{each}, and at {nu} there are {len(rows)}")
                self.counts["proven intervals"] += 1

    # Other tables.

    def merged(self, data):
        """Parts put together are the table of one run."""
        words = self.command.words[:self.command.words.index("--merge")]
        words[words.index("x.csv")] = "-"
        inputs = {name: each for name, each in self.command.inputs.items() if not name.startswith("p")}
        whole = self.again(words, inputs)
        require(whole.out == data, "parts put together are not the table of one run")
        self.counts["merged parts"] += 1

    def study(self, tree, rows):
        """A row of a study is the row that `solve` writes."""
        named = [n for n in (rows[0] if rows else {}) if n.split(".")[0] in ("body", "potential", "gravity", "motion")]
        solved = [row for row in rows if row["status"] == "solved" and row.get("sheet", "1") in ("", "1")]
        for row in self.rng.sample(solved, min(1, len(solved))):
            case = copy.deepcopy(tree)
            words = ["solve", "again.toml", "-q", "-o", "-"] + ["--certify"] * ("--certify" in self.command.words)
            for name in named:
                if row[name]:
                    words += ["--set", f"{name}={row[name]}"]
            run = self.again(words, {"again.toml": toml(case).encode()})
            require(run.code == DONE, f"solve says {run.code} of a study's row: {row}")
            mine = table_rows(run.out)[0]
            other = [name for name in mine if name in row and name not in named and mine[name] != row[name]]
            require(not other, f"solve has {[(n, mine[n], row[n]) for n in other]}")
            self.counts["rows of studies"] += 1

    def slopes(self, tree, rows):
        """∂S/∂(number), by the balance at neighbours 10⁻²⁵ away."""
        if tree["motion"]["branch"] not in AXES or "solve" in tree or "gravity" in tree:
            return
        rows = [row for row in rows if row["of"] == "motion" and row["error"] and row.get("d_xi")
                and (row["number"] == "nu" or row["number"] in numbers_of(tree))]
        base = self.again(["solve", "again.toml", "-q", "-o", "-"], self.alone(tree))
        if base.code != DONE or not rows:
            return
        at = table_rows(base.out)[0]
        spin = self.spin(tree, at)
        for row in self.rng.sample(rows, min(3, len(rows))):
            step, found = Decimal("1e-25"), []
            for sign in (1, -1):
                case, turned = copy.deepcopy(tree), list(spin)
                name = row["number"]
                if name == "nu":
                    turned[AXES[tree["motion"]["branch"]]] += sign * step
                else:
                    put(case, name, Number(Decimal(get(case, name)) + sign * step))
                try:
                    found.append(Balance(case).corrected(self.start(at), turned))
                except Unsupported:
                    return
            if None in found:
                continue
            for name in STRETCHES:
                slope = (found[0][0][name] - found[1][0][name]) / (2 * step)
                off = abs(slope - Decimal(row["d_" + name] or "0"))
                require(off <= Decimal(row["error"]) * Decimal("1.001") + abs(slope) * Decimal("1e-15"),
                        f"d_{name} is off by {float(off):.3g}, error {row['error']}: {row}")
            self.counts["slopes"] += 1


def as_read(text):
    """A double's digits, of which there may be hundreds, as short as they are read alike."""
    return text if len(text) < 25 else repr(float(text))
