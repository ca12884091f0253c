"""Studies over files, frames, arrays and dicts; curves of events."""

import numpy as np
import pytest
import stationary
from conftest import SOURCES, run_program

CASE = SOURCES / "cases" / "disc.toml"


def test_rows_are_those_of_solve(disc):
    table = {"motion.nu": [0.3, 0.5], "body.J.1": np.array([1.5, 1.7]), "_name": ["a", "b"]}
    found = stationary.study(disc, table)
    assert found["study_row"].tolist() == [1, 2]
    assert found["_name"].tolist() == ["a", "b"]
    assert found["status"].tolist() == ["solved"] * 2
    for row, nu, J2 in zip(found.table, *list(table.values())[:2]):
        alone = stationary.solve(stationary.Case(disc).set({"motion.nu": nu, "body.J.1": J2}))
        for name in alone.table.dtype.names:
            assert row[name] == alone.table[name][0], name


def test_what_is_missing_in_the_only_column_is_a_row(disc, tmp_path):
    found = stationary.study(disc, {"motion.nu": [0.1, None, None]})
    assert len(found) == 3 and found["nu1"].tolist() == [0.1, 0.5, 0.5]
    assert len(stationary.study(disc, {"motion.nu": [None]})) == 1
    table, out = tmp_path / "t.csv", tmp_path / "a.csv"
    table.write_text('motion.nu\n0.1\n""\n\n')  # an empty line at the end is none
    assert run_program("study", CASE, "--over", table, "-o", out, "-q")[0] == 0
    assert len(out.read_text().splitlines()) == 3


@pytest.mark.parametrize("do", ["solve", "continue", "atlas"])
def test_is_the_program_s(do, tmp_path):
    table, theirs, ours = (tmp_path / name for name in ("t.csv", "a.csv", "b.csv"))
    table.write_text("body.J.1,potential.plane.c\n1.5,\n1.6,1.25\n")
    words = ("--do", do, "--set", "continuation.tolerance=1e-6", "-o", theirs, "-q")
    if do == "atlas":
        words += ("--checkpoints", 2)
    assert run_program("study", CASE, "--over", table, *words)[0] == 0
    columns = {"body.J.1": [1.5, 1.6], "potential.plane.c": [None, 1.25]}
    case = stationary.Case.read(CASE).set("continuation.tolerance", 1e-6)
    stationary.study(case, columns, do, checkpoints=2 if do == "atlas" else None).write(ours)
    assert ours.read_bytes() == theirs.read_bytes()


def test_kinds_of_tables(disc):
    columns = {"motion.nu": [0.3, 0.4, 0.5], "motion.branch": ["i", "ii", "iii"]}
    asked = stationary.study(disc, columns).table
    records = np.zeros(3, [("motion.nu", float), ("motion.branch", "U3")])
    for name, cells in columns.items():
        records[name] = cells
    assert stationary.study(disc, records).table.tobytes() == asked.tobytes()
    pandas = pytest.importorskip("pandas")
    assert stationary.study(disc, pandas.DataFrame(columns)).table.tobytes() == asked.tobytes()


def test_a_column_twice_is_refused_as_the_program_does(disc, tmp_path):
    pandas = pytest.importorskip("pandas")
    frame = pandas.DataFrame([["a", "b", 0.1], ["c", "d", 0.2]], columns=["_n", "_n", "motion.nu"])
    frame.to_csv(tmp_path / "t.csv", index=False)
    over, out = tmp_path / "t.csv", tmp_path / "a.csv"
    code, _, text = run_program("study", CASE, "--over", over, "-o", out)
    assert code == 2
    for table in (frame, {1: [0.1], "1": [0.2]}):
        with pytest.raises(stationary.InputError, match="twice") as error:
            stationary.study(disc, table)
        _, _, words = str(error.value).partition("found the column ")
        assert text.rstrip("\n").endswith(words.replace('"1"', '"_n"'))


def test_whole_numbers_of_a_study(disc):
    with pytest.warns(RuntimeWarning, match="1 of 2 rows failed"):
        table = stationary.study(disc, {"motion.nu": [0.1, "fast"]}).table
    kinds = {name: table.dtype[name] for name in ("study_row", "sheet", "point")}
    assert kinds == {"study_row": np.int64, "sheet": np.float64, "point": np.float64}
    assert np.isnan(table["sheet"][-1]) and np.isnan(table["point"][-1])


def test_cells_of_every_kind(disc):
    found = stationary.study(
        disc,
        {
            "body.J": [[1.0, 1.7, 0.6], (1.0, 1.5, 0.6), None],
            "solve.all": [False, True, np.nan],
            "potential.plane": [None, None, {"model": "hencky", "mu": 1.1, "lambda": 0.8}],
            "_x": [1, 2.5, True],
            "motion.nu": np.array([0.5, 0.3, 0.1], np.longdouble),
        },
    )
    assert found["status"].tolist() == ["solved"] * 3
    assert found["_x"].tolist() == ["1", "2.5", "True"]
    assert found["xi"][0] == stationary.solve(disc)["xi"][0]


@pytest.mark.parametrize("unit", ["D", "s", "ns"])
def test_dates_and_bytes_are_carried_through(disc, unit):
    found = stationary.study(
        disc,
        {
            "_date": np.array(["2026-01-01", "NaT"], f"datetime64[{unit}]"),
            "_material": np.array([b"soft", b"hard"]),
            "motion.branch": np.array([b"i", b"ii"]),
        },
    )
    assert found["status"].tolist() == ["solved"] * 2
    dates = found["_date"].tolist()
    assert dates[0].startswith("2026-01-01") and dates[1] == ""
    assert found["_material"].tolist() == ["soft", "hard"]
    assert found["branch"].tolist() == ["i", "ii"]


