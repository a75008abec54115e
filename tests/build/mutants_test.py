#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks scripts/mutants without building anything: the same list every time, all rooms and all kinds in it, each
mistake in one line of code, and no explanation of a mistake that cannot be made any more.

usage: mutants_test.py SOURCE_DIR
"""
import collections
import pathlib
import re
import subprocess
import sys

root = pathlib.Path(sys.argv[1])
count = 150
kinds = {"comparison", "one", "sign", "check", "argument", "rounding", "loop", "logic", "extreme", "end"}


def run(*arguments):
    return subprocess.run([sys.executable, root / "scripts" / "mutants", *arguments], capture_output=True, text=True, check=False)


def expect(holds, what):
    if not holds:
        sys.exit(f"scripts/mutants: {what}")


first = run("--list", "--count", str(count))
expect(first.returncode == 0, first.stderr)
expect(run("--list", "--count", str(count)).stdout == first.stdout, "the same seed gives two lists")
expect(run("--list", "--count", str(count), "--seed", "2").stdout != first.stdout, "two seeds give one list")

mutants = re.findall(r"^((?:lib|cli)/\S+\.cpp):(\d+): (\w+)\n    (.*)\n  → (.*)$", first.stdout, re.M)
expect(len(mutants) == count, f"{len(mutants)} mistakes, not {count}")
expect({kind for _, _, kind, _, _ in mutants} == kinds, "a kind of mistake is missing")
rooms = collections.Counter("cli" if path.startswith("cli/") else path.split("/")[2] for path, *_ in mutants)
wanted = {path.name for path in (root / "lib" / "internode").iterdir() if any(path.glob("**/*.cpp"))} | {"cli"}
expect(wanted <= set(rooms), f"no mistake in {wanted - set(rooms)}")
expect(min(rooms[room] for room in wanted) >= 5, f"not spread evenly: {dict(rooms)}")
for path, line, _, before, after in mutants:
    stands = (root / path).read_text().splitlines()[int(line) - 1].strip()
    expect(stands == before and before != after, f"{path}:{line} is not that line")
    expect(not before.startswith(("//", "#", "assert(")), f"{path}:{line} is no statement")

explained = run("--check")
expect(explained.returncode == 0, explained.stdout + explained.stderr)
print(f"{count} mistakes in {len(rooms)} rooms; {explained.stdout.strip()}")
