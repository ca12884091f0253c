#!/usr/bin/env python3
"""Runs the tests against each mutant that make_mutants.py has made, those that come by its place and
the shortest first, until one fails.

    run_mutants.py BUILD [--sample N] [--seed S] [--minutes M] [--jobs J] [--again] [--only N ...]

Builds the tests in BUILD/build, runs each of their cases once with no fault (all must pass; the
places that a case comes by and its time are kept in BUILD/reached.json until the tests are built
anew), then with each of BUILD/mutants.csv in turn, or with a sample, the cases that come by it. One
that fails, crashes, or takes ten times its time has caught the mutant. BUILD/outcomes.csv has a line
for each: what is there already is not run again, unless its text has changed or --again asks for it.
The seed decides their order, and so the sample; `today` is another every day.

A survivor must have its line in survivors.csv, beside this script, that says why no test can fail or
why none need: the same program, or a search that only takes longer. Those that have one come last.
The exit status is 1 where a survivor has none.
"""
import argparse
import csv
import json
import pathlib
import random
import resource
import signal
import subprocess
import sys
import tempfile
import threading
import time
from concurrent.futures import ThreadPoolExecutor

FIELDS = ["mutant", "file", "line", "kind", "text", "becomes"]

TESTS = {
    "mechanics_tests": "lib", "gravity_tests": "lib", "solver_tests": "solver",
    "stated_kind_tests": "solver", "stability_tests": "solver", "stability_oracle_tests": "solver",
    "claims_tests": "solver", "event_bounds_tests": "solver", "continuation_tests": "solver",
    "tube_tests": "solver", "normal_form_tests": "solver", "event_curve_tests": "solver",
    "tilted_tests": "solver", "two_polar_tests": "solver", "anisotropic_tests": "solver",
    "mode_shape_tests": "solver", "batch_tests": "solver", "kind_tests": "solver",
    "expression_tests": "solver",
    "whole_body_test": "program", "cli_test": "program",
}
# Of the program's own tests those that compute; others are of texts and files.
CASES = {
    "cli_test": "*Expression*:*Sensitivity*:AnisotropicCase*:Certify*:Solve*:SolveAll*:TiltedCase*"
                ":TwoPolarCase*:SpectrumOutput*:LeastEnergy*:Completeness*:CompleteAtlas*:Atlas*"
                ":Continue*:*ContinueIn*:Curve*:FromRow*",
}


def set_limits(seconds):
    resource.setrlimit(resource.RLIMIT_AS, (6 << 30, 6 << 30))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    # Of the processor's time: on a busy machine a test that waits is not one that hangs.
    resource.setrlimit(resource.RLIMIT_CPU, (int(seconds), int(seconds) + 1))


def run(build, test, case, mutant, limit, reached=None):
    """Whether the case passes, its seconds, and how it failed."""
    program = build / "build/tests" / TESTS[test] / test
    environment = {"MUTANT": str(mutant), "PATH": "/usr/bin:/bin", "LC_ALL": "C"}
    if reached:
        environment["MUTANT_REACHED"] = str(reached)
    start = time.monotonic()
    try:
        result = subprocess.run([program, "--gtest_brief=1", "--gtest_filter=" + case], env=environment,
                                stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                timeout=20.0 * limit, preexec_fn=lambda: set_limits(limit))
    except subprocess.TimeoutExpired:
        return False, time.monotonic() - start, "time"
    seconds = time.monotonic() - start
    if result.returncode == 0:
        return True, seconds, ""
    if -result.returncode in (signal.SIGXCPU, signal.SIGKILL):
        return False, seconds, "time"
    return False, seconds, "" if result.returncode == 1 else f"exit {result.returncode}"


def cases_of(build, test):
    """The names of its cases, those that CASES leaves."""
    program = build / "build/tests" / TESTS[test] / test
    listed = subprocess.run([program, "--gtest_list_tests", "--gtest_filter=" + CASES.get(test, "*")],
                            check=True, stdout=subprocess.PIPE).stdout.decode()
    suite, out = "", []
    for line in listed.splitlines():
        name = line.split("#")[0].rstrip()
        if name.startswith("  "):
            if "DISABLED_" not in suite + name:
                out.append(suite + name.strip())
        elif name.endswith("."):
            suite = name
    return out


