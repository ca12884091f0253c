#!/usr/bin/env python3
"""The sketches of docs/events.md: python3 docs/pictures/draw.py

Each is an event, an end or a class, drawn by hand and not to scale: curves of a sheet against nu, or
eigenvalues in the complex plane. Solid is stable, dashed unstable; lines differ without colour too."""
import pathlib

WIDTH, HEIGHT = 260, 160
FRONT = 'stroke="#1b1b1b" fill="none"'
BLUE = 'stroke="#1f5fa8" stroke-width="2.6" fill="none"'
RED = 'stroke="#b3401a" stroke-width="2.2" fill="none" stroke-dasharray="7 4"'
GREY = 'stroke="#767676" stroke-width="1.6" fill="none"'


def path(data, style):
    return f'<path d="{data}" {style}/>'


def text(x, y, what, anchor="middle"):
    return f'<text x="{x}" y="{y}" text-anchor="{anchor}">{what}</text>'


def dot(x, y):
    return f'<circle cx="{x}" cy="{y}" r="5" fill="#fff" stroke="#1b1b1b" stroke-width="2"/>'


def arrow(x1, y1, x2, y2, style=FRONT):
    return f'<path d="M{x1} {y1} L{x2} {y2}" {style} marker-end="url(#tip)"/>'


def axes(right="ν", up="stretch"):
    return arrow(30, 140, 245, 140) + arrow(30, 140, 30, 14) + text(243, 156, right) + text(36, 14, up, "start")


def plane():
    """The complex plane of the eigenvalues s, the imaginary axis upright."""
    return arrow(30, 80, 240, 80) + arrow(130, 150, 130, 12) + text(236, 96, "re s") + text(138, 18, "im s", "start")


def zero(x, y, krein=""):
    out = f'<circle cx="{x}" cy="{y}" r="4.5" fill="#1f5fa8"/>'
    return out + (text(x - 10, y + 5, krein, "end") if krein else "")


def growing(x, y):
    return f'<path d="M{x-5} {y-5} L{x+5} {y+5} M{x-5} {y+5} L{x+5} {y-5}" stroke="#b3401a" stroke-width="2.6"/>'


def shape(cx, cy, rx, ry, turn=0, style=GREY):
    return f'<ellipse cx="{cx}" cy="{cy}" rx="{rx}" ry="{ry}" transform="rotate({turn} {cx} {cy})" {style}/>'


def two_lines(first, second):
    """Locked inertias that cross."""
    return (axes(up="locked inertia") + path("M40 45 L230 110", GREY) + path("M40 110 L230 50", GREY)
            + text(52, 40, first) + text(52, 126, second) + dot(139, 79))


def spins(base, turned):
    """A sheet that another leaves, with the shape or axis on each."""
    return (axes(up="") + path("M40 100 L140 100", BLUE) + path("M140 100 L235 100", RED)
            + path("M140 100 C150 60 190 44 235 38", BLUE) + dot(140, 100) + base + turned)


