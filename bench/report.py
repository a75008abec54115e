#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the measured part of docs/benchmarks.md from out/bench.json.

usage: report.py BENCH_JSON PAGE      replaces what stands between the two markers of the page
"""
import json
import pathlib
import sys

begin, end = "<!-- measured -->\n", "<!-- end of what was measured -->\n"


def number(value):
    return f"{value:.3g}" if value < 100 else f"{value:.0f}"


def is_gain(claim):
    return claim["kind"] in ("ratio", "threads")


def outcome(claim):
    if claim["goal"] is None:
        return ""
    reached = claim["ratio"] >= claim["goal"] if is_gain(claim) else claim["ratio"] <= claim["goal"]
    return "reached" if reached else "**falls short**"


def goal(claim):
    if claim["goal"] is None:
        return "none"
    return ("≥ " if is_gain(claim) else "≤ ") + number(claim["goal"])


def opponent(claim):
    several = len(claim.get("against", [])) > 1
    return f"{claim['said']}: {claim['opponent']}" if several else claim["said"]


def line(claim):
    if not claim["measured"]:
        cells = [claim["work"], claim["regime"], claim["said"], "not on this machine", "", goal(claim), ""]
    else:
        extremes = f"{number(claim['lowest'])} – {number(claim['highest'])}" if "lowest" in claim else ""
        cells = [claim["work"], claim["regime"], opponent(claim), number(claim["ratio"]), extremes, goal(claim),
                 outcome(claim)]
    return "| " + " | ".join(cells) + " |\n"


def size(cache):
    kib = cache["size"] // 1024
    return f"{cache['type'].lower()} L{cache['level']} " + (f"{kib} KiB" if kib < 1024 else f"{kib // 1024} MiB")


def description(machine):
    rate = {name: number(value) for name, value in machine["gigabytes_per_second"].items()}
    caches = ", ".join(size(cache) for cache in machine["caches"] if cache["type"] != "Instruction")
    return (f"The machine: {machine['processor']}, {machine['cores']} cores, {caches}; {machine['compiler']}. One core moves, "
            f"in GB/s of 512 MiB: `memcpy` {rate['memcpy']} (read and written as often), plain fill {rate['fill']}, first "
            f"touch {rate['first-touch-large-pages']} with large pages and {rate['first-touch-plain']} as `new` gives memory. "
            f"Load while measuring: {machine['load']:.1f}.\n")


report = json.loads(pathlib.Path(sys.argv[1]).read_text())
apart = max(claim["disagreement"] for claim in report["claims"] if claim["disagreement"] is not None)
text = description(report["machine"]) + "\n"
text += "| work | regime | against | ratio | in a round | goal | |\n|---|---|---|---|---|---|---|\n"
text += "".join(line(claim) for claim in report["claims"])
text += (f"\nMedians of {report['repetitions']} interleaved repetitions. Contestants computed the same points: the largest "
         f"difference, relative to the largest coordinate, was {apart:.1g}.\n")
if report["instructions"]:
    counts = ", ".join(f"{case} {count:.2f}" for case, count in report["instructions"].items())
    text += f"\nInstructions for a multiply-add by callgrind, loads and stores among them: {counts}.\n"
page = pathlib.Path(sys.argv[2])
before, _, rest = page.read_text().partition(begin)
_, _, after = rest.partition(end)
page.write_text(before + begin + "\n" + text + "\n" + end + after)
