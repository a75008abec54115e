#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The includes of lib/internode and cli: include_tree.py SOURCE-FOLDER

An include is an arrow between folders. No arrow goes up a floor, no folders include each other in a ring, no folder
holds more sources than a person surveys, and what internode.h includes, which is what gets installed, includes nothing
else of the library and nothing of the parsers. Every violation is printed as file:line and what is wrong.
"""

import re
import sys
from collections import defaultdict
from pathlib import Path

# docs/design.md, section "Rooms": the floors from the ground up. Rooms of one floor may use each other.
FLOORS = [
    ["text", "word"],
    ["algebra"],
    ["expression", "mask"],
    ["grammar"],
    ["interval"],
    ["spline"],
    ["stencil"],
    ["curve", "surface", "mesh"],
    ["point"],
    ["io"],
    ["input"],
    ["report"],
]
FLOOR_OF = {room: floor for floor, rooms in enumerate(FLOORS) for room in rooms}
FACE_FLOOR = len(FLOORS)
COMMAND_FLOOR = FACE_FLOOR + 1
MOST_SOURCES = 20
FACE = "internode/internode.h"
# What a program that includes the library must not have to install or to compile (docs/library.md).
HIDDEN_FROM_PROGRAMS = ("e-antic/", "tao/", "CLI/", "nlohmann/", "fmt/", "oneapi/", "tbb/")

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')


def sources(root):
    """Path below root -> file, for the library as an include names it and for the command."""
    found = {}
    for folder, prefix in ((root / "lib" / "internode", root / "lib"), (root / "cli", root)):
        for file in sorted(folder.rglob("*")):
            if file.suffix in (".h", ".cpp"):
                found[file.relative_to(prefix).as_posix()] = file
    return found


def includes(file):
    """(line, target, quoted) of each include of a file."""
    for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
        if match := INCLUDE.match(line):
            yield number, match[2], match[1] == '"'


def folder_of(name):
    return name.rsplit("/", 1)[0]


def floor_of(name):
    """The floor of a file, None where the table of floors does not know its room."""
    parts = name.split("/")
    if parts[0] == "cli":
        return COMMAND_FLOOR
    if len(parts) == 2:  # lib/internode itself: the version on the ground, the face above everything but the command
        return 0 if parts[1].startswith("version.") else FACE_FLOOR
    return FLOOR_OF.get(parts[1])


def arrows_up(graph):
    for name, targets in graph.items():
        floor = floor_of(name)
        if floor is None:
            yield f"{name}: this room stands on no floor"
            continue
        for line, target in targets:
            above = floor_of(target)
            if above is not None and above > floor:
                yield f"{name}:{line}: an arrow up, to {target}"


def rings(graph):
    """Folders that include each other, however many steps lie between: each strongly connected set once (Tarjan)."""
    arrows = defaultdict(dict)
    for name, targets in graph.items():
        for line, target in targets:
            if folder_of(target) != folder_of(name):
                arrows[folder_of(name)].setdefault(folder_of(target), f"{name}:{line} includes {target}")
    order, low, stack, components = {}, {}, [], []

    def visit(folder):
        order[folder] = low[folder] = len(order)
        stack.append(folder)
        for target in arrows.get(folder, {}):
            if target not in order:
                visit(target)
                low[folder] = min(low[folder], low[target])
            elif target in stack:
                low[folder] = min(low[folder], order[target])
        if low[folder] == order[folder]:
            component = set(stack[stack.index(folder):])
            del stack[stack.index(folder):]
            components.append(component)

    for folder in sorted({folder_of(name) for name in graph}):
        if folder not in order:
            visit(folder)
    for component in components:
        if len(component) > 1:
            yield "these folders include each other: " + ", ".join(sorted(component)) + "".join(
                f"\n    {arrows[a][b]}" for a in sorted(component) for b in sorted(component) if b in arrows.get(a, {}))


def crowded(graph):
    count = defaultdict(int)
    for name in graph:
        if name.endswith(".cpp"):
            count[folder_of(name)] += 1
    for folder, number in sorted(count.items()):
        if number > MOST_SOURCES:
            yield f"{folder}: {number} sources, more than {MOST_SOURCES}"


def leaks(found):
    """What a program would meet behind internode.h that is not installed or not for it."""
    if FACE not in found:
        yield f"{FACE} is missing"
        return
    face = {target for _, target, quoted in includes(found[FACE]) if quoted} | {FACE}
    for name in sorted(face):
        if name not in found:
            yield f"{FACE}: includes {name}, which is not there"
            continue
        for line, target, _ in includes(found[name]):
            if target.startswith("internode/") and target not in face:
                yield f"{name}:{line}: an installed header includes {target}, which {FACE} does not"
            if target.startswith(HIDDEN_FROM_PROGRAMS):
                yield f"{name}:{line}: an installed header includes {target}"


def main():
    found = sources(Path(sys.argv[1]))
    graph = {name: [(line, target) for line, target, quoted in includes(file) if quoted and target in found]
             for name, file in found.items()}
    violations = [*arrows_up(graph), *rings(graph), *crowded(graph), *leaks(found)]
    print("\n".join(violations))
    arrows = sum(len(targets) for targets in graph.values())
    print(f"{len(graph)} files, {arrows} includes, {len(violations)} violations")
    if not graph or not arrows:
        sys.exit("nothing was read")
    sys.exit(1 if violations else 0)


if __name__ == "__main__":
    main()
