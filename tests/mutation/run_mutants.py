#!/usr/bin/env python3
"""Runs the tests against each mutant that make_mutants.py has made, the nearest tests first, until
one fails.

    run_mutants.py BUILD [--sample N] [--seed S] [--minutes M] [--jobs J] [--again]

Builds the tests in BUILD/build, runs them with no fault (all must pass, and their times set the
limits), then with each of BUILD/mutants.csv in turn, or with a sample. A test that fails, crashes,
or takes ten times its time has caught the mutant. BUILD/outcomes.csv has a line for each: what is
there already is not run again, unless its line in the list has changed or --again asks for it. The
seed decides their order, and so the sample; `today` is another every day.

A survivor must have its line in survivors.csv, beside this script, that says why no test can fail or
why none need: the same program, or a search that only takes longer. The exit status is 1 where one
has not.
"""
import argparse
import csv
import pathlib
import random
import resource
import signal
import subprocess
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor

FIELDS = ["mutant", "file", "line", "kind", "text", "becomes"]

# Of each room the tests that are nearest; the others follow, the shortest first.
NEAREST = {
    "lib/number": ["mechanics_tests"],
    "lib/body": ["mechanics_tests"],
    "lib/gravity": ["gravity_tests", "mechanics_tests"],
    "lib/material/gravitating": ["gravity_tests", "whole_body_test"],
    "lib/material": ["mechanics_tests", "anisotropic_tests"],
    "lib/balance/two_polar": ["mechanics_tests", "two_polar_tests"],
    "lib/balance/tilted": ["tilted_tests"],
    "lib/balance": ["mechanics_tests", "anisotropic_tests"],
    "lib/stability/circle_momentum": ["claims_tests", "stability_tests", "continuation_tests"],
    "lib/stability/tilted": ["tilted_tests", "stability_oracle_tests"],
    "lib/stability": ["stability_tests", "claims_tests", "stability_oracle_tests"],
    "solver/newton": ["solver_tests", "tilted_tests"],
    "solver/motion": ["event_bounds_tests", "kind_tests", "solver_tests", "continuation_tests"],
    "solver/continuation": ["claims_tests", "event_bounds_tests", "continuation_tests"],
    "solver/normal_form/": ["normal_form_tests"],
    "solver/family/oriented": ["anisotropic_tests"],
    "solver/family/anisotropic": ["anisotropic_tests"],
    "solver/family/tilted": ["tilted_tests"],
    "solver/family/two_polar": ["continuation_tests"],
    "solver/family": ["continuation_tests", "event_curve_tests"],
    "solver/proof": ["kind_tests", "expression_tests", "solver_tests", "tilted_tests",
                     "continuation_tests"],
    "solver/search/anisotropic": ["anisotropic_tests"],
    "solver/search/tilted": ["tilted_tests"],
    "solver/search/two_polar": ["two_polar_tests"],
    "solver/search": ["solver_tests", "two_polar_tests"],
    "solver/solve/anisotropic": ["anisotropic_tests"],
    "solver/solve/tilted": ["tilted_tests"],
    "solver/solve": ["solver_tests"],
    "solver/tube": ["tube_tests"],
    "solver/atlas/anisotropic": ["anisotropic_tests"],
    "solver/atlas": ["continuation_tests", "anisotropic_tests"],
}
TESTS = {
    "mechanics_tests": "lib", "gravity_tests": "lib", "solver_tests": "solver",
    "stated_kind_tests": "solver", "stability_tests": "solver", "stability_oracle_tests": "solver",
    "claims_tests": "solver", "event_bounds_tests": "solver", "continuation_tests": "solver",
    "tube_tests": "solver", "normal_form_tests": "solver", "event_curve_tests": "solver",
    "tilted_tests": "solver", "two_polar_tests": "solver", "anisotropic_tests": "solver",
    "batch_tests": "solver", "kind_tests": "solver", "expression_tests": "solver",
    "whole_body_test": "program", "cli_test": "program",
}
# Of the program's own tests those that compute; others are of texts and files.
CASES = {
    "cli_test": "*Expression*:*Sensitivity*:AnisotropicCase*:Certify*:Solve*:SolveAll*:TiltedCase*"
                ":TwoPolarCase*:SpectrumOutput*:LeastEnergy*:Completeness*",
}


def set_limits(seconds):
    resource.setrlimit(resource.RLIMIT_AS, (6 << 30, 6 << 30))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    # Of the processor's time: on a busy machine a test that waits is not one that hangs.
    resource.setrlimit(resource.RLIMIT_CPU, (int(seconds), int(seconds) + 1))


def run(build, test, mutant, limit):
    """Whether the test passes, its seconds, and the first of its cases that failed."""
    program = build / "build/tests" / TESTS[test] / test
    start = time.monotonic()
    try:
        result = subprocess.run([program, "--gtest_brief=1", "--gtest_fail_fast",
                                 "--gtest_filter=" + CASES.get(test, "*")],
                                env={"MUTANT": str(mutant), "PATH": "/usr/bin:/bin", "LC_ALL": "C"},
                                stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, timeout=20.0 * limit,
                                preexec_fn=lambda: set_limits(limit))
    except subprocess.TimeoutExpired:
        return False, time.monotonic() - start, "time"
    seconds = time.monotonic() - start
    if result.returncode == 0:
        return True, seconds, ""
    if -result.returncode in (signal.SIGXCPU, signal.SIGKILL):
        return False, seconds, "time"
    for line in result.stdout.decode(errors="replace").splitlines():
        if line.startswith("[  FAILED  ] "):
            return False, seconds, line[13:].split(",")[0].split(" (")[0]
    return False, seconds, f"exit {result.returncode}"


