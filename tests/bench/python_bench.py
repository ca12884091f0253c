"""What Python costs: `stationary.sweep` beside the C++ sweep, `follow` beside processes, batches, and how
soon Ctrl-C ends an atlas. What is compared is measured in turns, the best of each counts; as processors' time,
all threads and processes together, where that is what is compared.

    cmake --build build/release --target python_bench
"""

import os
import signal
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path

import numpy as np
import stationary

PROGRAM, PEER, CASES = sys.argv[1], sys.argv[2], Path(sys.argv[3])


def seconds(work):
    begin = time.perf_counter()
    work()
    return time.perf_counter() - begin


def processor_seconds(work):
    begin = sum(os.times()[:4])
    work()
    return sum(os.times()[:4]) - begin


def in_turns(rounds, *measures):
    """Of each, a function that returns seconds, the least."""
    times = [[measure() for measure in measures] for _ in range(rounds)]
    return [min(each) for each in zip(*times)]


disc = stationary.Case.read(CASES / "disc.toml")


def sweeps():
    nu = np.linspace(0.0, 1.0, 1_000_000)
    ours, peer = in_turns(
        8,
        lambda: processor_seconds(lambda: stationary.sweep(disc.body, disc.potential, "i", nu)),
        lambda: float(subprocess.check_output([PEER])),
    )
    print(f"sweep over a million nu: {ours:.3f} s, in C++ {peer:.3f} s, ratio {ours / peer:.3f}")


def batches():
    lanes = {"body.J.1": np.linspace(1.05, 2.0, 4000)}
    spins = np.linspace(0.0, 0.8, 500)

    def cells(threads):
        return lambda: seconds(
            lambda: stationary.solve_batch(
                disc.body, disc.potential, "i", spins, lanes, threads=threads
            )
        )

    for threads, took in zip(("one thread", "all threads"), in_turns(3, cells(1), cells(None))):
        print(f"solve_batch, {threads}: {2.0 / took:.1f} million cells a second")


def follows():
    """A thousand bodies followed: the cases at hand, or set first; a process each."""
    case = disc.set("continuation.tolerance", 1e-6)
    inertias = 1.2 + 0.0005 * np.arange(1000)
    cases = [case.set("body.J.1", J2) for J2 in inertias]
    count = 100  # processes a round
    with tempfile.TemporaryDirectory() as directory:

        def process(J2):
            subprocess.run(
                [PROGRAM, "continue", CASES / "disc.toml", "--set", "continuation.tolerance=1e-6",
                 "--set", f"body.J.1={J2}", "-o", f"{directory}/a.csv", "-q"],
                check=True,
            )

        inside, with_set, outside = in_turns(
            3,
            lambda: processor_seconds(lambda: [stationary.follow(each) for each in cases]),
            lambda: processor_seconds(
                lambda: [stationary.follow(case.set("body.J.1", J2)) for J2 in inertias]
            ),
            lambda: processor_seconds(lambda: [process(J2) for J2 in inertias[:: 1000 // count]])
            * 1000
            / count,
        )
    print(
        f"a thousand follow: {inside:.2f} s, with set {with_set:.2f} s; as processes {outside:.1f} s, "
        f"{outside / inside:.0f} and {outside / with_set:.0f} times as long"
    )


def solves():
    took = min(processor_seconds(lambda: [stationary.solve(disc) for _ in range(200)]) for _ in range(3))
    print(f"solve: {took / 200 * 1e6:.0f} us")


def interruption():
    """From the signal to the exception, at several times of an atlas."""
    fold = stationary.Case.read(CASES / "fold.toml")
    waited = []
    for after in np.linspace(0.5, 2.5, 9):
        sent = []

        def interrupt():
            sent.append(time.perf_counter())
            os.kill(os.getpid(), signal.SIGINT)

        timer = threading.Timer(after, interrupt)
        timer.start()
        try:
            stationary.atlas(fold, checkpoints=50_000)
        except KeyboardInterrupt:
            waited.append(time.perf_counter() - sent[0])
        timer.join()
    print(f"Ctrl-C out of an atlas: {max(waited):.3f} s at most, of {len(waited)}")


sweeps()
batches()
follows()
solves()
interruption()
