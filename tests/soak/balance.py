"""The balance once more, in 90 decimal digits and from one scalar: a motion is stationary where V(q) − ½ ν·I(q)ν is, in
the stretches and, about an axis that may turn, in the angle of the axis too. Derivatives are differences, so that nothing
here repeats a formula of the program but the potentials themselves."""

import re
from decimal import Decimal, DivisionByZero, InvalidOperation, Overflow, getcontext

from cases import Number, anisotropic

getcontext().prec = 90
ONE, TWO = Decimal(1), Decimal(2)
STEP = Decimal("1e-30")
PI = Decimal("3.14159265358979323846264338327950288419716939937510582097494459230781640628620899862803482534211706798")


class Unsupported(Exception):
    """A case that is not checked here."""


def cosine_sine(angle):
    """By their series, of an angle within ±2π."""
    term, cosine, sine, k = ONE, Decimal(0), Decimal(0), 0
    while abs(term) > Decimal("1e-100") or k < 8:
        if k % 2 == 0:
            cosine += term if k % 4 == 0 else -term
        else:
            sine += term if k % 4 == 1 else -term
        k += 1
        term = term * angle / k
    return cosine, sine


def carlson(x, y, z):
    """R_F by duplication."""
    while True:
        root_x, root_y, root_z = x.sqrt(), y.sqrt(), z.sqrt()
        shift = root_x * root_y + root_y * root_z + root_z * root_x
        x, y, z = (x + shift) / 4, (y + shift) / 4, (z + shift) / 4
        mean = (x + y + z) / 3
        dx, dy = 1 - x / mean, 1 - y / mean
        if max(abs(dx), abs(dy)) < Decimal("1e-13"):
            break
    dz = -dx - dy
    e2, e3 = dx * dy - dz * dz, dx * dy * dz
    return (1 - e2 / 10 + e3 / 14 + e2 * e2 / 24 - 3 * e2 * e3 / 44 - 5 * e2**3 / 208 + 3 * e3 * e3 / 104
            + e2 * e2 * e3 / 16) / mean.sqrt()


class Shape:
    """S, and what formulas make of it."""

    def __init__(self, alpha, xi, zeta, rho):
        self.alpha, self.xi, self.zeta, self.rho = alpha, xi, zeta, rho
        self.t, self.d = xi + zeta, xi * zeta - alpha * alpha
        if min(xi, zeta, rho, self.d) <= 0:
            raise InvalidOperation
        # Symmetric functions do not ask which is the greater.
        self.first, self.second = xi, zeta
        if alpha != 0:
            root = (self.t * self.t - 4 * self.d).sqrt()
            self.first, self.second = (self.t + root) / 2, (self.t - root) / 2


def formula(text, parameters):
    """A formula of the case as a function of a shape."""
    code = re.sub(r"(?<![\w.])(\d+\.?\d*(?:[eE][+-]?\d+)?)", r"D('\1')", text.replace("^", "**"))
    code = re.sub(r"\blambda\b", "lambda_", code)
    compiled = compile(code, "formula", "eval")
    fixed = {"D": Decimal, "log": Decimal.ln, "ln": Decimal.ln, "exp": Decimal.exp, "sqrt": Decimal.sqrt,
             "__builtins__": {}}
    named = {"lambda_" if name == "lambda" else name: value for name, value in parameters.items()}

    def value(s):
        i1 = s.t * s.t - 2 * s.d
        return eval(compiled, fixed, {"alpha": s.alpha, "xi": s.xi, "zeta": s.zeta, "rho": s.rho, "t": s.t, "d": s.d,
                                      "I1": i1, "I2": s.d**2 + s.rho**2 * i1, "I3": (s.d * s.rho)**2,
                                      "lambda_": s.first, "mu_": s.second, **named})
    return value


