"""What is done to a running program, and how it is run."""

import errno
import os
import resource
import signal
import subprocess
import tempfile
import threading
import time
from dataclasses import dataclass, field

# Seconds of the processor, and of the clock where others have it, until a run is asked to end; and from then on.
LONGEST = (60.0, 300.0)
TO_END = (10.0, 60.0)

ENDING = {name: getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP", "SIGPIPE", "SIGKILL")}
HEEDED = ("SIGINT", "SIGTERM")


@dataclass
class Fault:
    name: str = "none"
    signals: list = field(default_factory=list)  # (seconds, name)
    stdout: str = "file"                         # closed, full, broken, broken-ignored
    stderr: str = "file"                         # closed
    limits: dict = field(default_factory=dict)   # of resource
    disk: int = 0                                # KiB of a file system of its own
    environment: dict = field(default_factory=dict)

    def text(self):
        more = [f"{name}@{at:.4f}" for at, name in self.signals]
        more += [f"{name}={value}" for name, value in self.limits.items()]
        more += [f"{name}={value}" for name, value in self.environment.items() if name.startswith("FAULT_")]
        if self.disk:
            more.append(f"{self.disk}k")
        return " ".join([self.name] + more)


@dataclass
class Run:
    code: int      # as subprocess has it: −n is death by signal n
    out: bytes
    err: str
    seconds: float
    overdue: bool = False  # asked to end because it took long
    hung: bool = False     # and did not


def can_mount():
    """Whether a small file system can be had."""
    with tempfile.TemporaryDirectory() as where:
        command = ["unshare", "--map-root-user", "--mount", "mount", "-t", "tmpfs", "-o", "size=64k", "none", where]
        try:
            return subprocess.run(command, capture_output=True).returncode == 0
        except OSError:
            return False


def least_memory(program):
    """Bytes of address space with which the program starts, in steps of a megabyte."""
    low, high = 1, 4096
    while high - low > 1:
        middle = (low + high) // 2
        run_code = subprocess.run([program, "models"], capture_output=True,
                                  preexec_fn=lambda: limit("AS", middle << 20)).returncode
        low, high = (low, middle) if run_code == 0 else (middle, high)
    return high << 20


def limit(name, value):
    resource.setrlimit(getattr(resource, "RLIMIT_" + name), (value, value))


class Faults:
    """Draws them; `skipped` says of what there is none here, and why."""

    def __init__(self, program, shim):
        self.shim = shim
        self.memory = least_memory(program)
        self.skipped = []
        self.kinds = {"signal": 30, "two signals": 6, "pause": 5, "stdout closed": 5, "stdout full": 4,
                      "stdout broken": 5, "stdout broken, SIGPIPE ignored": 4, "stderr closed": 5, "file size": 12,
                      "memory": 12, "descriptors": 5, "full disk": 8, "killed at a call": 12, "no lock": 2}
        if not shim:
            self.skip(("killed at a call", "no lock"), "no fault_shim was named")
        if not can_mount():
            self.skip(("full disk",), "no tmpfs can be mounted: unshare --map-root-user --mount fails")

    def skip(self, names, why):
        for name in names:
            del self.kinds[name]
            self.skipped.append((name, why))

    def draw(self, rng, usual, size, held, directory):
        """usual, size: seconds and bytes of what the undisturbed run wrote; held: KiB of a disk that has its inputs."""
        kind = rng.choices(list(self.kinds), list(self.kinds.values()))[0]
        fault = Fault(kind)
        when = lambda: usual * (rng.random() * 1.1 if rng.random() < 0.7 else rng.random() ** 4)
        if kind == "signal":
            fault.signals = [(when(), rng.choice(sorted(ENDING)))]
        elif kind == "two signals":
            fault.signals = sorted((when(), rng.choice(HEEDED)) for _ in range(2))
        elif kind == "pause":
            at = when()
            fault.signals = [(at, "SIGSTOP"), (at + 0.02, "SIGCONT")]
        elif kind.startswith("stdout"):
            fault.stdout = kind
        elif kind == "stderr closed":
            fault.stderr = "closed"
        elif kind == "file size":
            fault.limits = {"FSIZE": int(rng.random() * 1.1 * size) if rng.random() < 0.8 else rng.randrange(200)}
        elif kind == "memory":
            # Below what it starts with nothing of the program runs.
            fault.limits = {"AS": self.memory + int(rng.random() ** 3 * (200 << 20))}
        elif kind == "descriptors":
            # With fewer its libraries are not found.
            fault.limits = {"NOFILE": rng.randint(5, 14)}
        elif kind == "full disk":
            fault.disk = held + 4 * rng.randint(1, max(2, size // 3500))
        elif kind == "killed at a call":
            fault.environment = {"LD_PRELOAD": self.shim, "FAULT_AT": str(rng.randint(1, 12)),
                                 "FAULT_WHEN": rng.choice(("before", "half", "after")), "FAULT_UNDER": directory + "/"}
        elif kind == "no lock":
            fault.environment = {"LD_PRELOAD": self.shim,
                                 "FAULT_LOCK": str(rng.choice((errno.ENOLCK, errno.EAGAIN, errno.EINVAL)))}
        return fault


# $1: the directory; $2: its size in KiB; then the command, in it.
ON_A_SMALL_DISK = """
disk=$1 size=$2 kept=$3
shift 3
mount -t tmpfs -o size="$size"k,mode=755 none "$disk" || exit 199
cp -a "$kept"/. "$disk" 2> /dev/null || exit 198
cd "$disk" || exit 197
"$@"
code=$?
for at in $(ls -A "$disk"); do cp -a "$disk/$at" "$kept"; done
for at in $(ls -A "$kept"); do [ -e "$disk/$at" ] || rm -f "$kept/$at"; done
exit $code
"""


def run(program, words, directory, fault=Fault()):
    """The command in a directory, with a fault."""
    command = [program] + words
    if fault.disk:
        disk = directory + ".disk"
        os.makedirs(disk, exist_ok=True)
        command = ["unshare", "--map-root-user", "--mount", "sh", "-c", ON_A_SMALL_DISK, "sh", disk, str(fault.disk),
                   directory] + command
    environment = {k: v for k, v in os.environ.items() if not k.startswith("FAULT_")}
    environment.update(fault.environment)
    given = {"stdin": subprocess.DEVNULL, "stdout": subprocess.PIPE, "stderr": subprocess.PIPE}
    others = []
    if fault.stdout.startswith("stdout broken"):
        reader, given["stdout"] = os.pipe()
        os.close(reader)
        others = [given["stdout"]]
    elif fault.stdout == "stdout full":
        given["stdout"] = os.open("/dev/full", os.O_WRONLY)
        others = [given["stdout"]]

    def prepare():
        os.nice(5)
        if fault.stdout == "stdout closed":
            os.close(1)
        if fault.stdout == "stdout broken, SIGPIPE ignored":
            signal.signal(signal.SIGPIPE, signal.SIG_IGN)
        if fault.stderr == "closed":
            os.close(2)
        for name, value in fault.limits.items():
            limit(name, value)

    begin = time.monotonic()
    process = subprocess.Popen(command, cwd=directory, env=environment, preexec_fn=prepare, **given)
    for each in others:
        os.close(each)
    texts = [Drained(each) for each in (process.stdout, process.stderr)]
    overdue = hung = False
    try:
        for at, name in fault.signals:
            if ended(process, begin + at - time.monotonic()):
                break
            process.send_signal(getattr(signal, name))
        if not ended_within(process, LONGEST):
            overdue = True
            process.send_signal(signal.SIGINT)
            hung = not ended_within(process, TO_END)
    finally:
        if process.poll() is None:
            process.kill()
            process.wait()
    seconds = time.monotonic() - begin
    out, err = (each.all() for each in texts)
    return Run(process.returncode, out, err.decode("utf-8", "replace"), seconds, overdue, hung)


class Drained:
    """What comes out of a pipe; a thread reads it, so that nobody waits."""

    def __init__(self, pipe):
        self.bytes = b""
        self.thread = None
        if pipe is not None:
            self.thread = threading.Thread(target=self.read, args=(pipe,))
            self.thread.start()

    def read(self, pipe):
        with pipe:
            self.bytes = pipe.read()

    def all(self):
        if self.thread:
            self.thread.join()
        return self.bytes


def processor_seconds(process):
    """Spent so far; of a process that is not waited for."""
    with open(f"/proc/{process.pid}/stat") as file:
        fields = file.read().rpartition(")")[2].split()
    return sum(map(int, fields[11:13])) / os.sysconf("SC_CLK_TCK")


def ended_within(process, limits):
    busy, begin = processor_seconds(process) if process.poll() is None else 0.0, time.monotonic()
    while not ended(process, 0.5):
        if processor_seconds(process) - busy > limits[0] or time.monotonic() - begin > limits[1]:
            return False
    return True


def ended(process, seconds):
    try:
        process.wait(max(seconds, 0.0))
        return True
    except subprocess.TimeoutExpired:
        return False
