#!/usr/bin/env python3
"""Runs the same benchmarks of two builds in turns, and prints how long the second takes beside the first.

    two_builds.py BEFORE AFTER [--filter REGEX] [--rounds N] [BENCH ...]

BEFORE, AFTER: build directories, best made by one compiler with the same options. BENCH: programs of
tests/bench by Google Benchmark; where none is named, of KNOWN those that both have. In each round each program
runs once in either build, the order turned from round to round, so that a busy hour meets both. Of
each benchmark the least processor time over the rounds counts: the line has both, and their ratio; at
its end each program has the geometric mean of the ratios of each of its groups, which is what a name
has after its last `|`, or its last word.
"""
import argparse
import collections
import json
import math
import pathlib
import re
import subprocess
import tempfile

KNOWN = ["solve_bench", "map_bench", "search_bench", "continuation_bench"]
NANOSECONDS = {"ns": 1.0, "us": 1e3, "ms": 1e6, "s": 1e9}


def times(program, pattern):
    """Processor time of each benchmark; of repeated ones their median."""
    with tempfile.NamedTemporaryFile(suffix=".json") as out:
        command = [program, f"--benchmark_out={out.name}", "--benchmark_out_format=json",
                   f"--benchmark_filter={pattern}"]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        text = pathlib.Path(out.name).read_text()
    found = {}
    for each in json.loads(text)["benchmarks"] if text.strip() else []:
        if each["run_type"] == "aggregate" and each["aggregate_name"] != "median":
            continue
        name = re.sub(r"/(min_time|repeats):[^/]*", "", each["run_name"])
        found[name] = each["cpu_time"] * NANOSECONDS[each["time_unit"]]
    return found


def compare(before, after, pattern, rounds):
    least = [collections.defaultdict(lambda: math.inf) for _ in range(2)]
    for turn in range(rounds):
        for which in (0, 1) if turn % 2 == 0 else (1, 0):
            for name, time in times((before, after)[which], pattern).items():
                least[which][name] = min(least[which][name], time)
    groups = collections.defaultdict(list)
    for name, time in least[0].items():
        if name not in least[1]:
            continue
        ratio = least[1][name] / time
        groups[re.split(r"[|\s]", name)[-1]].append(ratio)
        print(f"{name:60} {time:14.0f} {least[1][name]:14.0f} {ratio:7.3f}", flush=True)
    for group, ratios in groups.items():
        mean = math.exp(sum(map(math.log, ratios)) / len(ratios))
        print(f"  {group}: {mean:.3f} of {len(ratios)}, {min(ratios):.2f} to {max(ratios):.2f}", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("before", type=pathlib.Path)
    parser.add_argument("after", type=pathlib.Path)
    parser.add_argument("bench", nargs="*")
    parser.add_argument("--filter", default=".*")
    parser.add_argument("--rounds", type=int, default=3)
    given = parser.parse_intermixed_args()
    for bench in given.bench or KNOWN:
        programs = [build.resolve() / "tests/bench" / bench for build in (given.before, given.after)]
        missing = [str(each) for each in programs if not each.exists()]
        if missing:
            if given.bench:
                parser.error("no " + missing[0])
            continue
        print(f"{bench:60} {'before, ns':>14} {'after, ns':>14} {'ratio':>7}", flush=True)
        compare(*programs, given.filter, given.rounds)


if __name__ == "__main__":
    main()
