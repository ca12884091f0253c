"""What the module writes is what the program writes, byte for byte, on every shipped case."""

import os
import warnings

import pytest
import stationary
from conftest import CASES, SOURCES, lasting, run_program

# Those that results/ has an atlas of.
ATLASES = ("neo_hookean", "apart", "near_degenerate", "circle", "double_well", "two_wells", "fibre")


@pytest.fixture(autouse=True)
def beside_the_cases(monkeypatch):
    """So that both are given the same path."""
    monkeypatch.chdir(SOURCES)


def computed(call, case, **options):
    """The result, or the one that an error has."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", RuntimeWarning)
            return call(case, **options)
    except (stationary.NotFound, stationary.NumericalError) as error:
        return error.result


def compare(command, call, path, tmp_path, suffixes=(".csv",)):
    case = stationary.Case.read(path)
    result = computed(call, case, threads=1)
    for suffix in suffixes:
        theirs = tmp_path / f"program{suffix}"
        ours = tmp_path / f"module{suffix}"
        code, _, text = run_program(command, path, "-o", theirs, "--quiet", "--threads", 1)
        if result is None:
            assert not theirs.exists(), text
            continue
        result.write(ours)
        assert ours.read_bytes() == theirs.read_bytes(), (command, path, code)
        assert lasting(ours) == lasting(theirs)


def relative(path):
    return os.path.relpath(path, SOURCES)


def of(condition):
    return [pytest.param(relative(path), id=path.stem) for path in CASES if condition(path)]


def has(key):
    return lambda path: f"[{key}]" in path.read_text()


def test_there_are_cases():
    assert len(CASES) >= 28


@pytest.mark.parametrize("path", of(lambda path: True))
def test_solve(path, tmp_path):
    compare("solve", stationary.solve, path, tmp_path, (".csv", ".h5"))


@pytest.mark.parametrize("path", of(has("continuation")))
def test_follow(path, tmp_path):
    compare("continue", stationary.follow, path, tmp_path)


@pytest.mark.parametrize("path", of(has("map")))
def test_map(path, tmp_path):
    compare("map", stationary.map, path, tmp_path, (".csv", ".h5"))


@pytest.mark.parametrize("path", of(lambda path: path.stem in ATLASES))
def test_atlas(path, tmp_path):
    compare("atlas", stationary.atlas, path, tmp_path)


def test_follow_as_hdf5(tmp_path):
    compare("continue", stationary.follow, "cases/fold.toml", tmp_path, (".h5", ".hdf5"))


def test_with_keys_set(tmp_path):
    case = stationary.Case.read("cases/disc.toml").set("motion.nu", 0.3)
    case = case.set("body.J", [1.0, 1.5, 0.6]).set("output.columns", ["xi", "rho"])
    theirs, ours = tmp_path / "a.csv", tmp_path / "b.csv"
    options = ("motion.nu=0.3", "body.J=[1.0,1.5,0.6]", 'output.columns=["xi","rho"]')
    sets = [word for option in options for word in ("--set", option)]
    assert run_program("solve", "cases/disc.toml", *sets, "-o", theirs, "-q")[0] == 0
    stationary.solve(case).write(ours)
    assert ours.read_bytes() == theirs.read_bytes()
    assert lasting(ours) == lasting(theirs)


def test_from_a_row(tmp_path):
    table = tmp_path / "fold.csv"
    stationary.follow("cases/fold.toml").write(table)
    theirs, ours = tmp_path / "a.csv", tmp_path / "b.csv"
    assert (
        run_program("continue", "cases/fold.toml", "--from", f"{table}:tilt", "-o", theirs, "-q")[0]
        == 0
    )
    stationary.follow("cases/fold.toml", row=f"{table}:tilt").write(ours)
    assert ours.read_bytes() == theirs.read_bytes()
    assert lasting(ours) == lasting(theirs)


def test_threads_change_no_byte(tmp_path):
    case = stationary.Case.read("cases/fibre_map.toml")
    case = case.set({"map.x.count": 12, "map.y.count": 10})
    for threads in (1, 4):
        stationary.map(case, threads=threads).write(tmp_path / f"{threads}.csv")
    assert (tmp_path / "1.csv").read_bytes() == (tmp_path / "4.csv").read_bytes()


def test_refuses_to_replace_the_case(tmp_path):
    path = tmp_path / "case.csv"
    path.write_text((SOURCES / "cases/disc.toml").read_text())
    result = stationary.solve(path)
    with pytest.raises(stationary.InputError, match="the case file"):
        result.write(path)


def test_refuses_other_suffixes(tmp_path):
    with pytest.raises(stationary.InputError, match="suffix") as error:
        stationary.solve("cases/disc.toml").write(tmp_path / "x.xlsx")
    assert error.value.option == f"-o {tmp_path / 'x.xlsx'}"
