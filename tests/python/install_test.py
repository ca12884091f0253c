"""pip install --no-index --no-build-isolation . in a virtual environment with the system's packages."""

import os
import subprocess
import sys
import venv

from conftest import SOURCES


def test_pip_installs_it(tmp_path):
    venv.EnvBuilder(system_site_packages=True, symlinks=True, with_pip=True).create(tmp_path / "venv")
    python = tmp_path / "venv" / "bin" / "python"
    outside = {key: value for key, value in os.environ.items() if key != "PYTHONPATH"}
    subprocess.run(
        [python, "-m", "pip", "install", "--quiet", "--no-index", "--no-build-isolation", SOURCES],
        check=True,
        env={**outside, "STATIONARY_BUILD": os.environ["STATIONARY_TREE"]},
    )
    code = (
        "import stationary; print(stationary.__file__); "
        f"print(stationary.solve({str(SOURCES / 'cases/disc.toml')!r}).table['class'][0])"
    )
    out = subprocess.check_output([python, "-c", code], text=True, env=outside, cwd=tmp_path)
    path, verdict = out.split()
    assert path.startswith(str(tmp_path / "venv")) and verdict == "unstable"
    assert sys.version_info[:2] >= (3, 9)
    left = subprocess.check_output(["git", "status", "--short"], cwd=SOURCES, text=True)
    assert "egg-info" not in left and "build/lib" not in left
