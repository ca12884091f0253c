"""Cases from dictionaries of anything: what is wrong is said by an exception, and nothing else happens.

The test tries a few thousand from a fixed seed; by hand, any number:

    PYTHONPATH=build/release/python python3 tests/python/fuzz_case_test.py COUNT [SEED]
"""

import copy
import os
import random
import sys
import tomllib
from pathlib import Path

import numpy as np
import stationary

ATOMS = [
    0, -1, 1, 0.0, -0.0, 0.5, 1e308, -1e308, 5e-324, float("nan"), float("inf"), 2**63, 10**400, True, False, None,
    "", "i", "iii", "tilted", "123", "nu", "biot", "\0", "\ud800", "x" * 5000, b"i", (1.0, 2.0), [], {}, [[1.0]], {1: 2},
    np.float64(1.5), np.float32(0.1), np.int64(3), np.array([1.0, 1.7, 0.6]), np.array([[1.0]]), np.datetime64("2026-01-01"),
    object(), {1, 2}, range(3), complex(1, 1), Path("x"), "1e5", "1 + rho",
]  # fmt: skip
KEYS = [
    "body", "J", "volume", "gravity", "g", "pi_G_rho", "potential", "plane", "thickness", "coupled", "fibre", "model", "k", "mu",
    "lambda", "expression", "motion", "branch", "nu", "s3", "p_theta", "omega", "solve", "start", "all", "box", "continuation",
    "from", "to", "parameter", "output", "columns", "uncertainty", "map", "x", "y", "count", "title", "", "\ud800", 3, None,
]  # fmt: skip


def seeds():
    sources = Path(os.environ.get("STATIONARY_SOURCES", Path(__file__).parents[2]))
    return [tomllib.loads(path.read_text()) for path in sorted((sources / "cases").glob("*.toml"))]


def places(tree, parent=None, key=None):
    """Every node but the root, with its parent and key."""
    if parent is not None:
        yield parent, key
    if isinstance(tree, dict):
        for k in list(tree):
            yield from places(tree[k], tree, k)
    elif isinstance(tree, list):
        for k in range(len(tree)):
            yield from places(tree[k], tree, k)


def mutated(rng, trees):
    tree = copy.deepcopy(rng.choice(trees))
    for _ in range(rng.randint(1, 3)):
        at = list(places(tree))
        if not at:
            break
        parent, key = rng.choice(at)
        deed = rng.randrange(5)
        if deed == 0:
            del parent[key]
        elif deed == 1:
            parent[key] = rng.choice(ATOMS)
        elif deed == 2 and isinstance(parent, dict):
            parent[rng.choice(KEYS)] = rng.choice(ATOMS)
        elif deed == 3:
            other = rng.choice(list(places(rng.choice(trees))))
            parent[key] = copy.deepcopy(other[0][other[1]])
        elif isinstance(parent[key], (int, float)) and not isinstance(parent[key], bool):
            parent[key] = min(parent[key], 1e300) * rng.choice([-1.0, 1e-12, 1e12, 1.0 + 1e-15, 1e300])
        else:
            parent[key] = [copy.deepcopy(parent[key])] * rng.randint(0, 4)
    if rng.random() < 0.01:  # a tree in itself
        tree["body"] = tree
    return tree


def run(count, seed):
    """How many were cases, and how many were refused."""
    rng = random.Random(seed)
    trees = seeds()
    whole = refused = 0
    for _ in range(count):
        tree = mutated(rng, trees)
        try:
            stationary.Case(tree)
            whole += 1
        except (stationary.Error, TypeError, ValueError, RecursionError) as error:
            assert str(error), tree
            refused += 1
    return whole, refused


def test_anything():
    whole, refused = run(3000, 24)
    assert whole > 50
    assert refused > 1000


if __name__ == "__main__":
    count = int(sys.argv[1])
    print("%d cases, %d refused" % run(count, int(sys.argv[2]) if len(sys.argv) > 2 else 1))
