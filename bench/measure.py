#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Measures every row of the table in one run: out/bench.json, ratios of medians.

usage: measure.py BUILD_FOLDER OUTPUT_FOLDER REPETITIONS      (scripts/bench calls it)

A row is a process of internode_bench, its contestants in random turns; nothing is measured when two of them disagree.
"""
import json
import os
import pathlib
import platform
import shutil
import statistics
import subprocess
import sys

from claims import claims

ours = pathlib.Path(sys.argv[1])
output = pathlib.Path(sys.argv[2])
repetitions = int(sys.argv[3])
peers = pathlib.Path(__file__).parent / "peers"
raw = output / "bench"
raw.mkdir(parents=True, exist_ok=True)


def text_of(*command):
    return subprocess.run([str(part) for part in command], check=True, stdout=subprocess.PIPE, text=True).stdout


def measured_row(name):
    """Per contestant the cost of a unit of work in each repetition, and what was compared."""
    path = raw / f"{name}.json"
    text_of(ours / "internode_bench", "--row", name, f"--benchmark_repetitions={repetitions}",
            "--benchmark_enable_random_interleaving=true", f"--benchmark_out={path}", "--benchmark_out_format=json")
    result = json.loads(path.read_text())
    costs = {}
    for run in result["benchmarks"]:
        if run["run_type"] == "iteration":
            contestant = run["name"].split("/")[1]
            costs.setdefault(contestant, {})[run["repetition_index"]] = run["real_time"] / run["amount"]
    context = result["context"]
    return {"costs": {one: [of[i] for i in sorted(of)] for one, of in costs.items()}, "caches": context["caches"],
            "points": {run["name"].split("/")[1]: int(run["points"]) for run in result["benchmarks"]},
            "compared": int(context["compared"]), "disagreement": float(context["disagreement"])}


def script_row():
    """The peers that are scripts, in turns with internode, on a curve that suits them."""
    case = raw / "case"
    case.mkdir(exist_ok=True)
    commands = {"scipy-insert": [sys.executable, peers / "scipy_insert.py", case]}
    if shutil.which("octave-cli"):
        commands["octave-nrbkntins"] = ["octave-cli", "-q", peers / "nrbkntins.m", case]
    costs = {"internode": []}
    disagreement = 0.0
    for _ in range(repetitions):
        costs["internode"].append(float(text_of(ours / "internode_bench", "--case", case)))
        for name, command in commands.items():
            seconds, apart = map(float, text_of(*command).split())
            if not apart <= 1e-9:
                sys.exit(f"{name}: points differ by {apart:.3g}")
            disagreement = max(disagreement, apart)
            costs.setdefault(name, []).append(seconds)
    return {"costs": costs, "compared": len(costs), "disagreement": disagreement, "points": {}}


def once(what):
    return [float(text_of(ours / "internode_bench_once", what)) for _ in range(repetitions)]


def compared(claim, rows):
    """How many times the cost of the claim's contestant its opponent has, by medians; with the extremes in a round."""
    costs = rows[claim["row"]]["costs"]
    present = [name for name in claim["against"] if name in costs]
    if not present:
        return None
    best = min(present, key=lambda name: statistics.median(costs[name]))
    rounds = [theirs / mine for mine, theirs in zip(costs[claim["contestant"]], costs[best])]
    ratio = statistics.median(costs[best]) / statistics.median(costs[claim["contestant"]])
    return {"opponent": best, "ratio": ratio, "lowest": min(rounds), "highest": max(rounds)}


def median_costs(row):
    return {name: statistics.median(of) for name, of in row["costs"].items()}


def on_threads(claim, rows):
    """The gain of a second thread; its goal is what a fill that computes nothing gains, if that is less."""
    costs = median_costs(rows[claim["row"]])
    fill = {threads: min(costs[f"{kind}-{threads}"] for kind in ("fill", "fill-streamed")) for threads in ("one", "two")}
    gain = fill["one"] / fill["two"]
    return {**compared(claim, rows), "goal": min(claim["goal"], 0.9 * gain),
            "said": f"{claim['said']} (a fill gains {gain:.2f})"}


def flatness(claim, rows):
    """The dearest point over the cheapest, each over the best fill of as much memory."""
    costs = median_costs(rows[claim["row"]])
    over = [cost / min(costs[f"{kind}-{size}"] for kind in ("fill", "fill-streamed"))
            for size, cost in costs.items() if not size.startswith("fill")]
    return {"ratio": max(over) / min(over)}


def of_processes(values):
    return {"ratio": statistics.median(values), "lowest": min(values), "highest": max(values)}


def result_of(claim, rows):
    if claim["kind"] == "memory":
        return of_processes(once("memory"))
    if claim["kind"] == "first-point":
        return of_processes([seconds / 0.005 for seconds in once("first-point")])
    return {"flat": flatness, "threads": on_threads, "ratio": compared}[claim["kind"]](claim, rows)


def machine(row):
    gigabytes = {name: 1e-6 / cost for name, cost in median_costs(row).items()}
    model = [line.split(":")[1].strip() for line in open("/proc/cpuinfo") if line.startswith("model name")][:1]
    compiler = [line.split("=", 1)[1].strip() for line in open(ours.parent / "CMakeCache.txt")
                if line.startswith("CMAKE_CXX_COMPILER:")][0]
    return {"processor": (model or [platform.machine()])[0], "cores": os.cpu_count(), "caches": row["caches"],
            "compiler": text_of(compiler, "--version").splitlines()[0], "gigabytes_per_second": gigabytes,
            "load": os.getloadavg()[0]}


def instructions():
    """Of a multiply-add, for each case of bench/byte_cases.h: two runs less one, by callgrind; none without it."""
    if not shutil.which("valgrind"):
        return {}
    counted = {}
    for case in ("degree-2", "degree-3", "degree-5", "degree-12", "2-D", "4-D", "7-D", "float"):
        collected = {}
        for runs in (1, 2):
            file = raw / "callgrind.out"
            once = text_of("valgrind", "--quiet", "--tool=callgrind", f"--callgrind-out-file={file}",
                           ours / "internode_bench_once", "apply", case, runs)
            summary = [line for line in file.read_text().splitlines() if line.startswith(("summary:", "totals:"))]
            collected[runs] = int(summary[-1].split()[1])
        counted[case] = (collected[2] - collected[1]) / float(once)
    return counted


def main():
    rows = {name: measured_row(name) for name in text_of(ours / "internode_bench", "--list").split()}
    rows["scripts"] = script_row()
    table = []
    for claim in claims:
        result = result_of(claim, rows)
        row = rows.get(claim["row"], {})
        table.append({**claim, **(result or {}), "measured": result is not None})
        table[-1]["disagreement"] = row.get("disagreement") if row.get("compared", 0) > 1 else None
    report = {"repetitions": repetitions, "machine": machine(rows["machine"]), "claims": table,
              "instructions": instructions()}
    (output / "bench.json").write_text(json.dumps(report, indent=1) + "\n")


main()
