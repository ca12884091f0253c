"""Random commands over all that the program does. Each is complete in itself: the files that it reads are its own."""

import copy
import json
from dataclasses import dataclass, field

from cases import (Number, add_continuation, add_curve, add_map, anisotropic, get, numbers_of, put, random_case, short,
                   toml)

DONE, WRONG, NONE, FAILED, INTERRUPTED = 0, 2, 3, 4, 130

WEIGHTS = {"solve": 26, "continue": 16, "atlas": 8, "map": 12, "curve": 5, "sensitivity": 7, "study": 8, "check": 6,
           "models": 2, "plot": 9, "explore": 4, "help": 2}
SHOWN = ("energy", "growth", "xi", "lambda,mu", "pi1,pi2,pi3", "im1", "nothing")


@dataclass
class Command:
    verb: str
    words: list
    inputs: dict = field(default_factory=dict)   # name: bytes
    outputs: list = field(default_factory=list)  # names of all files that it may write
    expected: tuple = (DONE, NONE, FAILED)       # exit codes
    tree: dict = None                            # the case, with what --set makes of it
    table: str = ""                              # what -o names
    resumes: bool = False                        # has a journal, or takes --resume
    wrong: str = ""                              # what is wrong with it on purpose

    def directory_size(self):
        return 8 + sum(4 * (len(each) // 4096 + 1) for each in self.inputs.values())


@dataclass
class Made:
    """A table of an earlier command."""
    verb: str
    words: list
    name: str
    files: dict
    case: bytes
    rows: int
    events: list


class Grammar:
    def __init__(self, shipped, hdf5, made):
        """shipped: cases as texts, by name; hdf5: whether such files are written; made(words, inputs): the files
        that a command leaves, undisturbed."""
        self.shipped = shipped
        self.hdf5 = hdf5
        self.made = made
        self.pool = []  # of Made

    def keep(self, made):
        self.pool = self.pool[-60:] + [made]

    def draw(self, rng):
        verb = rng.choices(list(WEIGHTS), list(WEIGHTS.values()))[0]
        if verb in ("plot", "explore") and not self.pool:
            verb = "solve"
        command = getattr(self, "draw_" + verb)(rng)
        if command.table == "x.csv" and command.resumes and verb in ("map", "study") and "--part" not in command.words \
                and rng.random() < 0.12:
            self.merge(rng, command)
        if rng.random() < 0.13:
            spoil(rng, command)
        return command

    # What computes.

    def computing(self, rng, verb, tree, words):
        """The command, with what all of them take."""
        command = Command(verb, [verb, "case.toml"] + words, tree=tree)
        in_file = copy.deepcopy(tree)
        for _ in range(rng.choice((0, 0, 1, 2))):  # some numbers only by --set
            path = rng.choice(numbers_of(tree) + ([] if "nu" not in tree["motion"] else ["motion.nu"]))
            value = get(tree, path)
            put(in_file, path, Number(short(rng, 0.5, 2)))
            command.words += ["--set", f"{path}={value}"]
        command.inputs["case.toml"] = toml(in_file).encode()
        table = rng.choices(("x.csv", "x.h5", "x", "-", ""), (55, 20 if self.hdf5 else 0, 5, 12, 8))[0]
        if table:
            command.words += [rng.choice(("-o", "--output")), table]
            command.table = table
            if table != "-":
                command.outputs += [table, "x.meta.json"]
        if rng.random() < 0.3 and verb != "sensitivity":
            command.words.append("--certify")
        if rng.random() < 0.4:
            command.words.append(rng.choice(("-q", "--quiet")))
        if rng.random() < 0.3:
            command.words += ["--threads", str(rng.choice((1, 2, 3, 7)))]
        return command

    def draw_solve(self, rng):
        if rng.random() < 0.06:
            return self.of_shipped(rng, "solve")
        tree = random_case(rng)
        command = self.computing(rng, "solve", tree, [])
        if "method" in tree.get("solve", {}):
            command.expected = (DONE, WRONG, NONE, FAILED)  # not every motion has every method
        return command

    def of_shipped(self, rng, verb):
        name = rng.choice(sorted(self.shipped))
        command = Command(verb, [verb, name, "-o", "x.csv", "--set", f"motion.nu={short(rng, 0.05, 1.2)}"],
                          {name: self.shipped[name]}, ["x.csv", "x.meta.json"], (DONE, WRONG, NONE, FAILED),
                          table="x.csv")
        return command

    def continued(self, rng):
        tree = random_case(rng)
        add_continuation(rng, tree)
        return tree

    def draw_continue(self, rng):
        tables = [each for each in self.pool if each.verb in ("continue", "atlas", "solve") and each.rows > 0]
        if tables and rng.random() < 0.2:
            return self.continue_from(rng, rng.choice(tables))
        command = self.computing(rng, "continue", self.continued(rng), [])
        command.expected = (DONE, WRONG, NONE, FAILED)  # a parameter of this motion, a method, an axis to choose
        command.resumes = command.table not in ("", "-")
        return command

    def continue_from(self, rng, made):
        row = str(rng.randint(1, made.rows))
        if made.events and rng.random() < 0.5:
            row = rng.choice(made.events)
        words = ["continue", "case.toml", "--from", f"from_{made.name}:{row}", "-o", "y.csv",
                 "--set", "continuation.from=0", "--set", f"continuation.to={short(rng, 0.5, 1.5)}",
                 "--set", "continuation.tolerance=1e-5"]
        if rng.random() < 0.3:
            words += ["--set", f"motion.branch={rng.choice(('i', 'iii', 'tilted'))}"]
        inputs = {"case.toml": made.case}
        inputs.update({"from_" + name: data for name, data in made.files.items()})
        return Command("continue", words, inputs, ["y.csv", "y.meta.json"], (DONE, WRONG, NONE, FAILED), table="y.csv")

    def draw_atlas(self, rng):
        tree = random_case(rng)
        if tree["motion"]["branch"] == "two-polar" or "solve" in tree:
            tree["motion"] = {"branch": "iii", "nu": Number("0.5")}
            tree.pop("solve", None)
        add_continuation(rng, tree, spin_only=True)
        tree["continuation"]["to"] = Number(short(rng, 0.2, 1.2))
        tree["continuation"]["from"] = Number("0.0")
        words = []
        points = 1 if anisotropic(tree) else rng.choice((4, 16, 64))
        # Searches of anisotropic bodies take seconds, proofs of formulas minutes.
        if not anisotropic(tree) and rng.random() < 0.3:
            add_map(rng, tree, body_only=True, most=3)
            words += ["--grid", "--checkpoints", str(points)]
            if self.hdf5 and rng.random() < 0.4:
                words += ["--tables", "all.h5"]
        else:
            words += ["--checkpoints", str(points)]
            if rng.random() < (0.07 if "expression" in str(tree["potential"]) else 0.4):
                words.append("--complete")
            if rng.random() < 0.25:
                words += ["--least-energy", "least.csv"]
        command = self.computing(rng, "atlas", tree, words)
        if "--tables" in words:
            command.outputs.append("all.h5")
        if "--least-energy" in words:
            command.outputs.append("least.csv")
        command.expected = (DONE, WRONG, NONE, FAILED)  # of tilted and other motions there is none
        command.resumes = command.table not in ("", "-")
        return command

    def draw_map(self, rng):
        tree = random_case(rng)
        while "nu" not in tree["motion"]:
            tree = random_case(rng)
        many = tree["motion"]["branch"] in ("i", "ii", "iii") and not anisotropic(tree) and rng.random() < 0.3
        add_map(rng, tree, most=150 if many else 12 if anisotropic(tree) else 16)
        words = []
        if rng.random() < 0.15:
            of = rng.randint(1, 4)
            words = ["--part", f"{rng.randint(1, of)}/{of}"]
        command = self.computing(rng, "map", tree, words)
        if words and command.table in ("", "-"):
            command.expected = (WRONG,)
        else:
            command.expected = (DONE, WRONG, NONE, FAILED)
        command.resumes = command.table not in ("", "-")
        return command

    def draw_curve(self, rng):
        tree = random_case(rng)
        if "nu" not in tree["motion"]:
            tree["motion"] = {"branch": "i", "nu": Number("0.5")}
        add_curve(rng, tree)
        command = self.computing(rng, "curve", tree, [])
        command.expected = (DONE, WRONG, NONE, FAILED)
        return command

    def draw_sensitivity(self, rng):
        tree = random_case(rng)
        words = []
        if rng.random() < 0.25:
            add_continuation(rng, tree)
            words.append("--events")
        if rng.random() < 0.5:
            names = rng.sample(numbers_of(tree), 2)
            tree.setdefault("output", {})["uncertainty"] = {n: Number(short(rng, 1e-3, 1e-1)) for n in names}
        tree.get("output", {}).pop("certificate", None)
        command = self.computing(rng, "sensitivity", tree, words)
        command.expected = (DONE, WRONG, NONE, FAILED)
        return command

    def draw_study(self, rng):
        tree = random_case(rng)
        do = rng.choices(("solve", "continue", "atlas"), (6, 2, 1))[0]
        columns = rng.sample([n for n in numbers_of(tree)], rng.randint(1, 2))
        if "nu" in tree["motion"]:
            columns.append("motion.nu")
        rows = rng.choice((1, 3, 8, 40)) if do == "solve" else rng.choice((1, 2, 4))
        if do == "atlas" and (tree["motion"]["branch"] == "two-polar" or anisotropic(tree)) or "solve" in tree:
            do = "solve"
        if do != "solve":
            add_continuation(rng, tree, spin_only=True)
            tree["continuation"]["max_points"] = Number("400")
        lines = [",".join(columns + ["_tag"])]
        for k in range(rows):
            cells = [short(rng, 0.4, 1.6) if rng.random() < 0.93 else rng.choice(("", "-1.0", "fast", "1e400"))
                     for _ in columns]
            lines.append(",".join(cells + [rng.choice((f"row {k}", '"a, b"', '"say ""so"""', "µ"))]))
        words = ["--over", "over.csv", "--do", do]
        if do == "atlas":
            words += ["--checkpoints", "8"]
        if rng.random() < 0.1:
            words += ["--part", "1/2"]
        command = self.computing(rng, "study", tree, words)
        command.inputs["over.csv"] = ("\n".join(lines) + "\n").encode()
        command.expected = (DONE, WRONG, NONE, FAILED)
        command.resumes = command.table not in ("", "-")
        return command

    def draw_check(self, rng):
        if rng.random() < 0.3:
            name = rng.choice(sorted(self.shipped))
            return Command("check", ["check", name], {name: self.shipped[name]}, expected=(DONE,))
        tree = self.continued(rng)
        return Command("check", ["check", "case.toml"], {"case.toml": toml(tree).encode()}, tree=tree,
                       expected=(DONE, WRONG))

    def draw_models(self, rng):
        name = rng.choice(("", "", "hencky", "biot-log", "harmonic", "neo-hookean-3d", "fibre", "henky"))
        return Command("models", ["models"] + ([name] if name else []),
                       expected=(WRONG,) if name == "henky" else (DONE,))

    def draw_help(self, rng):
        word = rng.choice(sorted(WEIGHTS) + [""])
        words = rng.choice((["help"] + ([word] if word else []), ([word] if word else []) + ["--help"],
                            ([word] if word else []) + ["--version"]))
        return Command("help", words, expected=(DONE,))

    def merge(self, rng, command):
        """Parts of the same in place of computing it."""
        of = rng.randint(1, 3)
        words = [word for word in command.words if word not in ("-o", "--output", "x.csv")]
        for k in range(1, of + 1):
            files = self.made(words + ["--part", f"{k}/{of}", "-o", f"p{k}.csv"], command.inputs)
            for name in (f"p{k}.csv", f"p{k}.meta.json"):
                if name in files:
                    command.inputs[name] = files[name]
        command.words += ["--merge"] + [f"p{k}.csv" for k in range(1, of + 1)]
        command.resumes = False

    # What reads tables.

    def taken(self, rng, most):
        """Some earlier tables, as inputs under names of their own."""
        inputs, names = {}, []
        for k, made in enumerate(rng.sample(self.pool, min(len(self.pool), rng.randint(1, most)))):
            for name, data in made.files.items():
                inputs[f"t{k}_{name}"] = data
            names.append(f"t{k}_{made.name}")
        return inputs, names

    def draw_plot(self, rng):
        inputs, names = self.taken(rng, 2)
        output = rng.choices(("p.svg", "p.png", "-"), (6, 1, 2))[0]
        words = ["plot"] + names + ["-o", output]
        outputs = [] if output == "-" else [output]
        if rng.random() < 0.3:
            words += ["--script", "p.gp"]
            outputs.append("p.gp")
        if rng.random() < 0.3:
            words += ["--show", rng.choice(SHOWN)]
        if rng.random() < 0.2:
            words += ["--diagram", "energy-momentum"]
        if rng.random() < 0.2:
            words += ["--sheet", rng.choice(("1", "1,2", "7"))]
        if rng.random() < 0.2:
            words += ["--range", rng.choice(("y=0.5:2", "x=0:1", "rate=0:3", "y=2:1", "y=oops"))]
        if rng.random() < 0.2:
            words += ["--size", rng.choice(("640x480", "300x200", "0x0", "wide"))]
        if rng.random() < 0.2:
            words.append("-q")
        return Command("plot", words, inputs, outputs, (DONE, WRONG, FAILED))

    def draw_explore(self, rng):
        inputs, names = self.taken(rng, 3)
        if rng.random() < 0.2:
            name = rng.choice(sorted(self.shipped))
            inputs, names = {name: self.shipped[name]}, [name]
        words = ["explore"] + names + ["-o", "page.html"]
        if rng.random() < 0.3:
            words.append("--no-live")
        if rng.random() < 0.3:
            words += ["--title", "A <b>title</b> & 'more'"]
        return Command("explore", words, inputs, ["page.html"], (DONE, WRONG, FAILED))


# What is wrong on purpose.

def spoil(rng, command):
    """One fault. The exit code is then 2, or where a table or text is changed at random whatever fits."""
    words = command.words
    ways = ["option", "argument"]
    if "case.toml" in command.inputs and "case.toml" in words:
        ways += ["no case", "bytes of case", "key", "value", "number", "case as output"]
    if any(name.endswith((".csv", ".h5", ".json")) for name in command.inputs):
        ways += ["bytes of table"] * 3 + ["no table"]
    if command.table:
        ways += ["suffix", "directory", "full device"]
    way = command.wrong = rng.choice(ways)
    command.tree = None
    exit_two = (WRONG,)
    if way == "option":
        words.insert(rng.randint(1, len(words)), rng.choice(("--nonsense", "--certfy", "--set", "-z", "--threads=0")))
        exit_two = (DONE, WRONG, NONE, FAILED) if "--set" in words or command.verb == "help" else (WRONG,)
    elif way == "argument":
        words.append("surplus")
        exit_two = (DONE, WRONG, FAILED)  # help and lists of tables take it
    elif way == "no case":
        words[words.index("case.toml")] = "none.toml"
    elif way == "no table":
        name = rng.choice([n for n in command.inputs if n.endswith((".csv", ".h5", ".json"))])
        del command.inputs[name]
        exit_two = (DONE, WRONG, NONE, FAILED)
    elif way in ("bytes of case", "bytes of table"):
        names = [n for n in command.inputs
                 if n.endswith((".csv", ".h5", ".json")) == (way == "bytes of table") and command.inputs[n]]
        if not names:
            return
        name = rng.choice(names)
        command.inputs[name] = damaged(rng, command.inputs[name])
        exit_two = (DONE, WRONG, NONE, FAILED)
    elif way == "key":
        words += ["--set", rng.choice(("motion.mu=1", "boddy.J=[1,1,1]", "body.J.3=1", "solve.al=true", "=1", "x"))]
        exit_two = (WRONG, FAILED) if command.verb == "study" else (WRONG,)  # what a row's case is wrong in is the row's
    elif way == "value":
        words += ["--set", rng.choice(("motion.branch=iv", "body.J=[1,1]", "body.J=[1,-1,1]", "output.columns=[\"no\"]",
                                       "solve.method=guess", "continuation.tolerance=2", "body.J.0=0"))]
        exit_two = (DONE, WRONG, FAILED) if command.verb == "study" else (WRONG,)  # its table may have the key
    elif way == "number":
        words += ["--set", rng.choice(("body.J.0=nan", "body.J.0=1e99", "body.J.0=-inf", "motion.nu=1e300"))]
        exit_two = (DONE, WRONG, FAILED) if command.verb == "study" else (WRONG,)  # its table may have the key
    elif way == "case as output":
        words += ["-o", "case.toml"]
        if command.table:
            exit_two = (WRONG,)
    elif way == "suffix":
        words[words.index(command.table)] = "x.txt"
    elif way == "full device":
        words[words.index(command.table)] = "/dev/full"
        exit_two = (WRONG, NONE, FAILED)
    elif way == "directory":
        words[words.index(command.table)] = "nowhere/x.csv"
    command.expected = exit_two


def damaged(rng, data):
    """Bytes flipped, taken out, doubled, or cut off."""
    out = bytearray(data)
    for _ in range(rng.choice((1, 1, 2, 5))):
        if not out:
            break
        at = rng.randrange(len(out))
        kind = rng.randrange(5)
        if kind == 0:
            out[at] ^= 1 << rng.randrange(8)
        elif kind == 1:
            out[at:at + rng.randint(1, 20)] = b""
        elif kind == 2:
            out[at:at] = out[at:at + rng.randint(1, 200)]
        elif kind == 3:
            out = out[:at]
        else:
            out[at:at + 1] = rng.choice((b"nan", b"-", b"1e999", b"\0", b"\xff", b",", b"\n", b'"', b"[", b"="))
    return bytes(out)


def made_by(command, directory, read):
    """What a command that was done leaves for others to read; None where that is nothing."""
    if command.table in ("", "-") or command.tree is None or "--part" in command.words:
        return None
    files = {name: read(directory, name) for name in (command.table, "x.meta.json")}
    if None in files.values():
        return None
    told = json.loads(files["x.meta.json"])
    events = []
    for event in told.get("events", []):
        if event.get("status") != "unresolved" and event["event"] not in events:
            events.append(event["event"])
    return Made(command.verb, command.words, command.table, files, toml(command.tree).encode(), told.get("rows", 0), events)
