#!/usr/bin/env python3
"""Makes a tree of mutants: a copy of the sources in which some hundred places are each written
twice, as they are and with a fault. The environment variable MUTANT, read once, chooses the one
fault that is on; without it the copy computes what the sources do. So all of them are compiled at
once.

    make_mutants.py SOURCE BUILD [--count N] [--seed S] [--jobs J]

BUILD/tree is the copy and BUILD/mutants.csv the list: number, file, line, kind, text, and what it
becomes. Places are chosen by a hash of the seed and of the line, a number from each room, so that
an edit elsewhere leaves them as they are. A place that does not compile is left out: every source
of the libraries and of the tests is parsed (-fsyntax-only) until none has an error. Then

    cmake --build BUILD/build --target TESTS

with the tests of run_mutants.py. Kinds of fault:

    negated      if (C)             if (!C)
    never        if (C)             if (false)
    always       if (C)             if (true)
    dropped      A && B, A || B     A
    comparison   a < b              a >= b           and the others
    boundary     a < b              a <= b           and the others
    sign         a + b, a - b, -a   the other sign
    accumulated  a += b             a -= b           and back
    constant     2.0, 0x1p-50       3.0, 0x1p-60
    extreme      std::min           std::max         and back
    swapped      f(a, b)            f(b, a)
    returned     return true        return false     and back
"""
import argparse
import csv
import hashlib
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import threading
from concurrent.futures import ThreadPoolExecutor

# Places of each room.
ROOMS = {
    "lib/number": 36, "lib/matrix": 15, "lib/body": 20, "lib/gravity": 25, "lib/material": 35,
    "lib/balance": 30, "lib/balanced": 20, "lib/stability": 55, "solver/newton": 20, "solver/motion": 25, "solver/continuation": 40,
    "solver/family": 30, "solver/kind": 55, "solver/proof": 35, "solver/search": 20, "solver/tube": 25,
    "solver/solve": 25, "solver/atlas": 15, "solver/normal_form": 15,
}
# Of numbers, those that bounds are made of; formulas from text, tables and lanes have tests that are
# not run here.
NUMBER = {"interval.hpp", "enclosed_pair.hpp", "interval_functions.hpp", "dual.hpp", "first_order_bound.hpp",
          "first_order_bound_functions.hpp", "double_double.hpp", "double_double_functions.hpp",
          "running_error.hpp", "root_discs.cpp", "root_discs.hpp", "sloped.hpp", "taylor.hpp"}
LEFT_OUT = {"lib/material/models/expression.cpp", "lib/material/models/expression.hpp",
            "lib/material/models/anisotropic_expression.hpp", "lib/material/models/tape_model.hpp",
            "solver/newton/no_ceres.cpp", "solver/newton/no_nlopt.cpp",
            "solver/search/search_message.cpp"}
# How likely a place of each kind is chosen beside others.
WEIGHT = {"negated": 1.0, "never": 0.8, "always": 0.8, "dropped": 1.2, "comparison": 1.0,
          "boundary": 0.2, "sign": 1.0, "accumulated": 2.0, "constant": 0.8, "extreme": 2.0,
          "swapped": 0.7, "returned": 0.8}
SYMMETRIC = {"hull", "common", "two_sum", "two_product", "hypot", "min", "max", "swap", "dot"}

HEADER = """// Written by tests/mutation/make_mutants.py.
#pragma once
#include <array>
#include <atomic>
#include <cstdio>
#include <cstdlib>
namespace mutation {
inline const int chosen = [] {
  const char* number = std::getenv("MUTANT");
  return number == nullptr ? 0 : std::atoi(number);
}();
// The places that this process came by, for the file that MUTANT_REACHED names.
struct Reached {
  std::array<std::atomic<bool>, 4096> place{};
  ~Reached() {
    const char* const path = std::getenv("MUTANT_REACHED");
    std::FILE* const file = path == nullptr ? nullptr : std::fopen(path, "a");
    if (file == nullptr) return;
    for (std::size_t n = 0; n < place.size(); ++n)
      if (place[n]) std::fprintf(file, "%zu\\n", n);
    std::fclose(file);
  }
};
inline Reached reached;
inline bool on(int number) {
  reached.place[static_cast<std::size_t>(number)].store(true, std::memory_order_relaxed);
  return chosen == number;
}
}  // namespace mutation
"""