def nearest(mutant):
    return max((place for place in NEAREST if mutant["file"].startswith(place)), key=len)


def rows(path):
    if not path.exists():
        return []
    with open(path, newline="") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def main():
    options = argparse.ArgumentParser()
    options.add_argument("build", type=pathlib.Path)
    options.add_argument("--sample", type=int)
    options.add_argument("--seed", default="24")
    options.add_argument("--minutes", type=float)
    options.add_argument("--jobs", type=int, default=2)
    options.add_argument("--again", action="store_true")
    options.add_argument("--tests", nargs="*", help="these alone; who survives them is not recorded")
    options.add_argument("--quick", action="store_true",
                         help="the short tests and the nearest; who survives them is not recorded")
    options.add_argument("--built", action="store_true", help="the tests are built")
    options.add_argument("--only", type=int, nargs="*", help="numbers of mutants")
    arguments = options.parse_args()
    build = arguments.build.resolve()
    if arguments.seed == "today":
        arguments.seed = time.strftime("%Y-%m-%d")
    print(f"seed {arguments.seed}")
    begun = time.monotonic()
    if not arguments.built:
        subprocess.run(["cmake", "--build", build / "build", "-j", str(arguments.jobs), "--target",
                        *(arguments.tests or TESTS)], check=True)
    usual, cheap = {}, 1.0  # seconds
    for test in arguments.tests or TESTS:
        passes, usual[test], case = run(build, test, 0, 600)
        print(f"{test}: {usual[test]:.1f} s", flush=True)
        if not passes:
            sys.exit(f"{test} fails without a fault: {case}")

    mutants = rows(build / "mutants.csv")
    random.Random(arguments.seed).shuffle(mutants)
    if arguments.only:
        mutants = [m for m in mutants if int(m["mutant"]) in arguments.only]
    if arguments.sample:
        mutants = mutants[:arguments.sample]
    outcomes = {tuple(m[k] for k in FIELDS): m for m in rows(build / "outcomes.csv")}
    if arguments.again:
        for m in mutants:
            outcomes.pop(tuple(m[k] for k in FIELDS), None)
    lock = threading.Lock()
    todo = [m for m in mutants if tuple(m[k] for k in FIELDS) not in outcomes]

    def save():
        with open(build / "outcomes.new", "w", newline="") as file:
            table = csv.DictWriter(file, FIELDS + ["outcome", "by", "case", "seconds"])
            table.writeheader()
            table.writerows(sorted(outcomes.values(), key=lambda m: int(m["mutant"])))
        (build / "outcomes.new").rename(build / "outcomes.csv")

    def judge(mutant):
        if arguments.minutes and time.monotonic() - begun > 60.0 * arguments.minutes:
            return
        place = nearest(mutant)
        # What takes no time goes first, and finds most.
        order = sorted(usual, key=lambda t: (usual[t] > cheap, t not in NEAREST[place], usual[t]))
        if arguments.quick:
            order = [t for t in order if usual[t] <= cheap or t in NEAREST[place]]
        seconds, outcome = 0.0, dict(outcome="survived", by="", case="")
        for test in order:
            passes, took, case = run(build, test, mutant["mutant"], 20.0 + 10.0 * usual[test])
            seconds += took
            if not passes:
                outcome = dict(outcome="caught", by=test, case=case)
                break
        with lock:
            if outcome["outcome"] == "survived" and (arguments.tests or arguments.quick):
                print(mutant["mutant"], "not caught by these", flush=True)
                return
            outcomes[tuple(mutant[k] for k in FIELDS)] = {**mutant, **outcome, "seconds": f"{seconds:.1f}"}
            save()
            print(mutant["mutant"], outcome["outcome"], outcome["by"], outcome["case"], f"{seconds:.1f} s",
                  flush=True)

    with ThreadPoolExecutor(arguments.jobs) as pool:
        list(pool.map(judge, todo))

    reasons = {(r["file"], r["kind"], r["text"], r["becomes"]): r["why"]
               for r in rows(pathlib.Path(__file__).parent / "survivors.csv")}
    ran = [outcomes[k] for k in (tuple(m[f] for f in FIELDS) for m in mutants) if k in outcomes]
    survivors = [m for m in ran if m["outcome"] == "survived"]
    unexplained = 0
    for m in survivors:
        why = reasons.get((m["file"], m["kind"], m["text"], m["becomes"]))
        unexplained += why is None
        print(f"{m['mutant']} {m['file']}:{m['line']} {m['kind']}: {m['text']} -> {m['becomes']}\n"
              f"    {why or 'NOT EXPLAINED'}")
    print(f"{len(ran)} of {len(mutants)} mutants ran, {len(ran) - len(survivors)} caught, "
          f"{len(survivors)} survived, {unexplained} of them not explained")
    sys.exit(1 if unexplained else 0)


if __name__ == "__main__":
    main()
