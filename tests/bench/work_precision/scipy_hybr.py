"""A peer: SciPy's optimize.root(method="hybr") on the balance in (alpha, xi, zeta, rho), as one
would write it in Python. Without SciPy it ends with exit code 1; else it prints its versions and
then answers each line of JSON

    {"model", "J", "plane", "thickness", "axis", "nu": [...], "start": [...], "warm", "tolerance"}

with one: {"seconds" (of processor time), "q": [[alpha, xi, zeta, rho] or null, ...]}. warm: each solve starts from the
parabola through the last three, else from "start".
"""

import json
import math
import sys
import time

try:
    import numpy
    import scipy
    from scipy.optimize import root
except ImportError:
    sys.exit(1)


# (W_t, W_l) of W(t, l = ln d), by model; x = 1 - 4 d/t^2.
def reciprocal_determinant(c, k, t, d):
    return k * t, -c / d - k * d


def neo_hookean(mu, lam, t, d):
    return mu * t, -mu * d - mu + lam * math.log(d)


def hencky(mu, lam, t, d):
    y = 4.0 * d / (t * t)
    root_x = math.sqrt(max(1.0 - y, 0.0))
    slope = math.atanh(root_x) / root_x if root_x > 0.0 else 1.0  # d(atanh^2 sqrt x)/dx = slope/y
    w_x = 2.0 * mu * slope / y
    return w_x * 2.0 * y / t, (mu + lam) * math.log(d) - w_x * y


MODELS = {
    "reciprocal-determinant": reciprocal_determinant,
    "neo-hookean": neo_hookean,
    "hencky": hencky,
}


def balance(case, nu):
    """F(q) = grad V(q) - C(nu) q for a spin nu about one axis."""
    J1, J2, J3 = case["J"]
    a, b = case["thickness"]
    first, second = case["plane"]
    model = MODELS[case["model"]]
    n = nu * nu
    c_alpha = (J1 * n, J2 * n, (J1 + J2) * n)[case["axis"]]
    c_xi = (0.0, J1 * n, J1 * n)[case["axis"]]
    c_zeta = (J2 * n, 0.0, J2 * n)[case["axis"]]
    c_rho = (J3 * n, J3 * n, 0.0)[case["axis"]]

    def residual(q):
        alpha, xi, zeta, rho = q.tolist()
        d = xi * zeta - alpha * alpha
        w_t, w_l = model(first, second, xi + zeta, d)
        return [
            -2.0 * alpha * w_l / d - c_alpha * alpha,
            w_t + w_l * zeta / d - c_xi * xi,
            w_t + w_l * xi / d - c_zeta * zeta,
            b * rho - a / (rho * rho) - c_rho * rho,
        ]

    return residual


def solve(case):
    start = numpy.array(case["start"])
    options = {"xtol": case["tolerance"]}
    past = [start]
    out = []
    for nu in case["nu"]:
        guess = start
        if case["warm"]:
            guess = past[-1]
            if len(past) >= 4:
                guess = 3.0 * (past[-1] - past[-2]) + past[-3]
        try:
            found = root(balance(case, nu), guess, method="hybr", options=options)
            # 3, 4, 5: as far as rounding lets it.
            good = found.status in (1, 3, 4, 5) and bool(numpy.all(numpy.isfinite(found.x)))
        except (ValueError, ZeroDivisionError):  # left the domain
            good = False
        out.append(found.x.tolist() if good else None)
        if good:
            past = past[-3:] + [found.x]
    return out


print(json.dumps({"SciPy": scipy.__version__, "NumPy": numpy.__version__,
                  "Python": sys.version.split()[0]}), flush=True)
for line in sys.stdin:
    request = json.loads(line)
    begin = time.process_time()
    states = solve(request)
    print(json.dumps({"seconds": time.process_time() - begin, "q": states}), flush=True)
