"""Random cases. A case is a tree of tables; its numbers are kept as the texts that stand in the file, so that a check
can take them for the decimal numbers that they are."""

import math

PLANES = {
    "reciprocal-determinant": ("c", "k"),
    "saint-venant-kirchhoff": ("mu", "lambda"),
    "biot": ("mu", "lambda"),
    "biot-log": ("mu", "lambda"),
    "neo-hookean": ("mu", "lambda"),
    "hencky": ("mu", "lambda"),
}
ORTHOTROPIC = ("c11", "c22", "c12", "c66")
THICKNESSES = {"reciprocal-quadratic": ("a", "b"), "harmonic": ("k", "rest")}

PLANE_FORMULAS = (
    ("mu/2*(I1 - 2 - 2*log(d)) + k/2*log(d)^2", ("mu", "k")),
    ("c/d + k/2*(t^2 - 2*d)", ("c", "k")),
    ("m1/1.3*(lambda^1.3 + mu_^1.3 - 2) - m1*log(d) + k/2*log(d)^2", ("m1", "k")),
    ("mu*((xi - 1)^2 + (zeta - 1)^2 + 2*alpha^2) + k/2*log(d)^2", ("mu", "k")),
    ("k*(d - 1)^2 + mu/2*(I1 - 2*log(d))", ("k", "mu")),
)
THICKNESS_FORMULAS = (("a/rho + b/2*rho^2", ("a", "b")), ("k*((rho - 0.8)*(rho - 1.4))^2", ("k",)))
COUPLED_FORMULAS = (
    ("c1*(I1 + rho^2 - 3) + 0.1*(I2 - 3) - 2*(c1 + 0.2)*log(d*rho) + k/2*log(d*rho)^2", ("c1", "k")),
    ("mu/2*(I1 + rho^2 - 3 - 2*log(d*rho)) + k/2*(d*rho - 1)^2", ("mu", "k")),
)

EVENTS = ("fold-nu", "fold-momentum", "tilt", "ellipse", "inertia-exchange", "hamiltonian-hopf", "krein-pass",
          "real-collision", "shear", "oblique")
COLUMNS = ("branch", "sheet", "point", "nu1", "nu3", "alpha", "xi", "zeta", "rho", "lambda", "mu", "pi3", "energy",
           "error_bound", "class", "growth", "negative", "re1", "im1")


def text(value):
    """A number as the case has it: four digits, as people write them, or all."""
    return repr(float(value))


def short(rng, low, high):
    return text(float(f"{rng.uniform(low, high):.4g}"))


def log_between(rng, low, high):
    value = math.exp(rng.uniform(math.log(low), math.log(high)))
    return text(float(f"{value:.3g}") if rng.random() < 0.7 else value)


class RawText(str):
    """Stands in the file as it is."""


def written(value):
    if isinstance(value, RawText):
        return str(value)
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{key(k)} = {written(v)}" for k, v in value.items()) + " }"
    if isinstance(value, list):
        return "[" + ", ".join(written(each) for each in value) + "]"
    if isinstance(value, Number):
        return str(value)
    return '"' + str(value) + '"'


def key(name):
    return f'"{name}"' if "." in name or "/" in name else name


class Number(str):
    """The text of a number."""


def toml(tree):
    lines = []
    if "title" in tree:
        lines.append(f"title = {written(tree['title'])}")
    for name, table in tree.items():
        if name == "title":
            continue
        lines += ["", f"[{name}]"] + [f"{key(k)} = {written(v)}" for k, v in table.items()]
    return "\n".join(lines) + "\n"


def get(tree, path):
    for part in path.split("."):
        tree = tree[int(part)] if isinstance(tree, list) else tree[part]
    return tree


def put(tree, path, value):
    *above, last = path.split(".")
    for part in above:
        tree = tree[int(part)] if isinstance(tree, list) else tree.setdefault(part, {})
    if isinstance(tree, list):
        tree[int(last)] = value
    else:
        tree[last] = value


def numbers_of(tree):
    """Paths of the numbers that may be followed and mapped, ν not among them."""
    out = [f"body.J.{k}" for k in range(3)]
    if "volume" in tree["body"]:
        out.append("body.volume")
    if "g" in tree.get("gravity", {}):
        out.append("gravity.g")
    for slot, table in tree.get("potential", {}).items():
        out += [f"potential.{slot}.{name}" for name, value in table.items() if isinstance(value, Number)]
    return out