def blanked(text):
    """The text without comments and directives, and without strings as well; places stay."""
    code, mask = list(text), list(text)

    def blank(begin, end, *where):
        for i in range(begin, end):
            if text[i] != "\n":
                for target in where:
                    target[i] = " "

    pattern = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"'
                         r"|(?<![0-9a-fA-F])'(?:\\.|[^'\\\n])+'|^[ \t]*#(?:\\\n|[^\n])*", re.S | re.M)
    for match in pattern.finditer(text):
        if match[0].startswith(("//", "/*")) or match[0].lstrip().startswith("#"):
            blank(match.start(), match.end(), code, mask)
        else:
            blank(match.start() + 1, match.end() - 1, mask)
    return "".join(code), "".join(mask)


OPEN, CLOSE = "([{", ")]}"


def closing(mask, at):
    """Where the bracket at `at` is closed."""
    depth = 0
    for i in range(at, len(mask)):
        if mask[i] in OPEN:
            depth += 1
        elif mask[i] in CLOSE:
            depth -= 1
            if depth == 0:
                return i
    return len(mask)


def bodies(mask):
    """The bodies of functions that are not constant expressions."""
    out, stack, begin, i = [], [], 0, 0
    while i < len(mask):
        c = mask[i]
        if c == "(":
            i = closing(mask, i)
        elif c in ";}":
            begin = i + 1
        elif c == "{":
            head = mask[begin:i].strip()
            scope = re.match(r"(template\s*<.*>\s*)?(inline )?(namespace|class|struct|union|extern)\b",
                             head, re.S)
            function = re.search(r"\)\s*((const|noexcept|override|final)\s*)*(->[^;{}]+)?$", head)
            if function is None:
                function = re.search(r"\)\s*(const\s*)?:\s*[^;]*[)}]$", head)
            if scope and not re.search(r"\)\s*$", head):
                begin = i + 1
            else:
                end = closing(mask, i)
                if function and not re.search(r"\b(constexpr|consteval|concept|enum|decltype)\b", head):
                    out.append((i + 1, end))
                i = end
                # Of a constructor's list, x{...} and what follows are one head.
                if not re.search(r"\)\s*:\s*[^;]*$", head) or function:
                    begin = i + 1
        i += 1
    return out


def constant_parts(mask, begin, end):
    """Inside a body: what must stay a constant expression, and heads of loops that count."""
    out = []
    for match in re.compile(r"\bconstexpr\b|\bstatic_assert\b|\bdecltype\b|\bsizeof\b|\bnoexcept\b"
                            r"|\bcase\b|\bfor\b|\btemplate\b|\brequires\b").finditer(mask, begin, end):
        if match[0] in ("static_assert", "decltype", "sizeof", "noexcept", "for"):
            bracket = mask.find("(", match.end())
            close = closing(mask, bracket)
            if match[0] != "for" or ";" in mask[bracket:close]:
                out.append((match.start(), close))
        elif match[0] == "case":
            out.append((match.start(), mask.find(":", match.end()) + 1))
        elif re.match(r"\s*\(", mask[match.end():]):
            out.append((match.start(), closing(mask, mask.find("(", match.end()))))
        else:
            out.append((match.start(), right(mask, match.end(), None, ";")))
    return out


def right(mask, at, operators, ends=",;"):
    """Where an operand that begins at `at` ends: at one of the operators, or of its bracket."""
    i = at
    while i < len(mask):
        c = mask[i]
        if c in OPEN:
            i = closing(mask, i)
        elif c in CLOSE or c in ends:
            return i
        elif operators and c.isspace():
            match = operators.match(mask, i)
            if match and i > at:
                return i
        i += 1
    return len(mask)


def left(mask, at, operators):
    """Where an operand that ends at `at` begins."""
    depth, i = 0, at - 1
    while i >= 0:
        c = mask[i]
        if c in CLOSE:
            depth += 1
        elif c in OPEN:
            if depth == 0:
                return i + 1
            depth -= 1
        elif depth == 0:
            if c in ",;":
                return i + 1
            if c.isspace():
                match = operators.match(mask, i)
                if match and match.end() <= at:
                    return match.end()
                match = re.compile(r"\s(return|co_return)\s").match(mask, i)
                if match:
                    return match.end()
        i -= 1
    return 0


