"""Two ranks against two threads, in one run: python3 ranks_bench.py STATIONARY STATIONARY_MPI MAP ATLASES.

Seconds of the clock say what a user waits for, and of the processor what was spent, mpirun included: the
second hold on a machine that has other work too.
"""

import os
import resource
import subprocess
import sys
import tempfile
import time

program, mpi_program, map_case, atlas_case = sys.argv[1:5]
repetitions = 3


def spent():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


with tempfile.TemporaryDirectory() as directory:
    table = os.path.join(directory, "x.csv")

    def measured(launcher, arguments, threads):
        begin = time.perf_counter(), spent()
        subprocess.run([*launcher, *arguments, "--threads", str(threads), "--quiet", "-o", table], check=True)
        seconds = time.perf_counter() - begin[0], spent() - begin[1]
        with open(table, "rb") as file:
            return seconds, file.read()

    mpirun = ["mpirun", "--allow-run-as-root", "--oversubscribe", "--bind-to", "none"]
    for name, arguments in (("anisotropic map", ["map", map_case]), ("grid of atlases", ["atlas", "--grid", atlas_case])):
        runs = {
            "one thread": ([program], 1),
            "two threads": ([program], 2),
            "one rank": ([*mpirun, "-n", "1", mpi_program], 1),
            "two ranks": ([*mpirun, "-n", "2", mpi_program], 1),
        }
        times = {what: [] for what in runs}
        tables = set()
        for _ in range(repetitions):
            for what, (launcher, threads) in runs.items():
                seconds, bytes_written = measured(launcher, arguments, threads)
                times[what].append(seconds)
                tables.add(bytes_written)
        assert len(tables) == 1, "the tables differ"
        print(f"{name}, the least of {repetitions}:   seconds  of the processor")
        clock, processor = ({what: min(each[k] for each in all_of) for what, all_of in times.items()} for k in (0, 1))
        for what in runs:
            print(f"  {what:30} {clock[what]:7.2f} {processor[what]:17.2f}")
        print(f"  two threads / two ranks        {clock['two threads'] / clock['two ranks']:7.2f} "
              f"{processor['two threads'] / processor['two ranks']:17.2f}", flush=True)
