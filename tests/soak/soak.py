#!/usr/bin/env python3
"""Random commands over all that the program does, most of them disturbed: signals, full disks, short writes, too little
memory, closed pipes. No run may crash, hang, leave half a file, or say what is not so.

    soak.py --program PROGRAM --cases DIRECTORY --into DIRECTORY [--minutes 60 | --commands N] [--seed S] [--shim FILE]

--into has log.csv, a line for each command, summary.txt, and for each failure a directory with the files that the command
was given and what.txt. Exit code 1 where there was one."""

import argparse
import csv
import os
import random
import re
import shlex
import shutil
import subprocess
import sys
import time
from collections import Counter, defaultdict

from checks import Files, Known, NotSo, check_disturbed, check_end, check_gone_on, check_undisturbed
from claims import Claims
from faults import Fault, Faults, run
from grammar import DONE, INTERRUPTED, Grammar, made_by

EARLIER = b"earlier\n"


class Soak:
    def __init__(self, arguments):
        self.program = os.path.abspath(arguments.program)
        self.into = os.path.abspath(arguments.into)
        self.seed = arguments.seed
        os.makedirs(self.into, exist_ok=True)
        shipped = {}
        for name in sorted(os.listdir(arguments.cases)):
            if name.endswith(".toml"):
                with open(os.path.join(arguments.cases, name), "rb") as file:
                    shipped[name] = file.read()
        versions = subprocess.run([self.program, "--version"], capture_output=True, text=True).stdout
        self.grammar = Grammar(shipped, hdf5=re.search(r"^HDF5 +\d", versions, re.M) is not None,
                               made=self.made)
        self.faults = Faults(self.program, arguments.shim and os.path.abspath(arguments.shim))
        self.claims = Counter()
        self.verdicts = defaultdict(Counter)

    def directory(self, name, inputs):
        """A fresh one, with these files."""
        path = os.path.join(self.into, name)
        for each in (path, path + ".disk"):
            shutil.rmtree(each, ignore_errors=True)
        os.makedirs(path)
        for file, data in inputs.items():
            with open(os.path.join(path, file), "wb") as out:
                out.write(data)
        return path

    def made(self, words, inputs):
        place = self.directory("parts", inputs)
        run(self.program, words, place)
        return Files(place).bytes

    def one(self, number):
        """The lines of the log of one command."""
        rng = random.Random(f"{self.seed} {number}")
        command = self.grammar.draw(rng)
        place = self.directory("usual", command.inputs)
        usual = run(self.program, command.words, place)
        files = Files(place)
        self.tell(number, command, Fault(), usual, lambda: self.undisturbed(rng, command, usual, files))
        if usual.overdue or usual.code < 0 or rng.random() < 0.25:
            return
        self.disturbed(rng, number, command, (usual, files))

    def undisturbed(self, rng, command, usual, files):
        check_undisturbed(usual, command, files)
        if usual.overdue:
            return "slow"
        if usual.code == DONE and not command.wrong:
            made = made_by(command, files.bytes, dict.get)
            if made:
                self.grammar.keep(made)

        def again(words, inputs):
            other = run(self.program, words, self.directory("again", inputs))
            check_end(other, command)
            return other

        claims = Claims(rng, command, again)
        try:
            claims.check(usual, files)
        finally:
            self.claims += claims.counts
        return "passed"

    def disturbed(self, rng, number, command, usual):
        before = {}
        if rng.random() < 0.4:
            before = {name: EARLIER for name in command.outputs if name not in command.inputs}
        place = self.directory("disturbed", {**command.inputs, **before})
        size = sum(len(data) for name, data in usual[1].bytes.items() if name not in command.inputs)
        fault = self.faults.draw(rng, usual[0].seconds, size, command.directory_size() + 4 * len(before), place)
        disturbed = run(self.program, command.words, place, fault)
        if fault.disk and disturbed.code in (197, 198, 199):
            return
        files = Files(place)
        self.tell(number, command, fault, disturbed,
                  lambda: check_disturbed(disturbed, command, fault, usual, before, files) or "passed")
        if command.verb in ("check", "models", "help") or rng.random() < 0.4:
            return
        self.gone_on(number, command, usual, place, disturbed, files)

    def gone_on(self, number, command, usual, place, disturbed, files):
        """The same again: with --resume where there is something to go on with."""
        words, how = list(command.words), "again"
        journal = command.table + ".journal" in files.bytes
        # Interrupted before its first row it leaves what was there.
        begun = (disturbed.code == INTERRUPTED and command.verb == "continue" and not command.table.endswith("html")
                 and files.bytes.get(command.table, EARLIER) != EARLIER)
        if command.resumes and "--merge" not in words and (journal or begun):
            words, how = words + ["--resume"], "--resume"
        more = run(self.program, words, place)
        if how == "--resume" and more.code == 2 and disturbed.code != INTERRUPTED:
            return  # what was begun is of no use, and it says so
        after = Files(place)
        if not more.overdue:
            self.tell(number, command, Fault(how), more,
                      lambda: check_gone_on(more, command, usual, after, how) or "passed")

    def tell(self, number, command, fault, found, check):
        try:
            verdict, why = check(), ""
        except Known as reason:
            verdict, why = "known", str(reason)
        except NotSo as reason:
            verdict, why = "FAILED", str(reason)
            self.keep(number, command, fault, found, why)
        except Exception as reason:  # of the harness itself, or of a file that cannot be read
            verdict, why = "FAILED", f"{type(reason).__name__}: {reason}"
            self.keep(number, command, fault, found, why)
        self.verdicts[command.verb, fault.name][verdict] += 1
        if command.wrong:
            self.verdicts["(wrong on purpose)", fault.name][verdict] += 1
        self.log.writerow([number, command.verb, shlex.join(command.words), command.wrong, fault.text(), found.code,
                           f"{found.seconds:.3f}", verdict, why[:500]])
        self.file.flush()

    def keep(self, number, command, fault, found, why):
        """What a failure can be made from again."""
        place = self.directory(f"failure-{number}-{fault.name.replace(' ', '_')}", command.inputs)
        with open(os.path.join(place, "what.txt"), "w") as out:
            out.write(f"{why}\n\n{shlex.join([self.program] + command.words)}\nfault: {fault.text()}\n"
                      f"exit code {found.code} after {found.seconds:.3f} s\n\n{found.err}\n")
        print(f"{number} {command.verb} [{fault.text()}]: {why[:300]}", flush=True)

    def summary(self, minutes):
        lines = [f"seed {self.seed}, {minutes:.1f} minutes"]
        for name, why in self.faults.skipped:
            lines.append(f"skipped: {name}: {why}")
        for title, of in (("verb", 0), ("fault", 1)):
            by = defaultdict(Counter)
            for names, counts in self.verdicts.items():
                if of == 0 or not names[0].startswith("("):
                    by[names[of]] += counts
            lines += ["", f"{title:32}{'passed':>8}{'slow':>8}{'known':>8}{'failed':>8}"]
            for name, counts in sorted(by.items()):
                lines.append(f"{name:32}{counts['passed']:8}{counts['slow']:8}{counts['known']:8}{counts['FAILED']:8}")
        lines += ["", "claims held against other computations"]
        lines += [f"{name:48}{count:8}" for name, count in sorted(self.claims.items())]
        whole = Counter()
        for names, counts in self.verdicts.items():
            if not names[0].startswith("("):
                whole += counts
        lines += ["", f"{whole['passed']} passed, {whole['slow']} slow, {whole['known']} known, {whole['FAILED']} failed"]
        return "\n".join(lines) + "\n", whole["FAILED"]

    def run(self, minutes, commands):
        begin = time.monotonic()
        with open(os.path.join(self.into, "log.csv"), "w", newline="") as self.file:
            self.log = csv.writer(self.file, lineterminator="\n")
            self.log.writerow(["number", "verb", "command", "wrong", "fault", "exit", "seconds", "verdict", "why"])
            number = 0
            while number < commands if commands else time.monotonic() < begin + 60 * minutes:
                self.one(number)
                number += 1
        text, failed = self.summary((time.monotonic() - begin) / 60)
        with open(os.path.join(self.into, "summary.txt"), "w") as out:
            out.write(text)
        for name in ("usual", "disturbed", "again", "parts"):
            shutil.rmtree(os.path.join(self.into, name), ignore_errors=True)
            shutil.rmtree(os.path.join(self.into, name) + ".disk", ignore_errors=True)
        print(text)
        return 1 if failed else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", required=True)
    parser.add_argument("--cases", required=True)
    parser.add_argument("--into", required=True)
    parser.add_argument("--minutes", type=float, default=60.0)
    parser.add_argument("--commands", type=int, default=0)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--shim", default="")
    arguments = parser.parse_args()
    return Soak(arguments).run(arguments.minutes, arguments.commands)


if __name__ == "__main__":
    sys.exit(main())
