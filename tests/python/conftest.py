"""What the tests of the Python module share: the program, the shipped cases, small cases."""

import json
import os
import re
import subprocess
from pathlib import Path

import pytest

SOURCES = Path(os.environ["STATIONARY_SOURCES"])
CASES = sorted((SOURCES / "cases").glob("*.toml"))


def run_program(*arguments, **options):
    """Runs the program `stationary`; its exit code, standard output and standard error."""
    done = subprocess.run(
        [os.environ["STATIONARY_PROGRAM"], *map(str, arguments)],
        capture_output=True,
        text=True,
        check=False,
        **options,
    )
    return done.returncode, done.stdout, done.stderr


HDF5 = not re.search(r"^HDF5 +built without", run_program("--version")[1], re.MULTILINE)
# Ends of the names of tables that it can write.
SUFFIXES = (".csv", ".h5") if HDF5 else (".csv",)


def start_program(*arguments):
    """The same while something else is done."""
    return subprocess.Popen(
        [os.environ["STATIONARY_PROGRAM"], *map(str, arguments)],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )


def lasting(path):
    """The metadata beside a table, in their order, without what depends on the run."""
    metadata = json.loads(
        path.with_suffix(".meta.json").read_text(), object_pairs_hook=list
    )
    return [(key, value) for key, value in metadata if key != "run"]


@pytest.fixture
def disc():
    """The keys of cases/disc.toml."""
    return {
        "title": "Thin disc, reciprocal-determinant potential",
        "body": {"J": [1.0, 1.7, 0.6]},
        "potential": {
            "plane": {"model": "reciprocal-determinant", "c": 1.0, "k": 2.0},
            "thickness": {"model": "reciprocal-quadratic", "a": 1.0, "b": 3.0},
        },
        "motion": {"branch": "i", "nu": 0.5},
        "continuation": {"parameter": "nu", "from": 0.0, "to": 1.05, "tolerance": 1e-10},
    }