def test_a_case_that_is_one_only_with_a_row_s_values(disc):
    del disc["motion"]["nu"]
    found = stationary.study(disc, {"motion.nu": [0.2, 0.5]})
    assert found["status"].tolist() == ["solved"] * 2
    with pytest.raises(stationary.InputError, match="nu"):
        found.case
    assert "rows" in repr(found)


def test_bad_rows_are_rows(disc):
    with pytest.warns(RuntimeWarning, match="2 of 3 rows failed, the first of them row 1"):
        found = stationary.study(disc, {"motion.nu": ["fast", 0.5, 0.4], "body.J.0": [1, 1, -1.0]})
    assert found["status"].tolist() == ["bad-input", "solved", "bad-input"]
    assert "fast" in found["message"][0] and np.isnan(found["xi"][0])
    assert found.metadata["counts"]["bad-input"] == 2
    with pytest.warns(RuntimeWarning, match="1 of 1 rows failed"):
        assert len(stationary.study(disc, {"motion.nu": ["fast"]})) == 1


@pytest.mark.parametrize(
    ("table", "text"),
    [
        ({"motion.nuu": [1.0]}, "did you mean"),
        ({"motion.nu": []}, "no rows"),
        ({"motion.nu": [0.1, 0.2], "body.J.1": [1.0]}, "as many values"),
        ({"motion.nu": 0.3}, "a column of values"),
        ({"motion.nu": "0.3"}, "a column of values"),
        ({"motion.nu": [object()]}, "object"),
        ({}, "found"),
        (3, "a path, a DataFrame"),
        ("nowhere.csv", "nowhere.csv"),
    ],
)
def test_wrong_tables(disc, table, text):
    with pytest.raises(stationary.InputError, match=text):
        stationary.study(disc, table)


def test_wrong_options(disc):
    table = {"motion.nu": [0.1]}
    with pytest.raises(stationary.InputError, match="did you mean"):
        stationary.study(disc, table, "solv")
    with pytest.raises(stationary.InputError, match="checkpoints"):
        stationary.study(disc, table, "atlas", checkpoints=0)
    with pytest.raises(stationary.InputError, match="threads"):
        stationary.study(disc, table, threads=0)


def test_does_not_replace_its_table(disc, tmp_path):
    path = tmp_path / "t.csv"
    path.write_text("motion.nu\n0.3\n")
    with pytest.raises(stationary.InputError, match="the table that it was computed from"):
        stationary.study(disc, path).write(path)
    assert path.read_text() == "motion.nu\n0.3\n"


def test_threads_change_no_byte(disc, tmp_path):
    table = {"motion.nu": np.linspace(0.0, 0.9, 100)}
    for threads in (1, 4):
        stationary.study(disc, table, threads=threads).write(tmp_path / f"{threads}.csv")
    assert (tmp_path / "1.csv").read_bytes() == (tmp_path / "4.csv").read_bytes()


def test_frame_is_as_pandas_reads_the_file(disc, tmp_path):
    pandas = pytest.importorskip("pandas")
    with pytest.warns(RuntimeWarning):
        found = stationary.study(disc, {"_name": ["µ", "a, b"], "motion.nu": [0.3, "fast"]})
    found.write(tmp_path / "x.csv")
    read = pandas.read_csv(tmp_path / "x.csv", float_precision="round_trip")
    pandas.testing.assert_frame_equal(found.to_pandas(), read, check_dtype=False, check_exact=True)


CURVE = {
    "curve.event": "fold-nu",
    "curve.parameters": ["nu", "potential.plane.mu"],
    "curve.from": [0.0, 0.5],
    "curve.to": [2.5, 3.0],
    "curve.tolerance": 1e-6,
}


@pytest.fixture(scope="module")
def folds():
    return stationary.curve(stationary.Case.read(SOURCES / "cases" / "circle.toml").set(CURVE))


def test_curve_of_an_event(folds):
    assert set(folds["event"].tolist()) == {"fold-nu"}
    assert folds["curve"].dtype == folds["point"].dtype == np.int64
    assert (folds["nu"] == folds["nu3"]).all()
    assert len(folds.metadata["curves"]) == folds["curve"].max()
    assert folds.metadata["run"]["command_line"] == ["stationary.curve"]
    row = folds.table[len(folds) // 2]
    case = folds.case.set("potential.plane.mu", float(row["potential.plane.mu"]))
    located = [each["parameter"] for each in stationary.follow(case).events]
    assert min(abs(nu - row["nu"]) for nu in located) < 1e-9


def test_curve_from_a_row(folds, tmp_path):
    table = tmp_path / "family.csv"
    stationary.follow(folds.case).write(table)
    again = stationary.curve(folds.case, row=f"{table}:fold-nu")
    assert again["nu"].max() == pytest.approx(folds["nu"].max(), rel=1e-6)
    with pytest.raises(stationary.InputError, match="tilt"):
        stationary.curve(folds.case, row=f"{table}:tilt")


def test_curve_that_is_none(folds, disc):
    with pytest.raises(stationary.InputError, match=r"add \[curve\]"):
        stationary.curve(disc)
    with pytest.raises(stationary.NotFound, match="no hamiltonian-hopf"):
        stationary.curve(folds.case.set("curve.event", "hamiltonian-hopf"))
