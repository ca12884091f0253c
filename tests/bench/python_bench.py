"""What Python costs: `stationary.sweep` beside the C++ sweep, `follow` beside processes, batches.

    cmake --build build/release --target python_bench
"""

import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np
import stationary

PROGRAM, PEER, CASES = sys.argv[1], sys.argv[2], Path(sys.argv[3])


def best(work, runs=7):
    times = []
    for _ in range(runs):
        begin = time.perf_counter()
        work()
        times.append(time.perf_counter() - begin)
    return min(times)


disc = stationary.Case.read(CASES / "disc.toml")
nu = np.linspace(0.0, 1.0, 1_000_000)
peer = min(float(subprocess.check_output([PEER])) for _ in range(2))
ours = best(lambda: stationary.sweep(disc.body, disc.potential, "i", nu))
peer = min(peer, float(subprocess.check_output([PEER])))
print(f"sweep over a million nu: {ours:.3f} s, in C++ {peer:.3f} s, ratio {ours / peer:.3f}")

lanes = {"body.J.1": np.linspace(1.05, 2.0, 4000)}
spins = np.linspace(0.0, 0.8, 500)
for threads in (1, None):
    took = best(
        lambda: stationary.solve_batch(
            disc.body, disc.potential, "i", spins, lanes, threads=threads
        ),
        3,
    )
    print(f"solve_batch, {threads or 'all'} threads: {2e6 / took / 1e6:.2f} million cells a second")

case = disc.set({"continuation.tolerance": 1e-6})
cases = [case.set("body.J.1", 1.2 + 0.0005 * k) for k in range(1000)]


def follow_all():
    for each in cases:
        stationary.follow(each)


def set_and_follow_all():
    for k in range(1000):
        stationary.follow(case.set("body.J.1", 1.2 + 0.0005 * k))


inside = best(follow_all, 3)
with_set = best(set_and_follow_all, 2)
count = 100
with tempfile.TemporaryDirectory() as directory:

    def processes():
        for k in range(count):
            subprocess.run(
                [PROGRAM, "continue", CASES / "disc.toml", "--set", "continuation.tolerance=1e-6",
                 "--set", f"body.J.1={1.2 + 0.005 * k}", "-o", f"{directory}/a.csv", "-q"],
                check=True,
            )

    outside = best(processes, 2) * 1000 / count
print(
    f"a thousand follow: {inside:.2f} s, with set {with_set:.2f} s; as processes {outside:.1f} s, "
    f"{outside / inside:.0f} and {outside / with_set:.0f} times as long"
)
took = best(lambda: [stationary.solve(disc) for _ in range(200)], 3) / 200
print(f"solve: {took * 1e6:.0f} us")