def term(slot, table):
    """One potential of [potential] as a function of a shape."""
    p = {name: Decimal(value) for name, value in table.items() if isinstance(value, Number)}
    if "expression" in table:
        if "domain" in table or "let" in table:
            raise Unsupported
        return formula(table["expression"], p)
    if slot in ("fibre", "second_fibre"):
        c, s = cosine_sine(p["degrees"] * PI / 180)
        return lambda q: p["k"] / 2 * (c * c * (q.xi**2 + q.alpha**2) + 2 * c * s * q.alpha * q.t
                                       + s * s * (q.zeta**2 + q.alpha**2) - 1)**2
    trace = lambda q: q.t * q.t - 2 * q.d
    log_d = lambda q: q.d.ln()
    model = table["model"]
    if model == "orthotropic-saint-venant-kirchhoff":
        def orthotropic(q):
            e11, e22 = (q.xi**2 + q.alpha**2 - 1) / 2, (q.zeta**2 + q.alpha**2 - 1) / 2
            e12 = q.alpha * q.t / 2
            return (p["c11"] * e11**2 + p["c22"] * e22**2) / 2 + p["c12"] * e11 * e22 + 2 * p["c66"] * e12**2
        return orthotropic
    if model == "reciprocal-determinant":
        return lambda q: p["c"] / q.d + p["k"] / 2 * trace(q)
    if model == "reciprocal-quadratic":
        return lambda q: p["a"] / q.rho + p["b"] / 2 * q.rho**2
    if model == "harmonic":
        return lambda q: p["k"] / 2 * (q.rho - p["rest"])**2
    mu, lame = p["mu"], p["lambda"]
    if model == "saint-venant-kirchhoff":
        def green(q):
            a, b = (q.first**2 - 1) / 2, (q.second**2 - 1) / 2
            return mu * (a * a + b * b) + lame / 2 * (a + b)**2
        return green
    if model == "biot":
        return lambda q: mu * (trace(q) - 2 * q.t + 2) + lame / 2 * (q.t - 2)**2
    if model == "biot-log":
        return lambda q: mu * (trace(q) - 2 * q.t + 2) + lame / 2 * log_d(q)**2
    if model == "neo-hookean":
        return lambda q: mu / 2 * (trace(q) - 2 - 2 * log_d(q)) + lame / 2 * log_d(q)**2
    if model == "hencky":
        return lambda q: mu * (q.first.ln()**2 + q.second.ln()**2) + lame / 2 * log_d(q)**2
    if model == "neo-hookean-3d":
        def whole(q):
            volume = (q.d * q.rho).ln()
            return mu / 2 * (trace(q) + q.rho**2 - 3 - 2 * volume) + lame / 2 * volume**2
        return whole
    raise Unsupported


