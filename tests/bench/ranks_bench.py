"""Two ranks against two threads, in one run: python3 ranks_bench.py STATIONARY STATIONARY_MPI MAP ATLASES."""

import os
import statistics
import subprocess
import sys
import tempfile
import time

program, mpi_program, map_case, atlas_case = sys.argv[1:5]
repetitions = 5

with tempfile.TemporaryDirectory() as directory:
    table = os.path.join(directory, "x.csv")

    def seconds(launcher, arguments, threads):
        begin = time.perf_counter()
        subprocess.run([*launcher, *arguments, "--threads", str(threads), "--quiet", "-o", table], check=True)
        with open(table, "rb") as file:
            return time.perf_counter() - begin, file.read()

    mpirun = ["mpirun", "--allow-run-as-root", "--oversubscribe", "--bind-to", "none"]
    for name, arguments in (("anisotropic map", ["map", map_case]), ("grid of atlases", ["atlas", "--grid", atlas_case])):
        times = {"one thread": [], "two threads": [], "one rank": [], "two ranks": []}
        tables = set()
        for _ in range(repetitions):
            for what, launcher, threads in (
                ("one thread", [program], 1),
                ("two threads", [program], 2),
                ("one rank", [*mpirun, "-n", "1", mpi_program], 1),
                ("two ranks", [*mpirun, "-n", "2", mpi_program], 1),
            ):
                took, bytes_written = seconds(launcher, arguments, threads)
                times[what].append(took)
                tables.add(bytes_written)
        assert len(tables) == 1, "the tables differ"
        print(f"{name}, median of {repetitions}, seconds:")
        for what, each in times.items():
            print(f"  {what:12} {statistics.median(each):7.2f}  ({min(each):.2f} to {max(each):.2f})")
        print(f"  two ranks / two threads: {statistics.median(times['two threads']) / statistics.median(times['two ranks']):.2f}")
