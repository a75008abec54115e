# SPDX-License-Identifier: MIT
"""The rows of the table in docs/benchmarks.md: what is compared with what, and the goal.

kind: "ratio"        the cost of the cheapest of `against` over that of `contestant`, per unit of work; at least `goal`
      "threads"      one thread's cost over that of two; at least `goal`, or 0.9 of what a fill gains if that is less
      "flat"         the largest over the smallest cost of a unit in the row, each over a fill of as much memory; at
                     most `goal`
      "memory"       peak memory of a process over its output and input; at most `goal`
      "first-point"  time of a fresh process over 5 ms; at most `goal`
"""


def ratio(work, regime, row, against, goal, said=None, contestant="internode"):
    against = [against] if isinstance(against, str) else against
    return {"kind": "ratio", "work": work, "regime": regime, "row": row, "contestant": contestant, "against": against,
            "said": said or against[0], "goal": goal}


def planned(work, row, opponents):
    """Without a goal: what deriving the plan costs can be seen."""
    return [ratio("" if i else work, "reused", row, name, None, said, "internode-planned")
            for i, (name, said) in enumerate(opponents)]


def at_most(kind, work, regime, row, said, goal):
    return {"kind": kind, "work": work, "regime": regime, "row": row, "said": said, "goal": goal}


def kind(work, contestant):
    return ratio(work, "reused", "kinds-10M-reused", "cubic", 0.7, "cubic Fibonacci, per multiply-add", contestant)


fills = ["fill", "fill-streamed"]


def of_bytes(work, contestant, goal=0.7):
    return ratio(work, "reused", "bytes-10M-reused", fills, goal, "the best fill of as much memory", contestant)


def threads(points, regime, row, goal):
    claim = ratio(f"two threads, {points} points", regime, row, "one-thread", goal, "one thread", "two-threads")
    return claim if row == "threads-90k-reused" else {**claim, "kind": "threads"}


def text(work, row, one=None, two=1.7):
    """On one thread against a plain loop, and on two threads against one."""
    against_loop = [ratio(work, "one thread", row, "plain-loop", one, "a plain loop of `fmt::format_to`", "one-thread")]
    return (against_loop if one else []) + [ratio("" if one else work, "two threads", row, "one-thread", two,
                                                  "one thread", "two-threads")]


def stores(points, regime, row):
    """The stores that were measured are the better ones; what a result loses by the measuring can be seen."""
    return [ratio(f"stores of {points} points", regime, row, ["cached", "streamed"], 0.9, "the better of both forced",
                  "measured"),
            ratio("", regime, row, "cached", None, "ordinary stores", "streamed")]


