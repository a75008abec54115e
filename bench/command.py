#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Measures the command end to end: what a user waits for, files and all. Writes the second table of the page.

usage: command.py INTERNODE OUTPUT_FOLDER PAGE REPETITIONS [OLDER_INTERNODE]      (scripts/bench calls it)

Seconds on the wall and peak memory of whole processes, medians of interleaved runs, on one thread and on all. Where an
older internode is given, its figures stand beside them.
"""
import os
import pathlib
import shutil
import statistics
import subprocess
import sys
import time

internode = pathlib.Path(sys.argv[1]).resolve()
folder = pathlib.Path(sys.argv[2])
page = pathlib.Path(sys.argv[3])
repetitions = int(sys.argv[4])
older = pathlib.Path(sys.argv[5]).resolve() if len(sys.argv) > 5 else None
begin, end = "<!-- measured: the command -->\n", "<!-- end of what was measured: the command -->\n"

root = pathlib.Path(__file__).resolve().parent.parent
coast = root / "data/curves/iceland-coast.csv"
closed = ["-d", "3", "--closed", "--word", "LS", "--repeat"]
memory = pathlib.Path("/dev/shm")


def run(command):
    """Seconds and mebibytes of a process that must succeed."""
    start = time.perf_counter()
    child = subprocess.Popen([str(part) for part in command], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    _, status, usage = os.wait4(child.pid, 0)
    seconds = time.perf_counter() - start
    child.returncode = os.waitstatus_to_exitcode(status)
    if child.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))} ended with {child.returncode}")
    return seconds, usage.ru_maxrss / 1024


def measured(contestants):
    """Name to command: name to the medians of seconds and memory."""
    runs = {name: [] for name in contestants}
    for _ in range(repetitions):
        for name, command in contestants.items():
            runs[name].append(run(command))
    return {name: [statistics.median(of) for of in zip(*figures)] for name, figures in runs.items()}


def text(value):
    return f"{value:.3g}" if value < 100 else f"{value:.0f}"


def row(work, arguments, threads=True):
    """One thread, all threads, their ratio and the memory; and those of the older one."""
    on_all = [*arguments, "--threads", "0"] if threads else arguments
    contestants = {"all": [internode, *on_all]}
    if threads:
        contestants["one"] = [internode, *arguments, "--threads", "1"]
    if older:
        contestants["older"] = [older, *on_all]
    figures = measured(contestants)
    of_all, peak = figures["all"]
    one = [text(figures["one"][0]), f"{figures['one'][0] / of_all:.2f}"] if threads else ["", ""]
    before = f"{text(figures['older'][0])} s, {text(figures['older'][1])} MiB" if older else "not measured"
    return f"| {work} | {one[0]} | {text(of_all)} | {one[1]} | {text(peak)} | {before} |\n"


def in_binary(work, arguments, suffix):
    """A row: into nothing, into memory, into a file; and a copy of as many bytes into the same two places."""
    places = {"memory": memory / f"internode-bench{suffix}", "file": folder / f"bench{suffix}"}
    run([internode, *arguments, "-o", places["file"]])
    source = folder / f"source{suffix}"
    shutil.copyfile(places["file"], source)
    contestants = {"null": [internode, *arguments, "--format", suffix[1:], "-o", "/dev/null"]}
    for name, place in places.items():
        contestants[name] = [internode, *arguments, "-o", place]
        contestants["copy-" + name] = ["cp", source, str(place) + ".copy"]
    figures = measured(contestants)
    size = source.stat().st_size
    for place in [source, *places.values(), *(pathlib.Path(str(place) + ".copy") for place in places.values())]:
        place.unlink(missing_ok=True)
    seconds = {name: figures[name][0] for name in contestants}
    return (f"| {work}, {size / 1e6:.0f} MB | {text(seconds['null'])} | {text(seconds['memory'])} | "
            f"{text(seconds['copy-memory'])} | {text(seconds['file'])} | {text(seconds['copy-file'])} |\n")


folder.mkdir(parents=True, exist_ok=True)
refined = folder / "polygon.csv"
subprocess.run([internode, "subdivide", "@fibonacci", coast, *closed, "-n", "13", "-o", refined], check=True)
points = sum(1 for _ in open(refined)) - 1
millions = f"{points / 1e6:.2g} M points"
lines = "| work | one thread, s | all threads, s | ratio | peak, MiB | before |\n|---|---|---|---|---|---|\n"
refine = ["subdivide", "@fibonacci", coast, *closed, "-n", "13", "-o", "/dev/null", "--format"]
for form in ("csv", "json", "obj"):
    lines += row(f"`subdivide` to {millions} of {form.upper()}", [*refine, form])
lines += row(f"reading {millions} of CSV", ["subdivide", "@fibonacci", refined, *closed, "-n", "0",
                                                                   "-o", "/dev/null", "--format", "npy"])
lines += row(f"`converge` of {millions}, 3 steps", ["converge", "@fibonacci", refined, *closed, "-n", "3"], threads=False)
lines += row(f"`reverse` of {millions}, 5 levels",
                    ["reverse", "@fibonacci", refined, *closed, "--resample", "-n", "5", "-o", "/dev/null"],
             threads=False)
lines += ("\n| work, all threads | to `/dev/null`, s | to memory, s | `cp` to memory, s | to a file, s | `cp` to a file, s |\n"
          "|---|---|---|---|---|---|\n")
lines += in_binary(f"`subdivide` to {millions} of NPY", ["subdivide", "@fibonacci", coast, *closed, "-n", "13"], ".npy")
grid = ["subdivide", "--u", "@fibonacci", "--v", "@silver-mean", root / "data/grids/wave.json", "-n", "8"]
for suffix in (".ply", ".stl"):
    lines += in_binary(f"`subdivide` of a grid to {suffix[1:].upper()}", grid, suffix)
refined.unlink()
before, _, rest = page.read_text().partition(begin)
_, _, after = rest.partition(end)
page.write_text(before + begin + "\n" + lines + f"\nMedians of {repetitions} interleaved runs of whole processes. Before: "
                "the internode given to `scripts/bench` to compare with.\n\n" +
                end + after)
