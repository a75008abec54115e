#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What the point grammars of data/grammars give, computed from the formulas of the papers in exact fractions.

Independent of the program: no rewriting here, but the matrices and affine combinations as the papers print them, with
indices. Each grammar G.lsys has its result beside it in G.expected: the command, then its exact output.

  expected_points.py           compares the files with what is computed, exit code 1 when one differs
  expected_points.py --write   writes them
"""

import pathlib
import sys
from fractions import Fraction as F

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
DATA = ROOT / "data"


# --- polygons and numbers --------------------------------------------------------------------------------------------


def polygon(name):
    rows = (DATA / "curves" / name).read_text().splitlines()
    return [tuple(F(float(cell)) for cell in row.split(",")) for row in rows[1:]]


def number(value):
    """The shortest decimal of the nearest double, as the program writes it."""
    text = repr(float(value))
    return text[:-2] if text.endswith(".0") else text


def mix(*terms):
    """Sum of weight times point."""
    return tuple(sum(F(w) * p[i] for w, p in terms) for i in range(len(terms[0][1])))


def csv(points):
    names = ["x", "y", "z"][: len(points[0])]
    return "\n".join([",".join(names), *(",".join(map(number, p)) for p in points)]) + "\n"


def point(p):
    return "(" + ", ".join(map(number, p)) + ")"


def repeat(step, points, cycles):
    for _ in range(cycles):
        points = step(points)
    return points


# --- closed schemes: S0 sections 4 and 5, by the rows of the matrices ------------------------------------------------


def rows_of(rows, shift):
    """The step of a circulant matrix of arity two: row 2i + r has weights at i + offset; rotated by `shift`."""

    def step(points):
        n = len(points)
        new = [mix(*((w, points[(i + o) % n]) for o, w in row.items())) for i in range(n) for row in rows]
        return new[shift:] + new[:shift] if shift >= 0 else new[shift:] + new[:shift]

    return step


CHAIKIN = [{-1: F(1, 4), 0: F(3, 4)}, {0: F(3, 4), 1: F(1, 4)}]  # matrix (14)
CUBIC = [{-1: F(1, 8), 0: F(3, 4), 1: F(1, 8)}, {0: F(1, 2), 1: F(1, 2)}]  # matrix (21)
FOUR_POINT = [{0: F(1)}, {-1: F(-1, 16), 0: F(9, 16), 1: F(9, 16), 2: F(-1, 16)}]  # matrix (24)
SIX_POINT = [{0: F(1)}, {o: F(w, 256) for o, w in zip(range(-2, 4), (3, -25, 150, 150, -25, 3))}]


def tension(w):
    return [{0: F(1)}, {-1: -w, 0: F(1, 2) + w, 1: F(1, 2) + w, 2: -w}]


def corners(a):
    return [{-1: a, 0: 1 - a}, {0: 1 - a, 1: a}]


def open_chaikin(points):
    """Matrix (27): 2n - 2 rows."""
    n = len(points)
    new = [points[0], mix((F(1, 2), points[0]), (F(1, 2), points[1]))]
    for i in range(1, n - 2):
        new += [mix((F(3, 4), points[i]), (F(1, 4), points[i + 1])), mix((F(1, 4), points[i]), (F(3, 4), points[i + 1]))]
    return [*new, mix((F(1, 2), points[-2]), (F(1, 2), points[-1])), points[-1]]


def reverse_chaikin(points):
    """The matrix (37) with its columns moved by one, so that it pairs (1, 2), (3, 4), ...: the inverse of (14)."""
    n = len(points)
    weights = (F(-1, 4), F(3, 4), F(3, 4), F(-1, 4))
    return [mix(*((w, points[(2 * i + o) % n]) for o, w in zip((-1, 0, 1, 2), weights))) for i in range(n // 2)]


def edge_chaikin(points, cycles):
    """(8) and (10) with n = 1: two points from each edge; the word begins with P, E, P, ... in turn."""
    starts_with_edge = False
    for _ in range(cycles):
        n = len(points)
        edges = [(i - 1, i) for i in range(n)] if starts_with_edge else [(i, (i + 1) % n) for i in range(n)]
        new = []
        for i, j in edges:
            new += [mix((F(3, 4), points[i]), (F(1, 4), points[j])), mix((F(1, 4), points[i]), (F(3, 4), points[j]))]
        points, starts_with_edge = new, not starts_with_edge
    return points


def edge_word(points, cycles):
    """The words of (8) on a polygon, and last the edges of (9)."""
    lines = [" ".join(f"P({point(p)}) E" for p in points)]
    for cycle in range(1, cycles + 1):
        new = edge_chaikin(points, cycle)
        lines.append(" ".join(f"E P({point(p)})" if cycle % 2 else f"P({point(p)}) E" for p in new))
    new = edge_chaikin(points, cycles)
    edges = [f"L({point(new[i - 1])}, {point(p)}) P({point(p)})" for i, p in enumerate(new)]
    assert cycles % 2, "the word begins with an edge"
    return "\n".join([*lines, " ".join(edges)]) + "\n"


# --- Bezier curves: S1 sections 4 and 5, by Bernstein's basis --------------------------------------------------------


def binomial(n, k):
    result = 1
    for i in range(k):
        result = result * (n - i) // (i + 1)
    return result


def bernstein(points, t):
    n = len(points) - 1
    return mix(*((binomial(n, i) * t**i * (1 - t) ** (n - i), p) for i, p in enumerate(points)))


def partial_polygon(points, step, t):
    """The points after `step` steps of de Casteljau: each is the Bernstein sum of step + 1 points."""
    return [bernstein(points[i : i + step + 1], t) for i in range(len(points) - step)]


def halves(points, t, cycles):
    """Control polygons of the pieces, their ends shared: the points of p(0 .. k) and p(k .. n) by blossoms."""
    degree = len(points) - 1
    pieces = [points]
    for _ in range(cycles):
        split = []
        for piece in pieces:
            split.append([bernstein(piece[: k + 1], t) for k in range(degree + 1)])
            split.append([bernstein(piece[k:], t) for k in range(degree + 1)])
        pieces = split
    return [pieces[0][0], *(p for piece in pieces for p in piece[1:])]


def polygon_word(points, letter="P"):
    return " E ".join(f"{letter}({point(p)})" for p in points)


def rational_trace(t):
    weighted = [(x * w, y * w, w) for x, y, w in polygon("arc.csv")]
    once = partial_polygon(weighted, 1, t)
    flat = [(x / w, y / w) for x, y, w in once]
    edges = f"P'({point(flat[0])}) L({point(flat[0])}, {point(flat[1])}) P'({point(flat[1])})"
    return "\n".join([polygon_word(weighted), polygon_word(once), polygon_word(flat, "P'"), edges]) + "\n"


# --- the table -------------------------------------------------------------------------------------------------------

SQUARE, PEBBLE = "data/curves/square.csv", "data/curves/pebble.csv"
TWO, THREE, FOUR = (f"data/curves/bezier-{degree}.csv" for degree in (2, 3, 4))


def closed(rows, shift=0, cycles=2):
    return f"{PEBBLE} -n {cycles}", csv(repeat(rows_of(rows, shift), polygon("pebble.csv"), cycles))


def expected():
    pebble = polygon("pebble.csv")
    quartic, half = polygon("bezier-4.csv"), F(1, 2)
    yield "s0/11", "-n 1 --trace", "A(1.5) B(2, 3) A(4.5)\nA(4) A(3.5) A(7.5) A(10)\n"
    yield "s0/13", *closed(CHAIKIN)
    yield "s0/17", *closed(CHAIKIN, -1)
    yield "s0/18", *closed(CHAIKIN, 1)
    yield "s0/20", *closed(CHAIKIN, 5)
    yield "s0/22", *closed(CUBIC)
    yield "s0/23", *closed(CUBIC, -1)
    yield "s0/25", *closed(FOUR_POINT)
    yield "s0/26", *closed(FOUR_POINT, -1)
    for name in ("s0/28-33", "s0/34-36"):
        yield name, f"{PEBBLE} -n 2", csv(repeat(open_chaikin, pebble, 2))
    yield "s0/38", f"{PEBBLE} -n 1", csv(reverse_chaikin(pebble))
    yield "s1/2", "-n 1 --trace", "A(1.5) B(2, 3) A(4.5) C(1)\nA(4) A(3.5) A(7.5) B(10) C(1)\n"
    yield "s1/7", *closed(CHAIKIN)
    yield "s1/8", f"{PEBBLE} -n 2", csv(edge_chaikin(pebble, 2))
    yield "s1/9", f"{SQUARE} -n 1 --trace", edge_word(polygon("square.csv"), 1)
    yield "s1/10", f"{PEBBLE} -n 2", csv(edge_chaikin(pebble, 2))
    yield "s1/11", f"{FOUR} -n 4", csv([bernstein(quartic, half)])
    yield "s1/12", f"{FOUR} -n 4 --set t=1/4", csv([bernstein(quartic, F(1, 4))])
    yield "s1/13", f"{FOUR} -n 2 --set t=0.75", csv(partial_polygon(quartic, 2, F(3, 4)))
    yield "s1/14-16", f"{FOUR} -n 2", csv(halves(quartic, half, 2))
    yield "s1/17", f"{TWO} -n 3", csv(halves(polygon("bezier-2.csv"), half, 3))
    for name in ("s1/18", "s1/19"):
        yield name, f"{THREE} -n 2", csv(halves(polygon("bezier-3.csv"), half, 2))
    yield "s1/20-21", "data/curves/arc.csv --rational -n 1 --trace", rational_trace(half)
    yield "four-point", f"{PEBBLE} -n 2 --set w=1/8", csv(repeat(rows_of(tension(F(1, 8)), 0), pebble, 2))
    yield "six-point", *closed(SIX_POINT)
    yield "lane-riesenfeld", f"{PEBBLE} -n 1", csv(rows_of(CUBIC, 1)(pebble))
    yield "corner-cutting", f"{PEBBLE} -n 2 --set a=1/8", csv(repeat(rows_of(corners(F(1, 8)), 0), pebble, 2))


def main():
    write = sys.argv[1:] == ["--write"]
    if sys.argv[1:] and not write:
        sys.exit(__doc__)
    wrong = 0
    for name, arguments, output in expected():
        path = DATA / "grammars" / f"{name}.expected"
        text = f"$ internode subdivide @{name} {arguments}\n{output}"
        if write:
            path.write_text(text)
        elif not path.exists() or path.read_text() != text:
            print(f"{path.relative_to(ROOT)} is not what the formulas give")
            wrong = 1
    sys.exit(wrong)


if __name__ == "__main__":
    main()