SKETCHES = {
    "fold-nu": axes() + path("M40 120 C150 116 205 105 205 82", BLUE) + path("M205 82 C205 60 150 46 60 42", BLUE)
               + dot(205, 82),
    "fold-momentum": axes("|π|") + path("M40 110 C120 106 190 96 190 76", BLUE)
                     + path("M190 76 C190 58 140 44 70 40", RED) + dot(190, 76),
    "fold-parameter": (axes("parameter") + path("M40 120 C150 116 205 105 205 82", BLUE)
                       + path("M205 82 C205 60 150 46 60 42", BLUE) + dot(205, 82)),
    "tilt": spins(shape(75, 72, 24, 9) + arrow(75, 94, 75, 44), shape(205, 74, 24, 9, -30) + arrow(205, 96, 205, 52)),
    "inertia-exchange": two_lines("I₁", "I₂"),
    "ellipse": spins(shape(80, 70, 17, 17), shape(205, 70, 26, 13)),
    "ellipse-23": spins(shape(80, 70, 9, 20), shape(205, 70, 9, 27)) + text(80, 42, "2, 3") + text(205, 34, "2"),
    "ellipse-13": spins(shape(80, 70, 9, 20), shape(205, 70, 9, 27)) + text(80, 42, "1, 3") + text(205, 34, "1"),
    "oblique": spins(shape(75, 72, 26, 12) + arrow(45, 72, 110, 72), shape(200, 72, 26, 12, -20) + arrow(170, 72, 235, 72)),
    "shear": spins(shape(80, 70, 26, 13), shape(205, 70, 26, 13, -25) + path("M178 70 L232 70", GREY)),
    "hamiltonian-hopf": plane() + arrow(130, 20, 130, 44) + arrow(130, 76, 130, 66)
                        + path("M130 56 C150 54 170 52 190 46", RED) + path("M130 56 C110 54 90 52 70 46", RED) + dot(130, 56)
                        + text(118, 34, "+", "end") + text(118, 76, "−", "end"),
    "krein-pass": axes(up="frequency") + path("M40 110 L230 50", BLUE)
                  + path("M40 50 L230 110", BLUE.replace("/>", "") + ' stroke-dasharray="2 4"') + dot(135, 80)
                  + text(52, 98, "+") + text(52, 46, "−"),
    "real-collision": plane() + path("M230 80 L138 80", RED) + arrow(204, 80, 198, 80) + arrow(164, 80, 170, 80)
                      + path("M184 80 C184 60 184 50 190 34", RED) + path("M184 80 C184 100 184 110 190 126", RED) + dot(184, 80),
    "zero-momentum": (axes("s₃", "ω") + path("M135 140 L135 20", GREY + ' stroke-dasharray="2 4"')
                      + path("M40 118 C90 110 120 90 135 78", BLUE)
                      + path("M135 78 C150 66 190 46 230 40", BLUE.replace("/>", "") + ' stroke-dasharray="2 4"') + dot(135, 78)
                      + text(80, 84, "+") + text(190, 84, "−")),
    "unexplained": axes(up="negative") + path("M40 110 L135 110 L135 60 L230 60", BLUE) + text(135, 48, "?") + dot(135, 85),
    "collapse": axes() + path("M40 60 C140 64 190 90 205 136", BLUE) + dot(205, 138),
    "escape": axes() + path("M40 116 C140 112 196 90 206 20", BLUE) + path("M212 18 L212 140", GREY + ' stroke-dasharray="2 4"'),
    "domain": axes() + '<rect x="190" y="22" width="48" height="118" fill="#dcdcdc"/>'
              + path("M40 112 C90 100 140 90 190 66", BLUE) + dot(190, 66) + text(214, 134, "none"),
    "limit": axes() + path("M40 112 C90 100 140 90 200 66", BLUE) + path("M200 20 L200 140", FRONT) + dot(200, 66) + text(200, 156, "to"),
    "closed": axes() + shape(135, 78, 70, 40, 0, BLUE) + dot(65, 78),
    "stalled": axes() + path("M40 112 C90 100 110 96 140 86", BLUE) + path("M146 84 L148 83 M154 81 L156 80", BLUE) + text(172, 80, "…", "start"),
    "stable": plane() + zero(130, 40, "+") + zero(130, 58, "+") + zero(130, 102) + zero(130, 120),
    "elliptic": plane() + zero(130, 40, "+") + zero(130, 58, "−") + zero(130, 102) + zero(130, 120),
    "unstable": plane() + zero(130, 40) + zero(130, 120) + growing(180, 80) + growing(80, 80),
    "oscillatory": plane() + "".join(growing(130 + x, 80 + y) for x in (-45, 45) for y in (-35, 35)),
    "marginal": plane() + zero(130, 40) + zero(130, 120)
                + '<circle cx="130" cy="80" r="18" fill="#dcdcdc" fill-opacity="0.8" stroke="#767676"/>' + text(130, 85, "?"),
}

HEAD = (f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT}" viewBox="0 0 {WIDTH} {HEIGHT}" '
        'font-family="sans-serif" font-size="13">'
        '<defs><marker id="tip" viewBox="0 0 8 8" refX="7" refY="4" markerWidth="7" markerHeight="7" orient="auto">'
        '<path d="M0 0 L8 4 L0 8 z" fill="#1b1b1b"/></marker></defs>'
        f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#fff"/>')

if __name__ == "__main__":
    here = pathlib.Path(__file__).parent
    for name, body in SKETCHES.items():
        (here / f"{name}.svg").write_text(HEAD + body + "</svg>\n", encoding="utf-8")