LOGICAL = r"&&|\|\||\?|:|=|[-+*/|&]="
RELATION = r"<=>|<=|>=|<|>|==|!="
AFTER_OR = re.compile(r"\s(\|\||\?|:|=)\s")
AFTER_AND = re.compile(r"\s(%s)\s" % LOGICAL)
AFTER_RELATION = re.compile(r"\s(%s|%s)\s" % (LOGICAL, RELATION))
AFTER_SUM = re.compile(r"\s(%s|%s|<<|>>|\+|-|\||&)\s" % (LOGICAL, RELATION))
OTHER = {"<": ">=", "<=": ">", ">": "<=", ">=": "<", "==": "!=", "!=": "=="}
NEXT = {"<": "<=", "<=": "<", ">": ">=", ">=": ">"}


def changed_constant(literal):
    value = float.fromhex(literal) if literal.lower().startswith("0x") else float(literal)
    if value == 0.0:
        return "1.0"
    if abs(value) < 1e-3:
        return "0x1p-10 * " + literal
    return ("0x1p10 * " if abs(value) > 1e3 else "1.5 * ") + literal


def places(path, text):
    """All that could be changed: (begin, end, kind, what it becomes with {n} for its number)."""
    code, mask = blanked(text)
    out = []

    def piece(begin, end):
        return " ".join(code[begin:end].split())

    def add(begin, end, kind, becomes, shown):
        out.append((begin, end, kind, becomes, piece(begin, end), shown))

    for begin, end in bodies(mask):
        fixed = constant_parts(mask, begin, end)

        def found(pattern):
            for match in re.compile(pattern).finditer(mask, begin, end):
                if not any(a <= match.start() < b for a, b in fixed):
                    yield match

        for match in found(r"\bif\s*\("):
            a = match.end()
            b = closing(mask, a - 1)
            condition = piece(a, b)
            if ";" in mask[a:b] or re.search(r"[^=!<>]=[^=]", mask[a:b]):
                continue
            add(a, b, "negated", f"(mutation::on({{n}}) != static_cast<bool>({condition}))",
                f"!({condition})")
            add(a, b, "never", f"(!mutation::on({{n}}) && ({condition}))", "false")
            add(a, b, "always", f"(mutation::on({{n}}) || ({condition}))", "true")
        for match in found(r"\s(&&|\|\|)\s"):
            a = match.end()
            b = right(mask, a, AFTER_AND if match[1] == "&&" else AFTER_OR)
            operand = piece(a, b)
            if match[1] == "&&":
                add(a, b, "dropped", f"(mutation::on({{n}}) || ({operand}))", "true")
            else:
                add(a, b, "dropped", f"(!mutation::on({{n}}) && ({operand}))", "false")
        for match in found(r"\s(<=|>=|<|>|==|!=)\s"):
            a = left(mask, match.start() + 1, AFTER_RELATION)
            b = right(mask, match.end(), AFTER_RELATION)
            x, y = piece(a, match.start()), piece(match.end(), b)
            if not x or not y:
                continue
            for kind, table in (("comparison", OTHER), ("boundary", NEXT)):
                if match[1] in table:
                    to = table[match[1]]
                    add(a, b, kind,
                        f" (mutation::on({{n}}) ? ({x}) {to} ({y}) : ({x}) {match[1]} ({y}))",
                        f"{x} {to} {y}")
        for match in found(r"\s[-+]\s"):
            a = match.end()
            b = right(mask, a, AFTER_SUM)
            x = piece(a, b)
            if not x or '"' in piece(max(begin, a - 60), b):
                continue
            add(a, b, "sign", f"(mutation::on({{n}}) ? -({x}) : ({x}))", f"-({x})")
        for match in found(r"(?<=[(,=?:{ ])-(?=[A-Za-z_(])"):
            if not re.search(r"([(,=?:{]|\breturn)\s*$", mask[begin:match.start()]):
                continue
            a = match.start()
            chain = re.compile(r"[\w.:]*(\[[^][]*\])?").match(mask, a + 1)
            b = chain.end()
            while b < end and mask[b] in "([":
                b = closing(mask, b) + 1
                b = re.compile(r"[\w.:]*").match(mask, b).end()
            x = piece(a + 1, b)
            add(a, b, "sign", f"(mutation::on({{n}}) ? ({x}) : -({x}))", x)
        for match in found(r"\s([-+])=\s"):
            a = max(mask.rfind(c, 0, match.start()) for c in ";{}")
            statement = left(mask, match.start() + 1, re.compile(r"(?!)"))
            b = right(mask, match.end(), None, ";")
            if statement < a or mask[b:b + 1] != ";":
                continue
            a = statement
            # After `if (...)`, `for (...)` or `else` on the same statement begin behind it.
            while True:
                head = re.compile(r"\s*(if|for|while)\s*\(|\s*else\b").match(mask, a)
                if not head:
                    break
                a = closing(mask, head.end() - 1) + 1 if head[1] else head.end()
            target, value = piece(a, match.start()), piece(match.end(), b)
            if not re.fullmatch(r"[\w.\[\]()>*, +-]+", target) or re.search(r"^\w+ \w+", target):
                continue
            now, then = match[1] + "=", "-+"[match[1] == "-"] + "="
            add(a, b + 1, "accumulated", f" {{{{ if (mutation::on({{n}})) {target} {then} {value}; "
                f"else {target} {now} {value}; }}}}", f"{target} {then} {value}")
        for match in found(r"(?<![\w.])(0x[0-9a-fA-F.]+p[-+]?\d+|\d+\.\d+(e[-+]?\d+)?)(?![\w.])"):
            if float.fromhex(match[1]) == 0.0 if match[1].startswith("0x") else float(match[1]) == 0.0:
                if re.search(r"=\s*$|[({,]\s*$", mask[begin:match.start()]):
                    continue
            to = changed_constant(match[1])
            add(match.start(), match.end(), "constant", f"(mutation::on({{n}}) ? {to} : {match[1]})", to)
        # A number with a name, in a function: const is enough of a constant for most.
        for match in re.compile(r"\b(?:static )?constexpr (?:double|int) (\w+) = ([-\w.+]+);").finditer(
                mask, begin, end):
            literal = match[2]
            if not re.fullmatch(r"0x[0-9a-fA-F.]+p[-+]?\d+|\d+\.\d+(e[-+]?\d+)?", literal):
                continue
            to = changed_constant(literal)
            add(match.start(), match.end(), "constant",
                f"const double {match[1]} = mutation::on({{n}}) ? {to} : {literal};",
                f"const double {match[1]} = {to};")
        for match in found(r"\bstd::(min|max)\("):
            b = closing(mask, match.end() - 1) + 1
            arguments = piece(match.end() - 1, b)
            to = "max" if match[1] == "min" else "min"
            add(match.start(), b, "extreme",
                f"(mutation::on({{n}}) ? std::{to}{arguments} : std::{match[1]}{arguments})",
                f"std::{to}{arguments}")
        for match in found(r"(?<![\w.:>&*])([A-Za-z_]\w*)\("):
            name = match[1]
            before = mask[begin:match.start()]
            if name in SYMMETRIC | {"if", "for", "while", "switch", "return", "sizeof"}:
                continue
            if re.search(r"[\w>&*]\s+$", before) and not re.search(r"\b(return|else)\s+$", before):
                continue
            a, b = match.end(), closing(mask, match.end() - 1)
            arguments, at = [], a
            while at <= b:
                to = right(mask, at, None, ",")
                arguments.append(piece(at, min(to, b)))
                at = to + 1
            if not 2 <= len(arguments) <= 4 or any("{" in x or "[" in x and "](" in x for x in arguments):
                continue
            k = next((k for k in range(len(arguments) - 1) if arguments[k] != arguments[k + 1]
                      and "<" not in arguments[k] + arguments[k + 1]), None)
            if k is None:
                continue
            other = arguments[:k] + [arguments[k + 1], arguments[k]] + arguments[k + 2:]
            calls = [f"{name}({', '.join(x)})" for x in (other, arguments)]
            add(match.start(), b + 1, "swapped", f"(mutation::on({{n}}) ? {calls[0]} : {calls[1]})",
                calls[0])
        for match in found(r"\breturn (true|false);"):
            now = "!" if match[1] == "true" else ""
            add(match.start(), match.end(), "returned", f"return {now}mutation::on({{n}});",
                "return " + ("false" if match[1] == "true" else "true") + ";")
    return [(a, b, kind, becomes.replace("{{", "\0").replace("}}", "\1") if kind == "accumulated"
             else becomes, what, shown) for a, b, kind, becomes, what, shown in out]


