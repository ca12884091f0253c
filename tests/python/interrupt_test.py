"""Ctrl-C ends what is being computed, soon, and nothing else."""

import signal
import subprocess
import sys
import textwrap

import pytest
import stationary
from conftest import SOURCES

WORK = {
    "atlas": "stationary.atlas(fold, checkpoints=50_000)",
    "follow": "stationary.follow(fold.set({'continuation.tolerance': 1e-14, 'continuation.step': 1e-8}))\n"
    "while True: stationary.follow(fold)",
    "curve": "circle = fold.set({'potential.plane': {'model': 'neo-hookean', 'mu': 1.0, 'lambda': 2.0},"
    " 'curve': {'event': 'tilt', 'parameters': ['nu', 'body.J.1'], 'from': [0.0, 1.1], 'to': [1.0, 3.0],"
    " 'tolerance': 1e-12}})\n"
    "while True: stationary.curve(circle)",
    "study": "stationary.study(fold, {'motion.nu': np.linspace(0.0, 0.5, 40_000)}, 'continue')",
    "map": "stationary.map(fold.set('map', {'x': {'parameter': 'nu', 'from': 0.0, 'to': 0.5, 'count': 2000},"
    " 'y': {'parameter': 'body.J.1', 'from': 1.1, 'to': 2.0, 'count': 2000}}))",
    "sweep": "stationary.sweep(fold.body, fold.potential, 'i', np.linspace(0.0, 0.5, 30_000_000))",
    "solve_batch": "stationary.solve_batch(fold.body, fold.potential, 'i', np.linspace(0.0, 0.5, 1000),"
    " {'body.J.1': np.linspace(1.1, 2.0, 5_000)}, spectrum='modes')",
    "value": "fold.potential.value(0.0, np.linspace(0.5, 2.0, 20_000_000), 1.0, 1.0)",
    "search": "stationary.search(fold.body, fold.potential, 'i', np.linspace(0.0, 0.5, 1_000_000))",
    "certify": "points = stationary.sweep(fold.body, fold.potential, 'i', np.linspace(0.0, 0.5, 1_000_000))\n"
    "print('certifying', flush=True); stationary.certify(fold.body, fold.potential, 'i', points)",
}


@pytest.mark.parametrize("name", WORK)
def test_ctrl_c_raises(name):
    """A computation that takes minutes ends with KeyboardInterrupt, and the next one runs."""
    script = f"""
import signal, time
import numpy as np, stationary
fold = stationary.Case.read({str(SOURCES / "cases" / "fold.toml")!r})
print("begun", flush=True)
try:
{textwrap.indent(WORK[name], "    ")}
except KeyboardInterrupt:
    print("interrupted", len(stationary.solve(fold)), flush=True)
"""
    with subprocess.Popen(
        [sys.executable, "-c", script], stdout=subprocess.PIPE, text=True
    ) as child:
        try:
            assert child.stdout.readline() == "begun\n"
            with pytest.raises(subprocess.TimeoutExpired):
                child.wait(1.0)  # it is at work
            child.send_signal(signal.SIGINT)
            out, _ = child.communicate(timeout=60)
        finally:
            child.kill()
    assert out.endswith("interrupted 1\n")
    assert child.returncode == 0


def test_a_handler_that_raises_nothing_lets_it_go_on():
    seen = []
    before = signal.signal(signal.SIGALRM, lambda *_: seen.append(1))
    try:
        signal.setitimer(signal.ITIMER_REAL, 0.05)
        case = stationary.Case.read(SOURCES / "cases" / "map_biot_log.toml")
        result = stationary.map(case.set({"map.x.count": 1000, "map.y.count": 300}))
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)
        signal.signal(signal.SIGALRM, before)
    assert seen == [1] and len(result) == 300_000
