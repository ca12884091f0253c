#!/usr/bin/env python3
"""Tables of HDF5 with bytes changed, read by the program under a limit of memory: it says what is wrong, and neither
crashes nor hangs. The library's own readers are in the way, so that libFuzzer has little to see.

    fuzz_hdf5.py PROGRAM TABLE.h5 COUNT [SEED]

The exit status is 1 where one crashed or hung; such files are kept as fuzz_hdf5.N.h5.
"""
import collections
import pathlib
import random
import resource
import subprocess
import sys
import tempfile


def changed(rng, table):
    data = bytearray(table)
    for _ in range(rng.randint(1, 6)):
        # Half of them among the headers, at the beginning.
        at = rng.randrange(len(data) if rng.random() < 0.5 else min(len(data), 4096))
        deed = rng.randrange(4)
        if deed == 0:
            data[at] ^= 1 << rng.randrange(8)
        elif deed == 1:
            data[at] = rng.choice([0, 127, 128, 255])
        elif deed == 2:
            data = data[: max(1, at)]
        else:
            data[at : at + 8] = bytes(rng.choice([0, 255]) for _ in range(8))
    return bytes(data)


def limit_memory():
    resource.setrlimit(resource.RLIMIT_AS, (3 << 30, 3 << 30))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def main():
    program, table, count = sys.argv[1], pathlib.Path(sys.argv[2]).read_bytes(), int(sys.argv[3])
    rng = random.Random(int(sys.argv[4]) if len(sys.argv) > 4 else 5)
    ended = collections.Counter()
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "table.h5"
        for k in range(count):
            path.write_bytes(changed(rng, table))
            command = [program, "explore", path, "-o", path.with_suffix(".html"), "--no-live", "--quiet"]
            try:
                code = subprocess.run(command, capture_output=True, timeout=20, preexec_fn=limit_memory).returncode
            except subprocess.TimeoutExpired:
                code = "hung"
            ended[code] += 1
            if code not in (0, 2, 4):
                pathlib.Path(f"fuzz_hdf5.{k}.h5").write_bytes(path.read_bytes())
    print(", ".join(f"{number} with {code}" for code, number in ended.items()))
    return int(any(code not in (0, 2, 4) for code in ended))


if __name__ == "__main__":
    sys.exit(main())