def numbered(becomes, n):
    return becomes.replace("{n}", str(n)).replace("\0", "{").replace("\1", "}")


def chosen(source, count, seed):
    """The places to change, file by file, with their numbers."""
    share = count / sum(ROOMS.values())
    out = []
    for room, number in ROOMS.items():
        files = sorted(p.relative_to(source).as_posix() for p in (source / room).rglob("*.[ch]pp"))
        ranked = []
        for file in files:
            if file in LEFT_OUT or (room == "lib/number" and pathlib.Path(file).name not in NUMBER):
                continue
            text = (source / file).read_text()
            seen = {}
            for a, b, kind, becomes, what, shown in places(file, text):
                key = f"{seed}:{file}:{kind}:{what}:{shown}"
                seen[key] = seen.get(key, 0) + 1
                digest = hashlib.sha256(f"{key}:{seen[key]}".encode()).digest()
                u = (int.from_bytes(digest[:6], "big") + 1) / 2.0**48
                line = text.count("\n", 0, a + len(text[a:b]) - len(text[a:b].lstrip())) + 1
                ranked.append((-u**(1.0 / WEIGHT[kind]), file, a, b, kind, becomes, what, shown, line))
        ranked.sort()
        taken = []
        for place in ranked:
            _, file, a, b = place[:4]
            if len(taken) >= round(share * number):
                break
            if any(f == file and a < d and c < b for _, f, c, d, *_ in taken):
                continue
            taken.append(place)
        if not taken:
            sys.exit(f"nothing to change in {room}")
        out += taken
    out.sort(key=lambda place: (place[1], place[2]))
    return [dict(number=n, file=p[1], begin=p[2], end=p[3], kind=p[4], becomes=p[5], text=p[6],
                 mutated=p[7], line=p[8]) for n, p in enumerate(out, 1)]


