"""What must hold of every run: how it ended, what it said, and what files it left."""

import csv
import io
import json
import os
import re
import signal
from dataclasses import dataclass

from faults import ENDING, HEEDED
from grammar import DONE, FAILED, INTERRUPTED, NONE, WRONG

UNTOWARD = re.compile(r"terminate called|[Aa]ssert|Sanitizer|runtime error|Segmentation|HDF5-DIAG|Check failed"
                      r"|^[WEF]\d{4} |pure virtual|corrupted|free\(\)|stack smashing", re.M)
LEFT = re.compile(r"^\..*\.\d+-\d+\.tmp$")


class NotSo(Exception):
    """What is not as it must be."""


class Known(Exception):
    """What is not the program's fault, and is counted apart."""


def require(condition, text):
    if not condition:
        raise NotSo(text)


@dataclass
class Files:
    """A directory's, as bytes."""
    bytes: dict

    def __init__(self, directory):
        self.bytes = {}
        for name in sorted(os.listdir(directory)):
            with open(os.path.join(directory, name), "rb") as file:
                self.bytes[name] = file.read()


def check_end(run, command):
    """No crash, no hang, an exit code that is documented."""
    require(not run.hung, "does not end within 10 s after SIGINT")
    if run.code < 0:
        name = signal.Signals(-run.code).name
        require(name in ENDING, f"died by {name}")
    else:
        require(run.code in (DONE, WRONG, NONE, FAILED, INTERRUPTED), f"exit code {run.code} is not documented")
    found = UNTOWARD.search(run.err)
    require(not found, f"stderr has {found and found.group()!r}")


def check_message(run, command):
    """A command that fails says why."""
    if run.code in (WRONG, NONE, FAILED, INTERRUPTED):
        lines = [line for line in run.err.splitlines() if line.startswith("stationary: ")]
        require(lines and max(map(len, lines)) > 20, f"exit code {run.code}, and no message")


def check_undisturbed(run, command, files):
    """A run that nothing disturbed."""
    check_end(run, command)
    check_message(run, command)
    if run.overdue:
        require(run.code in (INTERRUPTED, DONE, NONE, FAILED) or -run.code == signal.SIGINT, "died of SIGINT")
        return
    require(run.code in command.expected, f"exit code {run.code}, expected {command.expected}: {run.err.strip()[:300]}")
    unknown = [name for name in files.bytes if name not in command.inputs and name not in command.outputs]
    if not command.wrong:
        require(not unknown, f"left {unknown}")
    require(not any(LEFT.match(name) or name.endswith(".journal") for name in unknown), f"left {unknown}")
    for name, data in command.inputs.items():
        require(files.bytes.get(name) == data or name in command.outputs, f"changed its input {name}")
    if run.code == WRONG:
        require(not any(name in files.bytes for name in command.outputs if name not in command.inputs),
                "wrong input, and a file written")
    for name in files.bytes:
        if name not in command.inputs:
            whole(name, files.bytes[name])


def whole(name, data):
    """That a file is one of its kind to its end."""
    if name.endswith(".json"):
        json.loads(data)
    elif name.endswith(".h5"):
        require(data.startswith(b"\x89HDF\r\n\x1a\n"), f"{name} is no HDF5")
    elif name.endswith(".svg"):
        require(data.rstrip().endswith(b"</svg>"), f"{name} is cut off")
    elif name.endswith(".png"):
        require(data.endswith(b"IEND\xaeB`\x82"), f"{name} is cut off")
    elif name.endswith(".html"):
        require(data.rstrip().endswith(b"</html>"), f"{name} is cut off")
    elif name.endswith(".csv") or name == "x":
        require(data.endswith(b"\n"), f"{name} does not end with a line")
        rows = list(csv.reader(io.StringIO(data.decode("utf-8"))))
        require(len({len(row) for row in rows}) == 1, f"{name} has rows of different lengths")


def same(name, data, other):
    """The same, but for what of the metadata is of the run."""
    if data == other:
        return True
    if not name.endswith(".meta.json") or data is None or other is None:
        return False
    both = [json.loads(each) for each in (data, other)]
    for each in both:
        each.pop("run", None)
    return both[0] == both[1]


def rows_of(data):
    return list(csv.reader(io.StringIO(data.decode("utf-8"))))


def part_of(name, data, reference):
    """Rows done so far, each one of the whole table; the number of a point and of a segment may be another."""
    whole(name, data)
    if not reference or name.endswith((".h5", ".json")):
        return
    ours, all_rows = rows_of(data), rows_of(reference)
    require(ours[0] == all_rows[0], "other columns than a whole run's")
    left_out = [k for k, column in enumerate(ours[0]) if column in ("sheet", "point", "segment", "curve")]
    bare = lambda row: tuple(cell for k, cell in enumerate(row) if k not in left_out)
    known = {bare(row) for row in all_rows[1:]}
    strange = [row for row in ours[1:] if bare(row) not in known]
    require(not strange, f"{name}: a row that a whole run has not: {strange[:1]}")


