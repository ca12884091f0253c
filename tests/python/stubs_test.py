"""The package's types: mypy's stubtest on the stubs, mypy on the package and on a user's file."""

import os
import subprocess
import sys
from pathlib import Path

import pytest
import stationary

pytest.importorskip("mypy")
PACKAGE = Path(stationary.__file__).parent


def run(*arguments, cwd):
    (cwd / "mypy.ini").write_text(
        "[mypy]\nstrict = True\nignore_missing_imports = True\n"
        # Their types are large, and only named here.
        "[mypy-pandas.*,xarray.*,matplotlib.*,sympy.*]\nfollow_imports = skip\n"
    )
    cache = str(cwd.parent / "cache")  # NumPy's types are read once
    environment = {**os.environ, "MYPYPATH": str(PACKAGE.parent), "MYPY_CACHE_DIR": cache}
    done = subprocess.run(
        [sys.executable, "-m", *arguments], capture_output=True, text=True, cwd=cwd, check=False,
        env=environment,
    )
    assert done.returncode == 0, done.stdout + done.stderr


def test_stubs_agree_with_the_module(tmp_path):
    # The signatures of compiled functions are not to be seen by stubtest: names and kinds are. A class's
    # own entry is left out, for its metaclass is pybind11's, and its constructor; its members are compared.
    classes = [name for name, what in vars(stationary._core).items() if isinstance(what, type)]
    left_out = [f"stationary._core.{name}{part}\n" for name in classes for part in ("", ".__init__")]
    (tmp_path / "classes.txt").write_text("".join(left_out))
    run(
        "mypy.stubtest", "stationary._core", "--ignore-missing-stub", "--mypy-config-file", "mypy.ini",
        "--allowlist", "classes.txt", "--ignore-unused-allowlist",
        cwd=tmp_path,
    )


def test_package_is_typed(tmp_path):
    run("mypy", "-p", "stationary", cwd=tmp_path)


def test_a_user_s_types(tmp_path):
    (tmp_path / "user.py").write_text(
        "import stationary\n"
        "case: stationary.Case = stationary.Case.read('x.toml').set('motion.nu', 0.3)\n"
        "result: stationary.Result = stationary.follow(case, threads=2)\n"
        "names: list[str] = [event['event'] for event in result.events]\n"
    )
    run("mypy", "user.py", cwd=tmp_path)
    (tmp_path / "wrong.py").write_text("import stationary\nstationary.solve(3)\n")
    with pytest.raises(AssertionError, match="incompatible type"):
        run("mypy", "wrong.py", cwd=tmp_path)


def test_everything_public_is_documented():
    for name in stationary.__all__:
        if not name.startswith("__") and not isinstance(getattr(stationary, name), str):
            assert getattr(stationary, name).__doc__, name