def write_file(source, tree, file, mutants):
    """A file of the copy, its lines where they were."""
    text = (source / file).read_text()
    for m in sorted(mutants, key=lambda m: -m["begin"]):
        old = text[m["begin"]:m["end"]]
        lead = old[:len(old) - len(old.lstrip())] if not m["becomes"].startswith("const ") else ""
        new = lead + numbered(m["becomes"], m["number"]) + "\n" * (old.count("\n") - lead.count("\n"))
        # What is left of the line stays on the last of them.
        text = text[:m["begin"]] + new + " " * (not new.endswith("\n")) + text[m["end"]:]
    if mutants:
        text = '#include "lib/mutation.hpp"\n#line 1\n' + text
    target = tree / file
    if not target.exists() or target.read_text() != text:
        target.parent.mkdir(parents=True, exist_ok=True)  # of a room all of whose files have mutants
        new = target.with_suffix(".new")  # another source may be read just now
        new.write_text(text)
        new.rename(target)


def copy(source, tree, changed):
    """Copies what has changed and is not written with mutants, so that a second build is a short one."""
    files = subprocess.run(["git", "-C", source, "ls-files", "-z"], check=True,
                           capture_output=True).stdout.decode().split("\0")
    for file in filter(None, files):
        old, new = source / file, tree / file
        if not old.is_file() or file in changed:
            continue
        if new.exists() and new.read_bytes() == old.read_bytes():
            continue
        new.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(old, new)
    header = tree / "lib/mutation.hpp"
    if not header.exists() or header.read_text() != HEADER:
        header.write_text(HEADER)


ERROR = re.compile(r"^(?P<file>[^\s:][^:]*):(?P<line>\d+):\d+: (?P<level>fatal error|error|note): ", re.M)


def blamed(output, tree, mutants):
    """The mutants on the lines of a compiler's errors, or else of the notes below them."""
    by_line = {}
    for m in mutants:
        height = m["text_lines"]
        for line in range(m["line"], m["line"] + height):
            by_line.setdefault((m["file"], line), set()).add(m["number"])
    blocks = []
    for match in ERROR.finditer(output):
        try:
            file = pathlib.Path(os.path.normpath(tree / match["file"])).relative_to(tree).as_posix()
        except ValueError:
            file = match["file"]
        at = by_line.get((file, int(match["line"])), set())
        if match["level"] != "note":
            blocks.append([at, set(), match[0]])
        elif blocks:
            blocks[-1][1] |= at
    out, unknown = set(), []
    for own, notes, where in blocks:
        if own or notes:
            out |= own or notes
        else:
            unknown.append(where)
    return out, unknown


def parse(command):
    words = shlex.split(command["command"])
    at = words.index("-o")
    words = words[:at] + words[at + 2:]
    words = [w for w in words if w != "-c"] + [
        "-fsyntax-only", "-w", "-ferror-limit=0", "-fno-caret-diagnostics",
        "-ftemplate-backtrace-limit=0"]
    return subprocess.run(words, cwd=command["directory"], capture_output=True, text=True)