def anisotropic(tree):
    potential = tree.get("potential", {})
    return ("fibre" in potential or "second_fibre" in potential
            or potential.get("plane", {}).get("model", "").startswith("orthotropic"))


def random_table(rng, kind):
    if kind == "coupled":
        if rng.random() < 0.6:
            return {"model": "neo-hookean-3d", "mu": Number(short(rng, 0.5, 2)), "lambda": Number(short(rng, 0.2, 3))}
        formula, names = rng.choice(COUPLED_FORMULAS)
    elif kind == "plane":
        if rng.random() < 0.8:
            model = rng.choice(sorted(PLANES))
            return {"model": model, **{n: Number(short(rng, 0.5, 2.5)) for n in PLANES[model]}}
        formula, names = rng.choice(PLANE_FORMULAS)
    else:
        if rng.random() < 0.85:
            model = rng.choice(sorted(THICKNESSES))
            return {"model": model, **{n: Number(short(rng, 0.6, 3)) for n in THICKNESSES[model]}}
        formula, names = rng.choice(THICKNESS_FORMULAS)
    return {"expression": formula, **{n: Number(short(rng, 0.5, 2)) for n in names}}


def random_potential(rng, isotropic):
    out = {}
    if rng.random() < 0.25:
        out["coupled"] = random_table(rng, "coupled")
        return out
    out["plane"] = random_table(rng, "plane")
    out["thickness"] = random_table(rng, "thickness")
    if isotropic or rng.random() > 0.16:
        return out
    if rng.random() < 0.35:
        out["plane"] = {"model": "orthotropic-saint-venant-kirchhoff", "c11": Number(short(rng, 2, 4)),
                        "c22": Number(short(rng, 2, 4)), "c12": Number(short(rng, 0.2, 1)),
                        "c66": Number(short(rng, 0.5, 2))}
    else:
        degrees = rng.choice(["0.0", "90.0", "30.0", short(rng, 0, 90)])
        out["fibre"] = {"k": Number(short(rng, 0.1, 1)), "degrees": Number(degrees)}
    return out


def random_body(rng, round_one):
    moments = [log_between(rng, 0.3, 3) for _ in range(3)]
    if rng.random() < 0.05:
        moments[rng.randrange(3)] = log_between(rng, 1e-6, 1e6)
    if round_one:
        moments[1] = moments[0]
    return {"J": [Number(each) for each in moments]}


def random_case(rng):
    """Any motion, any potential; the ranges are short, so that a command takes a second."""
    branch = rng.choices(("i", "ii", "iii", "tilted", "oblique", "two-polar"), (28, 18, 32, 8, 5, 9))[0]
    held = rng.random() < 0.1 and branch != "oblique"
    heavy = rng.random() < 0.1 and branch != "oblique"
    isotropic = held or heavy or branch in ("tilted", "two-polar")
    tree = {"title": "Soak"}
    tree["body"] = random_body(rng, branch == "two-polar" or rng.random() < 0.15)
    if held:
        tree["body"]["volume"] = Number(short(rng, 0.7, 1.4))
    if heavy:
        name = "g" if rng.random() < 0.7 else "pi_G_rho"
        tree["gravity"] = {name: Number(short(rng, 0.1, 2.5))}
    tree["potential"] = random_potential(rng, isotropic)
    if branch == "oblique" and not anisotropic(tree):
        tree["potential"] = {"plane": random_table(rng, "plane"), "thickness": random_table(rng, "thickness"),
                             "fibre": {"k": Number(short(rng, 0.1, 1)), "degrees": Number(short(rng, 5, 85))}}
    motion = {"branch": branch}
    if branch == "two-polar":
        names = ("omega", "theta_dot") if rng.random() < 0.6 else ("s3", "p_theta")
        motion.update({n: Number(short(rng, -1.2, 1.2)) for n in names})
    else:
        motion["nu"] = Number(short(rng, 0.02, 1.1))
        if branch == "tilted" and rng.random() < 0.7:
            motion["plane"] = rng.choice(("13", "23"))
        if branch == "oblique" and rng.random() < 0.7:
            motion["axis"] = rng.choice(("1", "2"))
    tree["motion"] = motion
    if rng.random() < 0.2:
        tree["solve"] = {"method": rng.choice(("auto", "ceres", "newton", "nlopt"))}
    if rng.random() < 0.12:
        tree.setdefault("solve", {})["all"] = True
    if rng.random() < 0.1:
        tree.setdefault("solve", {})["start"] = [Number("0.0")] + [Number(short(rng, 0.6, 1.6)) for _ in range(3)]
    if rng.random() < 0.05:
        tree.setdefault("solve", {})["box"] = [Number("0.05"), Number("20.0")]
    if rng.random() < 0.25:
        tree["output"] = random_output(rng)
    return tree