def reaches(build, jobs):
    """Of each case its test, its seconds, and the numbers of the places that it comes by."""
    kept = build / "reached.json"
    newest = max((build / "build/tests" / TESTS[t] / t).stat().st_mtime for t in TESTS)
    if kept.exists() and kept.stat().st_mtime > newest:
        return json.loads(kept.read_text())

    def measure(job):
        test, case = job
        with tempfile.NamedTemporaryFile() as file:
            passes, seconds, how = run(build, test, case, 0, 600, file.name)
            if not passes:
                print(f"{test} {case} fails without a fault: {how}", flush=True)
                return None
            places = sorted({int(n) for n in pathlib.Path(file.name).read_text().split()})
        return {"test": test, "case": case, "seconds": seconds, "places": places}

    with ThreadPoolExecutor(jobs) as pool:
        out = list(pool.map(measure, [(t, c) for t in TESTS for c in cases_of(build, t)]))
    if None in out:
        sys.exit(1)
    kept.write_text(json.dumps(out))
    return out


def rows(path):
    if not path.exists():
        return []
    with open(path, newline="") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def names(mutants):
    """What stays of each where lines and numbers move: its file, kind, text, what it becomes, and
    which of several alike it is."""
    seen = {}
    for m in mutants:
        own = tuple(m[k] for k in ("file", "kind", "text", "becomes"))
        seen[own] = seen.get(own, 0) + 1
        yield own + (seen[own],)


def main():
    options = argparse.ArgumentParser()
    options.add_argument("build", type=pathlib.Path)
    options.add_argument("--sample", type=int)
    options.add_argument("--seed", default="24")
    options.add_argument("--minutes", type=float)
    options.add_argument("--jobs", type=int, default=2)
    options.add_argument("--again", action="store_true")
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
                        *TESTS], check=True)
    cases = sorted(reaches(build, arguments.jobs), key=lambda c: c["seconds"])
    print(f"{len(cases)} cases, {sum(c['seconds'] for c in cases):.0f} s", flush=True)

    mutants = rows(build / "mutants.csv")
    for mutant, name in zip(mutants, names(mutants)):
        mutant["name"] = name
    done = rows(build / "outcomes.csv")
    outcomes = dict(zip(names(done), done))
    outcomes = {m["name"]: {**outcomes[m["name"]], "mutant": m["mutant"], "line": m["line"]}
                for m in mutants if m["name"] in outcomes}
    random.Random(arguments.seed).shuffle(mutants)
    if arguments.only:
        mutants = [m for m in mutants if int(m["mutant"]) in arguments.only]
    if arguments.sample:
        mutants = mutants[:arguments.sample]
    if arguments.again:
        for m in mutants:
            outcomes.pop(m["name"], None)
    lock = threading.Lock()
    reasons = {(r["file"], r["kind"], r["text"], r["becomes"]): r["why"]
               for r in rows(pathlib.Path(__file__).parent / "survivors.csv")}

    def reason(m):
        return reasons.get((m["file"], m["kind"], m["text"], m["becomes"]))

    todo = [m for m in mutants if m["name"] not in outcomes]
    todo.sort(key=lambda m: reason(m) is not None)

    def save():
        with open(build / "outcomes.new", "w", newline="") as file:
            table = csv.DictWriter(file, FIELDS + ["outcome", "by", "case", "seconds"],
                                   extrasaction="ignore")
            table.writeheader()
            table.writerows(sorted(outcomes.values(), key=lambda m: int(m["mutant"])))
        (build / "outcomes.new").rename(build / "outcomes.csv")

    def judge(mutant):
        if arguments.minutes and time.monotonic() - begun > 60.0 * arguments.minutes:
            return
        near = [each for each in cases if int(mutant["mutant"]) in each["places"]]
        seconds = 0.0
        outcome = dict(outcome="survived", by="", case="" if near else "none comes by it")
        for each in near:  # the shortest first
            passes, took, how = run(build, each["test"], each["case"], mutant["mutant"],
                                    20.0 + 10.0 * each["seconds"])
            seconds += took
            if not passes:
                outcome = dict(outcome="caught", by=each["test"], case=each["case"] + " " * bool(how) + how)
                break
        with lock:
            outcomes[mutant["name"]] = {**mutant, **outcome, "seconds": f"{seconds:.1f}"}
            save()
            print(mutant["mutant"], outcome["outcome"], outcome["by"], outcome["case"], f"{seconds:.1f} s",
                  flush=True)

    with ThreadPoolExecutor(arguments.jobs) as pool:
        list(pool.map(judge, todo))

    ran = [outcomes[m["name"]] for m in mutants if m["name"] in outcomes]
    survivors = [m for m in ran if m["outcome"] == "survived"]
    unexplained = 0
    for m in survivors:
        why = reason(m)
        unexplained += why is None
        print(f"{m['mutant']} {m['file']}:{m['line']} {m['kind']}: {m['text']} -> {m['becomes']}\n"
              f"    {why or 'NOT EXPLAINED'}")
    print(f"{len(ran)} of {len(mutants)} mutants ran, {len(ran) - len(survivors)} caught, "
          f"{len(survivors)} survived, {unexplained} of them not explained")
    sys.exit(1 if unexplained else 0)


if __name__ == "__main__":
    main()