def check_disturbed(run, command, fault, usual, before, files):
    """Of a run with a fault. usual: the run without, with its files; before: what was there already."""
    usual_run, usual_files = usual
    # HDF5 1.10 reads through a null pointer where it gets no memory (H5AC_create).
    hdf5_died = (fault.name == "memory" and run.code in (-signal.SIGSEGV, -signal.SIGABRT)
                 and any(name.endswith(".h5") for name in [*command.inputs, *command.outputs]))
    if not hdf5_died:
        check_end(run, command)
        check_code(run, command, fault, usual_run)
    if fault.stderr != "closed":
        check_message(run, command)
    if command.table == "-" and fault.stdout == "file" and run.code == usual_run.code and run.code in (DONE, NONE):
        require(run.out == usual_run.out, "another table on standard output")
    interrupted = run.code == INTERRUPTED
    for name in command.outputs:
        was, now, meant = before.get(name), files.bytes.get(name), usual_files.bytes.get(name)
        if now is None:
            require(was is None, f"{name} is gone")
        elif now != was and not same(name, now, meant):
            require(interrupted and command.verb != "plot", f"{name} is neither what it was nor what it is to be")
            part_of(name, now, meant)
        if run.code == usual_run.code and run.code in (DONE, NONE):
            require(same(name, now, meant) or meant is None, f"exit code {run.code}, and {name} is not what it is to be")
    if interrupted and "x.meta.json" in command.outputs:
        told = files.bytes.get("x.meta.json")
        if told is not None and told != before.get("x.meta.json") and not same("x.meta.json", told,
                                                                            usual_files.bytes.get("x.meta.json")):
            require(json.loads(told)["status"] == "interrupted", "interrupted, and the metadata do not say so")
    for name, data in command.inputs.items():
        require(files.bytes.get(name) == data or name in command.outputs, f"changed its input {name}")
    killed = run.code < 0
    for name in files.bytes:
        if name in command.inputs or name in command.outputs:
            continue
        if name.endswith(".journal"):
            require(command.resumes, f"left {name}")
            require(killed or run.code in (INTERRUPTED, FAILED, WRONG), f"done, and left {name}")
        else:
            require(killed and LEFT.match(name), f"left {name}")
    if hdf5_died:
        raise Known("HDF5 died for want of memory; no file is half written")


def check_code(run, command, fault, usual):
    """That the exit code fits the fault."""
    allowed = {usual.code}
    if fault.name in ("signal", "two signals"):
        names = [name for _, name in fault.signals]
        allowed |= {-getattr(signal, name) for name in names}
        if any(name in HEEDED for name in names):
            allowed.add(INTERRUPTED)
    elif fault.name == "stdout broken":
        allowed.add(-signal.SIGPIPE)
    elif fault.name == "killed at a call":
        allowed.add(-signal.SIGKILL)
    elif fault.name in ("pause", "stderr closed"):
        pass
    elif fault.name in ("file size", "full disk", "descriptors", "memory", "no lock"):
        allowed |= {FAILED, WRONG}  # what cannot be opened is refused before anything is computed
    else:
        allowed.add(FAILED)
    if run.overdue:
        allowed.add(INTERRUPTED)
    require(run.code in allowed, f"exit code {run.code}, expected {sorted(allowed)}: {run.err.strip()[:300]}")
    if fault.stdout != "file" and usual.out:
        require(run.code != DONE, "exit code 0, and its output was not written")


def check_gone_on(run, command, usual, files, how):
    """After the fault the same command again, with --resume or without: the files that a run has that nothing disturbed."""
    usual_run, usual_files = usual
    check_end(run, command)
    check_message(run, command)
    require(run.code == usual_run.code, f"{how}: exit code {run.code}, not {usual_run.code}: {run.err.strip()[:300]}")
    for name in command.outputs:
        now, meant = files.bytes.get(name), usual_files.bytes.get(name)
        if meant is None:
            continue
        if command.verb == "continue" and how == "--resume":
            check_resumed_curve(name, now, meant)
        else:
            require(same(name, now, meant), f"{how}: {name} is not what it is to be")
    left = [name for name in files.bytes if LEFT.match(name) or name.endswith(".journal")]
    require(not left, f"{how}: left {left}")


def check_resumed_curve(name, now, meant):
    """A table of `continue` gone on with has the same events, at the same places; its steps are its own."""
    whole(name, now)
    if not name.endswith(".json"):
        return
    ours, whole_run = json.loads(now), json.loads(meant)
    require(ours["status"] == whole_run["status"], f"resumed: {ours['status']}, not {whole_run['status']}")
    if ours["status"] != "done":
        return
    kinds = [[event["event"] for event in each["events"]] for each in (ours, whole_run)]
    require(kinds[0] == kinds[1], f"resumed: events {kinds[0]}, not {kinds[1]}")
    for mine, theirs in zip(ours["events"], whole_run["events"]):
        if mine.get("status") == "located" == theirs.get("status"):
            off = abs(mine["parameter"] - theirs["parameter"])
            require(off <= 1e-9 * max(1.0, abs(theirs["parameter"])), f"resumed: {mine['event']} off by {off}")