class Balance:
    """What a case asks of S about an axis. `spin` are the three components of ν; about an axis that may turn its length
    is kept, and the angle is an unknown."""

    def __init__(self, tree):
        body = tree["body"]
        self.J = [Decimal(each) for each in body["J"]]
        self.volume = Decimal(body["volume"]) if "volume" in body else None
        self.branch = tree["motion"]["branch"]
        self.motion = {k: Decimal(v) for k, v in tree["motion"].items() if isinstance(v, Number)}
        self.terms = [term(slot, table) for slot, table in tree.get("potential", {}).items()]
        gravity = tree.get("gravity", {})
        self.g = Decimal(gravity["g"]) if "g" in gravity else None
        if "pi_G_rho" in gravity:
            self.g = 4 * (self.J[0] * self.J[1] * self.J[2]).sqrt() * Decimal(gravity["pi_G_rho"])
        self.with_alpha = anisotropic(tree) and self.branch in ("iii", "oblique")

    def potential(self, s):
        out = sum((each(s) for each in self.terms), Decimal(0))
        if self.g is not None:
            if s.alpha != 0:
                raise Unsupported
            out -= self.g * carlson(self.J[0] * s.xi**2, self.J[1] * s.zeta**2, self.J[2] * s.rho**2)
        return out

    def locked_inertia(self, s):
        """I11, I22, I33, I12."""
        a, b, c = self.J
        k11, k22 = a * s.xi**2 + b * s.alpha**2, a * s.alpha**2 + b * s.zeta**2
        k33, k12 = c * s.rho**2, s.alpha * (a * s.xi + b * s.zeta)
        return k22 + k33, k11 + k33, k11 + k22, -k12

    def rotational(self, s, spin):
        i11, i22, i33, i12 = self.locked_inertia(s)
        return (i11 * spin[0]**2 + i22 * spin[1]**2 + i33 * spin[2]**2 + 2 * i12 * spin[0] * spin[1]) / 2

    def reduced(self, s, spin):
        """What is stationary."""
        if self.branch != "two-polar":
            return self.potential(s) - self.rotational(s, spin)
        j = self.J[0]
        if "omega" in self.motion:
            omega, rate = self.motion["omega"], self.motion["theta_dot"]
            return self.potential(s) - j / 2 * ((omega**2 + rate**2) * (s.xi**2 + s.zeta**2)
                                                + 4 * omega * rate * s.xi * s.zeta)
        one, other = self.motion["s3"] + self.motion["p_theta"], self.motion["s3"] - self.motion["p_theta"]
        if s.xi == s.zeta:
            raise Unsupported
        return self.potential(s) + (one**2 / s.t**2 + other**2 / (s.xi - s.zeta)**2) / (4 * j)

    def unknowns(self):
        names = ["xi", "zeta"] if self.volume is not None else ["xi", "zeta", "rho"]
        if self.with_alpha:
            names.append("alpha")
        if self.branch in ("tilted", "oblique"):
            names.append("angle")
        return names

    def at(self, start, spin, step):
        """The reduced energy, each stretch off by a part of itself."""
        q = dict(start)
        for name, value in step.items():
            if name == "alpha":
                q["alpha"] += value * (start["xi"] * start["zeta"]).sqrt()
            elif name != "angle":
                q[name] *= 1 + value
        if self.volume is not None:
            q["rho"] = self.volume / (q["xi"] * q["zeta"] - q["alpha"]**2)
        if "angle" in step and step["angle"] != 0:
            c, s = cosine_sine(step["angle"])
            other = 2 if self.branch == "tilted" else 1
            first = 0 if other == 1 or spin[1] == 0 else 1
            turned = list(spin)
            turned[first], turned[other] = c * spin[first] - s * spin[other], s * spin[first] + c * spin[other]
            spin = turned
        return self.reduced(Shape(**q), spin), q, spin

    def slopes(self, start, spin, at):
        out = []
        for name in self.unknowns():
            value = []
            for sign in (1, -1):
                step = dict(at)
                step[name] = step.get(name, Decimal(0)) + sign * STEP
                value.append(self.at(start, spin, step)[0])
            out.append((value[0] - value[1]) / (2 * STEP))
        return out

    def corrected(self, start, spin, steps=12, renewed=False):
        """Newton's method from `start` (a dict of decimals): the solution it comes to, or None."""
        names = self.unknowns()
        at = {name: Decimal(0) for name in names}
        try:
            for k in range(steps):
                slope = self.slopes(start, spin, at)
                if k == 0 or renewed:
                    columns = [[(b - a) / STEP for a, b in
                                zip(slope, self.slopes(start, spin, {**at, name: at[name] + STEP}))]
                               for name in names]
                move = solved([list(row) for row in zip(*columns)], [-each for each in slope])
                largest = max(abs(each) for each in move)
                if renewed and largest > Decimal("0.3"):
                    move = [each * Decimal("0.3") / largest for each in move]
                for name, each in zip(names, move):
                    at[name] += each
                if largest < Decimal("1e-36"):
                    _, q, turned = self.at(start, spin, at)
                    return q, turned
        except (InvalidOperation, DivisionByZero, Overflow):
            pass
        return None


def solved(matrix, right):
    """Gauss with pivots."""
    n = len(right)
    rows = [row + [value] for row, value in zip(matrix, right)]
    for k in range(n):
        pivot = max(range(k, n), key=lambda r: abs(rows[r][k]))
        rows[k], rows[pivot] = rows[pivot], rows[k]
        for r in range(k + 1, n):
            factor = rows[r][k] / rows[k][k]
            rows[r] = [a - factor * b for a, b in zip(rows[r], rows[k])]
    out = [Decimal(0)] * n
    for k in reversed(range(n)):
        out[k] = (rows[k][n] - sum(rows[k][j] * out[j] for j in range(k + 1, n))) / rows[k][k]
    return out
