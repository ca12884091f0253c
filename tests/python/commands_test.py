"""Results of solve, follow, atlas and map: tables, metadata, words."""

import contextlib
import json
import os
import pickle
import subprocess
import sys

import numpy as np
import pytest
import stationary
from conftest import SOURCES, SUFFIXES, run_program

FOLD = SOURCES / "cases" / "fold.toml"


@pytest.fixture(scope="module")
def fold():
    return stationary.follow(FOLD)


def test_table_has_the_columns_of_the_csv(fold, tmp_path):
    fold.write(tmp_path / "fold.csv")
    header = (tmp_path / "fold.csv").read_text().splitlines()[0].split(",")
    assert list(fold.table.dtype.names) == header
    assert len(fold) == len(fold.table) == fold.metadata["rows"]
    kinds = {name: fold.table.dtype[name].kind for name in header}
    assert {kinds[name] for name in ("branch", "event", "class")} == {"U"}
    assert {kinds[name] for name in ("sheet", "point")} == {"i"}
    assert all(kind == "f" for name, kind in kinds.items() if kind not in "Ui")
    assert fold["point"].tolist() == list(range(len(fold)))


def test_table_is_read_only_and_outlives_its_result(fold):
    with pytest.raises(ValueError):
        fold.table["xi"] = 0.0
    column = stationary.solve(FOLD).table["xi"]
    for _ in range(100):
        stationary.solve(FOLD)
    assert column[0] == stationary.solve(FOLD).table["xi"][0]


def test_metadata_and_what_is_in_them(fold, tmp_path):
    fold.write(tmp_path / "fold.csv")
    assert fold.metadata == json.loads((tmp_path / "fold.meta.json").read_text())
    assert fold.metadata["run"]["command_line"] == ["stationary.follow"]
    names = [event["event"] for event in fold.events]
    assert "fold-nu" in names and "tilt" in names
    for event in fold.events:
        row = fold.table[event["point"]]
        assert (row["event"], row["nu1"]) == (event["event"], pytest.approx(event["parameter"], abs=1e-15))
    assert [each["segment"] for each in fold.segments] == list(range(1, len(fold.segments) + 1))


def test_shows_the_program_s_summary(fold):
    _, text, _ = run_program("continue", FOLD)

    def lasting(lines):  # but for seconds
        return [line for line in lines.splitlines() if not line.startswith("points")]

    assert lasting(fold.summary) == lasting(text)
    assert repr(fold) == fold.summary
    assert fold._repr_html_().startswith("<pre>")
    assert "&lt;" in fold._repr_html_() or "<" not in fold.summary


def test_goes_to_other_processes(fold, disc, tmp_path):
    study = stationary.study({**disc, "motion": {"branch": "i"}}, {"motion.nu": [0.1, 0.2]})
    for result in (fold, stationary.solve(disc), study):
        other = pickle.loads(pickle.dumps(result))
        assert other.table.tobytes() == result.table.tobytes() and repr(other) == repr(result)
        assert other.metadata == result.metadata
        for suffix in SUFFIXES:
            result.write(tmp_path / f"a{suffix}")
            other.write(tmp_path / f"b{suffix}")
            assert (tmp_path / f"a{suffix}").read_bytes() == (tmp_path / f"b{suffix}").read_bytes()
    assert pickle.loads(pickle.dumps(fold)).case == fold.case


