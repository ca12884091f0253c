"""The classical figures of rotating fluids, from the program's own answers:

    python3 docs/pictures/classical.py INTO

from the top of the sources, PYTHONPATH=build/release/python; into a directory that has maclaurin.csv and jacobi.csv:

    riemann.csv, .svg, .png             Riemann's S-type ellipsoids on their rectangle (b/a, c/a)
    spin_eccentricity.svg, .png         Omega^2 of Maclaurin's and Jacobi's ellipsoids against the eccentricity

Fluid, J = (1, 1, 1), volume 1, pi G rho = 1, so that lambda : mu : rho are the semi-axes a : b : c, c along the axis. Of each
S-type ellipsoid the closed form

    omega^2 + theta'^2 = A = -2 g F_T,   2 omega theta' = B = -2 g d F_D + 2 g (rho^2/d) F_z   (docs/gravity.md)

gives the rates; it exists where |B| <= A. `solve` then corrects it, bounds its error and claims its class; a border lies between two
figures of one b/a whose classes are claimed and differ, c/a apart by less than 10^-9 of it. On these borders s3 = omega I_1 or
s3 = omega I_2, I_a = m_b + m_c the locked inertia about axis a: the event `tilt` of the families (tests/python/classical_test.py)."""

import csv
import math
import sys

import numpy as np

import stationary

G = 4.0


def carlson_d(x, y, z):
    """R_D, by duplication."""
    sum_, power = 0.0, 1.0
    while True:
        mean = (x + y + 3.0 * z) / 5.0
        if max(abs(mean - x), abs(mean - y), abs(mean - z)) < 1e-3 * mean:
            break
        rx, ry, rz = math.sqrt(x), math.sqrt(y), math.sqrt(z)
        shift = rx * ry + rz * (rx + ry)
        sum_ += power / (rz * (z + shift))
        power /= 4.0
        x, y, z = (x + shift) / 4.0, (y + shift) / 4.0, (z + shift) / 4.0
    X, Y = (mean - x) / mean, (mean - y) / mean
    Z = -(X + Y) / 3.0
    e2 = X * Y - 6.0 * Z * Z
    e3 = (3.0 * X * Y - 8.0 * Z * Z) * Z
    e4 = 3.0 * (X * Y - Z * Z) * Z * Z
    e5 = X * Y * Z**3
    series = 1 - 3 * e2 / 14 + e3 / 6 + 9 * e2 * e2 / 88 - 3 * e4 / 22 - 9 * e2 * e3 / 52 + 3 * e5 / 26
    return 3.0 * sum_ + power * series / (mean * math.sqrt(mean))


def stretches(b, c):
    a = (b * c) ** (-1.0 / 3.0)
    return a, a * b, a * c


def rates(b, c):
    """A and B."""
    x, y, z = (each * each for each in stretches(b, c))
    of_x, of_y, of_z = (-carlson_d(*rest, own) / 6.0 for *rest, own in ((y, z, x), (z, x, y), (x, y, z)))
    d = math.sqrt(x * y)
    if b < 1.0:
        of_D = (of_x - of_y) / (y - x)
        of_T = of_x - y * of_D
        A = -2.0 * G * of_T
        B = -2.0 * G * d * of_D + 2.0 * G * (z / d) * of_z
        return A, B
    raise ValueError("b < a")


def figure(b, c):
    A, B = rates(b, c)
    total, difference = math.sqrt(A + B), math.sqrt(A - B)
    lambda_, mu, rho = stretches(b, c)
    return {
        "body": {"J": [1.0, 1.0, 1.0], "volume": 1.0},
        "gravity": {"g": G},
        "motion": {"branch": "two-polar", "omega": 0.5 * (total + difference), "theta_dot": 0.5 * (total - difference)},
        "solve": {"start": [0.0, lambda_, mu, rho]},
    }


def solved(b, c):
    out = stationary.solve(figure(b, c))
    lambda_, mu, rho = (float(out.table[name][0]) for name in ("lambda", "mu", "rho"))
    if abs(mu / lambda_ - b) > 1e-6 or abs(rho / lambda_ - c) > 1e-6:
        return "elsewhere"
    return out.table["class"][0]



def exists(b, c):
    A, B = rates(b, c)
    return abs(B) <= A


def halved(low, high, is_low, within):
    """Where is_low ends between two c/a."""
    while high - low > within * high:
        middle = 0.5 * (low + high)
        low, high = (middle, high) if is_low(middle) else (low, middle)
    return 0.5 * (low + high)


