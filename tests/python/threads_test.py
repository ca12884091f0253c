"""Threads side by side: no crash, and each has the answer that it has alone."""

import random
import subprocess
import sys
import threading
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import stationary
from conftest import SOURCES, SUFFIXES

NAMES = ("disc", "fold", "neo_hookean", "coupled", "fibre", "tilted", "two_polar", "mooney_rivlin")


def case(name):
    return stationary.Case.read(SOURCES / "cases" / f"{name}.toml")


def test_eight_threads_of_solves():
    alone = {name: stationary.solve(case(name)).table.tobytes() for name in NAMES}
    failures = []

    def work(seed):
        order = random.Random(seed)
        for _ in range(25):
            name = order.choice(NAMES)
            if stationary.solve(case(name)).table.tobytes() != alone[name]:
                failures.append(name)

    interval = sys.getswitchinterval()
    sys.setswitchinterval(1e-5)
    try:
        threads = [threading.Thread(target=work, args=(seed,)) for seed in range(8)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
    finally:
        sys.setswitchinterval(interval)
    assert failures == []


def test_everything_side_by_side(tmp_path):
    fold = case("fold")
    body, potential = fold.body, fold.potential
    nu = np.linspace(0.0, 0.5, 2000)
    tasks = {
        "follow": lambda: stationary.follow(fold).table,
        "sweep": lambda: stationary.sweep(body, potential, "i", nu),
        "batch": lambda: stationary.solve_batch(
            body, potential, "i", nu[:50], {"body.J.1": nu + 1.0}, spectrum="class"
        )[1],
        "search": lambda: stationary.search(body, potential, "i", nu[:4]).records,
        "set": lambda: stationary.solve(fold.set("motion.nu", 0.2)).table,
    }
    alone = {name: task() for name, task in tasks.items()}
    with ThreadPoolExecutor(8) as pool:
        found = [(name, pool.submit(task)) for _ in range(6) for name, task in tasks.items()]
        for name, future in found:
            for field in alone[name].dtype.names:
                np.testing.assert_array_equal(
                    future.result()[field], alone[name][field], f"{name}, {field}"
                )


def test_files_of_several_threads(tmp_path):
    result = stationary.follow(case("fold"))
    paths = [tmp_path / f"{k}{suffix}" for k in range(8) for suffix in SUFFIXES]
    with ThreadPoolExecutor(8) as pool:
        list(pool.map(result.write, paths))
    for suffix in SUFFIXES:
        assert len({path.read_bytes() for path in paths if path.suffix == suffix}) == 1


def test_errors_of_several_threads():
    def wrong(k):
        try:
            case("disc").set("motion.nu", f"fast{k}")
        except stationary.InputError as error:
            return error.found
        return None

    with ThreadPoolExecutor(8) as pool:
        found = list(pool.map(wrong, range(50)))
    assert found == [f'found the string "fast{k}"' for k in range(50)]


def test_the_lock_is_released():
    """Another thread runs while a map is computed."""
    ticks, done = [], threading.Event()

    def tick():
        while not done.wait(0.005):
            ticks.append(1)

    ticker = threading.Thread(target=tick)
    ticker.start()
    chart = case("map_biot_log").set({"map.x.count": 1000, "map.y.count": 300})
    stationary.map(chart, threads=1)
    done.set()
    ticker.join()
    assert len(ticks) > 5


def test_the_interpreter_ends_while_a_thread_computes():
    """A daemon's, which asks for the lock of an interpreter that is gone."""
    script = f"""
import threading, time
import stationary
fold = stationary.Case.read({str(SOURCES / "cases" / "fold.toml")!r})
def compute():
    while True:
        stationary.follow(fold)
for _ in range(4):
    threading.Thread(target=compute, daemon=True).start()
time.sleep(0.5)
"""
    for _ in range(3):
        ended = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=60)
        assert (ended.returncode, ended.stderr) == (0, "")