def random_output(rng):
    out = {}
    if rng.random() < 0.3:
        out["spectrum"] = False
    if rng.random() < 0.5:
        out["certificate"] = True
    if rng.random() < 0.3:
        out["columns"] = rng.sample(COLUMNS, rng.randint(3, len(COLUMNS)))
    return out


def around(rng, value, wide):
    """A short range about a number, from, to."""
    value = float(value)
    low, high = value / (1 + wide * rng.random()), value * (1 + wide * rng.random())
    return Number(text(float(f"{min(low, high):.4g}"))), Number(text(float(f"{max(low, high) + 1e-3:.4g}")))


def add_continuation(rng, tree, spin_only=False):
    motion = tree["motion"]
    branch = motion["branch"]
    names = [n for n in numbers_of(tree) if not n.startswith("potential.fibre")]
    if branch == "two-polar":
        parameter = "motion." + rng.choice([n for n in motion if n != "branch"])
        low = float(motion[parameter[7:]])
        bounds = Number(text(low - 0.3)), Number(text(low + 0.4))
    elif spin_only or rng.random() < 0.65:
        parameter = "nu"
        bounds = Number("0.0"), Number(short(rng, 0.3, 1.6))
        if branch in ("tilted", "oblique"):
            bounds = around(rng, motion["nu"], 0.5)
    else:
        parameter = rng.choice(names)
        bounds = around(rng, get(tree, parameter), 1.0)
        if rng.random() < 0.15:
            parameter = "body.J.1/body.J.0"
            ratio = float(tree["body"]["J"][1]) / float(tree["body"]["J"][0])
            bounds = around(rng, ratio, 0.6)
    table = {} if parameter == "nu" and rng.random() < 0.5 else {"parameter": parameter}
    table["from"], table["to"] = bounds
    table["tolerance"] = Number(rng.choice(("1e-4", "1e-5", "1e-6", "1e-8")))
    if rng.random() < 0.3:
        table["max_points"] = Number(str(rng.choice((2, 20, 100, 1000))))
    if rng.random() < 0.15:
        table["events"] = rng.sample(EVENTS, rng.randint(1, 4))
    tree["continuation"] = table
    return parameter


def add_map(rng, tree, body_only=False, most=24):
    names = [n for n in numbers_of(tree)]
    if not body_only and "nu" in tree["motion"]:
        names = ["nu"] * 4 + names
    axes = ("x", "y") if body_only or rng.random() < 0.75 else ("x",)
    chosen = []
    tree["map"] = {}
    for axis in axes:
        parameter = rng.choice([n for n in names if n not in chosen])
        chosen.append(parameter)
        value = tree["motion"]["nu"] if parameter == "nu" else get(tree, parameter)
        low, high = around(rng, max(float(value), 1e-3), 0.8)
        tree["map"][axis] = {"parameter": parameter, "from": low, "to": high,
                             "count": Number(str(rng.randint(2, most)))}
        if rng.random() < 0.2:
            tree["map"][axis]["scale"] = "log"


def add_curve(rng, tree):
    second = rng.choice(numbers_of(tree)[:3])
    low, high = around(rng, get(tree, second), 0.5)
    tree["curve"] = {"event": rng.choice(EVENTS), "parameters": ["nu", second],
                     "from": [Number("0.05"), low], "to": [Number(short(rng, 0.5, 1.3)), high],
                     "tolerance": Number(rng.choice(("1e-3", "1e-4", "1e-6")))}