@pytest.mark.parametrize("protocol", range(pickle.HIGHEST_PROTOCOL + 1))
def test_is_pickled_by_every_protocol(protocol, disc):
    """In another process: by the protocols 0 and 1 this has ended the interpreter."""
    code = (
        "import pickle, stationary\n"
        f"disc = {disc!r}\n"
        "solved = stationary.solve(disc)\n"
        "del disc['motion']['nu']\n"
        "study = stationary.study(disc, {'motion.nu': [0.1]})\n"
        "for each in (solved, study, solved.case, solved.case.body, solved.case.potential):\n"
        f"    other = pickle.loads(pickle.dumps(each, {protocol}))\n"
        "    assert repr(other) == repr(each), each\n"
        "    if isinstance(each, stationary.Result):\n"
        "        assert other.table.tobytes() == each.table.tobytes()\n"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr


def test_no_such_column(fold):
    with pytest.raises(KeyError, match="no column 'xii'; there are branch, sheet"):
        fold["xii"]
    assert [row["point"] for row in fold] == fold["point"].tolist()


def test_atlas_has_every_sheet():
    result = stationary.atlas(SOURCES / "cases" / "apart.toml", checkpoints=8)
    sheets = {sheet["sheet"] for sheet in result.metadata["sheets"]}
    assert set(result["sheet"].tolist()) == sheets
    assert len(result.metadata["checkpoints"]) % 8 == 0


def test_atlas_is_proven_for_every_nu():
    case = SOURCES / "cases" / "apart.toml"
    assert "completeness" not in stationary.atlas(case, checkpoints=2).metadata
    metadata = stationary.atlas(case, checkpoints=2, complete=True).metadata
    proven = metadata["completeness"]
    classes = [sum(each["sheets"].values()) for each in metadata["classes"] if each["status"] == "proven"]
    assert max(classes) == max(each["sheets"] for each in proven if each["status"] == "proven")
    assert {each["branch"] for each in proven} == {"i", "ii", "iii", "tilted"}
    sheets = [each["sheets"] for each in proven if each["status"] == "proven"]
    assert sheets and max(sheets) >= 1


def test_map_keeps_its_cells_whatever_they_came_to(disc):
    disc["map"] = {"x": {"parameter": "nu", "from": 0.0, "to": 30.0, "count": 7}}
    result = stationary.map(disc)
    assert result["nu"].tolist() == np.linspace(0.0, 30.0, 7).tolist()
    assert result["status"][0] == "solved"
    assert set(result["status"]) > {"solved"}


def test_a_map_without_any_solution_warns():
    case = stationary.Case.read(SOURCES / "cases" / "too_fast.toml")
    nu = case["motion.nu"]
    case = case.set("map", {"x": {"parameter": "nu", "from": nu, "to": nu + 1.0, "count": 3}})
    with pytest.warns(RuntimeWarning, match="no stationary ellipsoid in any of 3 cells"):
        result = stationary.map(case)
    assert len(result) == 3


def test_texts_are_plain_in_a_terminal_too():
    code = (
        "import stationary\n"
        f"result = stationary.solve({str(FOLD)!r})\n"
        "for each in (result, result.case, stationary.models()): print(repr(each))\n"
    )
    main, terminal = os.openpty()
    with subprocess.Popen([sys.executable, "-c", code], stdout=terminal) as child:
        os.close(terminal)
        shown = b""
        with contextlib.suppress(OSError):  # how the end of a terminal is told
            while more := os.read(main, 65536):
                shown += more
    os.close(main)
    assert child.returncode == 0 and b"hencky" in shown and b"\x1b" not in shown


def test_models_are_the_program_s():
    models = stationary.models()
    assert repr(models) == run_program("models")[1].rstrip("\n")
    assert str(models["hencky"]) == run_program("models", "hencky")[1].rstrip("\n")
    assert models["hencky"].parameters == ["mu", "lambda"] and models["hencky"].slot == "plane"
    assert {each.slot for each in models.values()} == {"plane", "thickness", "coupled", "fibre"}
    assert "mu &gt; 0" in models["hencky"]._repr_html_() and "&gt;" in models._repr_html_()
    with pytest.raises(stationary.InputError, match="did you mean"):
        models["henky"]


def test_the_version_is_the_program_s():
    assert stationary.__version__ in run_program("--version")[1].splitlines()[0].split()


def test_how_a_motion_moves_with_its_numbers(disc):
    result = stationary.sensitivity(disc)
    by_nu = result.table[result["number"] == "nu"][0]
    ahead, behind = (
        stationary.solve(disc | {"motion": {"branch": "i", "nu": nu}})["xi"][0]
        for nu in (0.5001, 0.4999)
    )
    assert by_nu["d_xi"] == pytest.approx((ahead - behind) / 2e-4, rel=1e-6)
    assert by_nu["error"] < 1e-9


def test_how_events_move_with_the_numbers(disc):
    case = disc | {
        "output": {"uncertainty": {"body.J.0": 0.01}},
        "continuation": {"from": 0.0, "to": 1.1},
    }
    result = stationary.sensitivity(case, events=True)
    assert "tilt" in result["of"]
    combined = result.table[result["number"] == "combined"]
    assert len(combined) == len(set(result["at"]))
    assert (combined["d_event"] > 0).all()