def column(b):
    """Of one b/a: (c/a, what is below, what is above), ascending."""
    out = []
    grid = np.geomspace(0.01, 1.6, 400)
    there = [exists(b, c) for c in grid]
    begin = there.index(True)
    end = len(there) - 1 - there[::-1].index(True)
    assert all(there[begin : end + 1]), "one range of c/a"
    lowest = halved(grid[begin - 1], grid[begin], lambda c: not exists(b, c), 1e-14)
    highest = halved(grid[end], grid[end + 1], lambda c: exists(b, c), 1e-14)
    places = lowest + (highest - lowest) * (0.5 - 0.5 * np.cos(np.pi * (np.arange(40) + 0.5) / 40))
    classes = [solved(b, c) for c in places]
    out.append((lowest, "none", classes[0]))
    for k, (below, above) in enumerate(zip(classes, classes[1:])):
        if below != above:
            at = halved(places[k], places[k + 1], lambda c: solved(b, c) == below, 1e-9)
            out.append((at, below, above))
    out.append((highest, classes[-1], "none"))
    return out


def jacobi(b):
    return halved(0.02, 1.0, lambda c: rates(b, c)[1] > 0.0, 1e-14)


def plotting():
    import matplotlib

    matplotlib.use("Agg")
    matplotlib.rcParams["svg.hashsalt"] = "classical"
    from matplotlib import pyplot

    return pyplot


def save(figure, name):
    figure.tight_layout()
    figure.savefig(name + ".svg", metadata={"Date": None})
    figure.savefig(name + ".png", dpi=150)


def draw(columns, name):
    """The rectangle."""
    pyplot = plotting()
    shades = {"stable": ("#cfe3f2", ""), "unstable": ("#f4cfc6", "//"), "elliptic": ("#e3ecc9", ".."),
              "oscillatory": ("#e5d3ea", "xx"), "marginal": ("#dddddd", "")}
    figure, axes = pyplot.subplots(figsize=(6.4, 6.0))
    ratios = sorted(columns)
    told = set()
    for left, right in zip(ratios, ratios[1:]):
        for (at, _, above), (next_at, _, _) in zip(columns[left], columns[left][1:]):
            same = [(a[0], b[0]) for a, b in zip(columns[right], columns[right][1:]) if a[2] == above]
            for a, b in same[:1]:
                colour, hatch = shades[above]
                axes.fill([left, right, right, left], [at, a, b, next_at], color=colour, hatch=hatch, edgecolor="#999999",
                          linewidth=0.0, label=None if above in told else above)
                told.add(above)
    borders = {}
    for b in ratios:
        for at, below, above in columns[b]:
            borders.setdefault((below, above), []).append((b, at))
    for (below, above), points in sorted(borders.items()):
        axes.plot(*zip(*points), color="black", linewidth=1.0 if "none" in (below, above) else 1.8)
    axes.plot(ratios, [jacobi(b) for b in ratios], color="#1f5fa8", linestyle="--", linewidth=1.4, label="Jacobi, Dedekind")
    axes.set_xlim(0.0, 1.0)
    axes.set_ylim(0.0, 1.05)
    axes.set_xlabel("b/a")
    axes.set_ylabel("c/a")
    axes.set_title("Riemann's S-type ellipsoids as Kirchhoff-Love bodies")
    axes.legend(loc="upper left", framealpha=1.0)
    save(figure, name)


def spin_and_eccentricity(table):
    """e of the section through the axis and the longest semi-axis, nu^2, and the event, of each row."""
    out = []
    with open(table, encoding="utf-8") as file:
        for row in csv.DictReader(file):
            longest = max(float(row["xi"]), float(row["zeta"]))
            flatness = float(row["rho"]) / longest
            if flatness <= 1.0:
                out.append((math.sqrt(1.0 - flatness**2), float(row["nu3"]) ** 2, row["event"]))
    return out


def draw_spin(into):
    pyplot = plotting()
    figure, axes = pyplot.subplots(figsize=(6.4, 4.6))
    marks = {"ellipse": "o", "fold-nu": "^", "krein-pass": "d", "hamiltonian-hopf": "s"}
    for name, style in (("maclaurin", "-"), ("jacobi", "--")):
        rows = spin_and_eccentricity(f"{into}/{name}.csv")
        axes.plot([e for e, _, _ in rows], [spin for _, spin, _ in rows], style, color="#1f5fa8", label=name.capitalize())
        for e, spin, event in rows:
            if event in marks and name == "maclaurin":
                axes.plot([e], [spin], marks[event], color="black", label=f"{event}: e = {e:.7f}, {spin:.7f}")
    axes.set_xlabel("e")
    axes.set_ylabel("Ω²/(πGρ)")
    axes.set_xlim(0.0, 1.0)
    axes.set_ylim(0.0, 0.5)
    axes.legend(loc="upper left", fontsize=8)
    save(figure, f"{into}/spin_eccentricity")


def main(into):
    columns = {round(b, 2): column(b) for b in np.arange(0.04, 0.99, 0.02)}
    with open(f"{into}/riemann.csv", "w", encoding="utf-8") as out:
        out.write("b_over_a,c_over_a,below,above\n")
        for b, all_ in columns.items():
            for at, below, above in all_:
                out.write(f"{b:.2f},{at:.9g},{below},{above}\n")
    draw(columns, f"{into}/riemann")
    draw_spin(into)


if __name__ == "__main__":
    main(sys.argv[1])