claims = [
    ratio("cubic Fibonacci, 1.6 k → 24 M points", "reused", "curve-24M-reused", fills, 0.8,
          "the best fill of as much memory"),
    ratio("", "reused", "curve-24M-reused", "memcpy", 1.2, "`memcpy` of the result"),
    ratio("", "fresh", "curve-24M-fresh", "first-touch", 0.9, "first touch of as much memory, large pages"),
    *stores("24 M", "reused", "stores-24M-reused"),
    *stores("1 M", "reused", "stores-1M-reused"),
    *stores("10 M", "fresh", "stores-10M-fresh"),
    ratio("cubic Fibonacci, 1 M points", "reused", "curve-1M-reused", "sisl-s1018", 30, "SISL s1018 (allocates)"),
    ratio("", "reused", "curve-1M-reused", "a54", 6, "A5.4 by hand, knots given"),
    ratio("", "reused", "curve-1M-reused", "eigen-sparse", 5, "Eigen sparse matrix, built beforehand"),
    ratio("", "reused", "curve-1M-reused", "memcpy", None, "`memcpy` of the result"),
    *planned("the same, plan made beforehand", "curve-1M-reused",
             [("sisl-s1018", "SISL s1018 (allocates)"), ("a54", "A5.4 by hand, knots given"),
              ("eigen-sparse", "Eigen sparse matrix, built beforehand"), ("memcpy", "`memcpy` of the result")]),
    ratio("cubic Fibonacci, 10 M points", "fresh", "curve-10M-fresh", ["a54", "eigen-sparse", "sisl-s1018"], 1.8,
          "best peer, fresh"),
    ratio("", "fresh", "curve-10M-fresh", "first-touch", 0.85, "first touch of as much memory"),
    of_bytes("cubic, 3-D, 10 M points", "degree-3"),
    of_bytes("degree 2", "degree-2"),
    of_bytes("degree 5", "degree-5"),
    of_bytes("degree 12", "degree-12", None),
    of_bytes("cubic, 2-D", "2-D"),
    of_bytes("cubic, 4-D", "4-D"),
    of_bytes("cubic, 7-D", "7-D"),
    of_bytes("cubic, 3-D, float", "float"),
    kind("degree 2, 10 M points", "degree-2"),
    kind("degree 5, 10 M points", "degree-5"),
    kind("uniform A → A A, 10 M points", "uniform"),
    kind("closed, 10 M points", "closed"),
    kind("open, 10 M points", "open"),
    kind("float, 10 M points", "float"),
    ratio("Chaikin as the point grammar S0 (17), 10 M points", "reused", "chaikin-10M-reused", "interval-grammar", 0.9,
          "`A -> A A`, degree 2", "point-grammar"),
    ratio("cubic scheme as the point grammar S0 (22), 10 M points", "reused", "cubic-points-10M-reused",
          "interval-grammar", 0.9, "`A -> A A`, degree 3", "point-grammar"),
    ratio("bicubic grid, Fibonacci × silver, 1.5 M points", "reused", "grid-1.5M-reused", "memcpy", 0.8,
          "`memcpy` of the result"),
    ratio("", "reused", "grid-1.5M-reused", "separable", 1.5, "separable loop by hand, precomputed masks"),
    *planned("the same, plan made beforehand", "grid-1.5M-reused",
             [("memcpy", "`memcpy` of the result"), ("separable", "separable loop by hand, precomputed masks")]),
    ratio("bicubic grid, Fibonacci × silver, 24 M points", "reused", "grid-24M-reused", fills, 0.75,
          "the best fill of as much memory"),
    ratio("", "reused", "grid-24M-reused", "memcpy", 0.8, "`memcpy` of the result"),
    ratio("", "reused", "grid-24M-reused", "separable", 1.5, "separable loop by hand, precomputed masks"),
    *planned("the same, plan made beforehand", "grid-24M-reused",
             [("memcpy", "`memcpy` of the result"), ("separable", "separable loop by hand, precomputed masks")]),
    ratio("every level kept, 14 levels to 1 M points", "reused", "levels-reused", "memcpy", 0.7, "`memcpy` of all of it"),
    threads("24 M", "fresh", "threads-24M-fresh", 1.6),
    threads("24 M", "reused", "threads-24M-reused", 1.6),
    threads("90 k", "reused", "threads-90k-reused", 1.0),
    ratio("cubic Fibonacci, 34 k points", "reused", "scripts", "scipy-insert", None, "scipy `insert`, a knot a call"),
    ratio("", "reused", "scripts", "octave-nrbkntins", None, "octave `nrbkntins`"),
    at_most("flat", "cost of a point over that of a fill, 1 M, 10 M and 100 M points", "reused", "sizes-reused",
            "the dearest over the cheapest", 1.2),
    at_most("flat", "the same, plan made beforehand", "reused", "sizes-planned", "the dearest over the cheapest", None),
    *text("CSV, 1 M points", "text-csv", 1.5),
    *text("JSON, 1 M points", "text-json"),
    *text("OBJ, 1 M points", "text-obj"),
    *text("CSV read, 1 M points", "text-read-csv", two=None),
    at_most("memory", "peak memory, 24 M points", "fresh", "", "output + input", 1.15),
    at_most("first-point", "from the text file to the first refined point, d = 3", "fresh process", "", "5 ms", 1.0),
]