def main():
    options = argparse.ArgumentParser()
    options.add_argument("source", type=pathlib.Path)
    options.add_argument("build", type=pathlib.Path)
    options.add_argument("--count", type=int, default=sum(ROOMS.values()))
    options.add_argument("--seed", default="24")
    options.add_argument("--jobs", type=int, default=2)
    options.add_argument("--list", action="store_true", help="print the places and stop")
    arguments = options.parse_args()
    source, out = arguments.source.resolve(), arguments.build.resolve()
    tree = out / "tree"
    mutants = chosen(source, arguments.count, arguments.seed)
    for m in mutants:
        m["text_lines"] = (source / m["file"]).read_text()[m["begin"]:m["end"]].strip().count("\n") + 1
    if arguments.list:
        for m in mutants:
            print(m["number"], f"{m['file']}:{m['line']}", m["kind"], "|", m["text"], "|", m["mutated"])
        return
    dropped_file = out / "dropped.json"
    key = hashlib.sha256(json.dumps([(m["file"], m["begin"], m["kind"], m["mutated"])
                                     for m in mutants]).encode()).hexdigest()
    dropped, done = set(), set()
    if dropped_file.exists():
        kept = json.loads(dropped_file.read_text())
        if kept["key"] == key:
            dropped, done = set(kept["dropped"]), set(kept["done"])
    by_file = {}
    for m in mutants:
        by_file.setdefault(m["file"], []).append(m)

    def write(files):
        for file in files:
            write_file(source, tree, file, [m for m in by_file[file] if m["number"] not in dropped])

    def save():
        dropped_file.write_text(json.dumps({"key": key, "dropped": sorted(dropped), "done": sorted(done)}))

    copy(source, tree, by_file)
    write(by_file)
    build = out / "build"
    subprocess.run(["cmake", "-S", tree, "-B", build, "-G", "Ninja", "-D", "CMAKE_BUILD_TYPE=Release",
                    "-D", "CMAKE_CXX_COMPILER=clang++", "-D", "CMAKE_CXX_FLAGS=-w",
                    "-D", "CMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG",
                    "-D", "STATIONARY_UNITY_BUILD=ON", "-D", "STATIONARY_BUILD_BENCHMARKS=OFF",
                    "-D", "STATIONARY_WASM=OFF", "-D", "STATIONARY_PYTHON=OFF", "-D", "CMAKE_EXPORT_COMPILE_COMMANDS=ON"],
                   check=True, stdout=subprocess.DEVNULL)
    # Others' headers, which hold no mutants.
    targets = subprocess.run(["ninja", "-C", build, "-t", "targets", "all"], check=True,
                             capture_output=True, text=True).stdout
    parsed = re.findall(r"^(\S+\.[gp]ch): ", targets, re.M)
    subprocess.run(["ninja", "-C", build, f"-j{arguments.jobs}", *parsed], check=True,
                   stdout=subprocess.DEVNULL)
    # Sources that are compiled as one are of the build tree.
    commands = [c for c in json.loads((build / "compile_commands.json").read_text())
                if (c["file"].endswith(".cpp") or "/Unity/" in c["file"]) and not re.search(
                    "kernel_avx|/(stress|rooms|support|program|fuzz|browser|bench|web)/",
                    c["file"].removeprefix(str(tree)).removeprefix(str(build)))]
    # A place that one source shows not to compile is gone before the next source is parsed.
    lock = threading.Lock()
    unknown = []

    def clear(command):
        nonlocal dropped
        while not unknown:
            with lock:
                now = [m for m in mutants if m["number"] not in dropped]
            result = parse(command)
            with lock:
                if result.returncode == 0:
                    done.add(command["file"])
                    return
                new, not_known = blamed(result.stderr, tree, now)
                if not new and any(m["number"] in dropped for m in now):
                    continue  # another source has shown it meanwhile
                if not new:
                    unknown.append((command["file"], not_known, result.stderr[:3000]))
                dropped |= new
                write({m["file"] for m in mutants if m["number"] in new})
                save()
                print(command["file"], len(new), "mutants do not compile", flush=True)

    with ThreadPoolExecutor(arguments.jobs) as pool:
        list(pool.map(clear, [c for c in commands if c["file"] not in done]))
    if unknown:
        sys.exit(f"errors without a mutant: {unknown[0]}")
    save()
    with open(out / "mutants.csv", "w", newline="") as file:
        table = csv.writer(file)
        table.writerow(["mutant", "file", "line", "kind", "text", "becomes"])
        for m in mutants:
            if m["number"] not in dropped:
                table.writerow([m["number"], m["file"], m["line"], m["kind"], m["text"], m["mutated"]])
    print(f"{len(mutants)} places, {len(mutants) - len(dropped)} mutants that compile")


if __name__ == "__main__":
    main()
