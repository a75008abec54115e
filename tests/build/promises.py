#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks that every test which docs/promises.md names exists: `Suite.Name` in the tests' sources, `room/name` in CMake.

usage: promises.py SOURCE_DIR
"""
import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1])
sources = "\n".join(path.read_text() for path in (root / "tests").rglob("*.cpp"))
known = {f"{suite}.{name}" for suite, name in re.findall(r"^TEST(?:_F|_P)?\((\w+),\s*(\w+)\)", sources, re.M)}
build = "\n".join(path.read_text() for path in (root / "tests").rglob("CMakeLists.txt"))
named = re.findall(r"`([A-Z]\w*\.[A-Z]\w*|[a-z]+/[a-z_]+)`", (root / "docs" / "promises.md").read_text())
missing = [name for name in named if name not in known and not ("/" in name and name.split("/")[1] in build)]
rows = re.findall(r"^\| P\d+ \|.*$", (root / "docs" / "promises.md").read_text(), re.M)
bare = [row[:40] for row in rows if not re.search(r"`[A-Z]\w*\.[A-Z]|`[a-z]+/[a-z_]+`", row)]
for name in missing:
    print(f"docs/promises.md names a test that does not exist: {name}")
for row in bare:
    print(f"docs/promises.md has a promise without a test: {row}")
print(f"{len(named)} tests named, {len(missing)} missing, {len(bare)} promises without a test")
sys.exit(1 if missing or bare or not named else 0)
